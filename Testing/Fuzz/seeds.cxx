// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * fuzz-seeds FOLDER: writes the initial corpora of the fuzz targets to FOLDER/core, FOLDER/extract
 * and FOLDER/protocol.
 */
#include "Core/Protocol/Protocol.h"
#include "Decompositions.h"
#include "Shapes.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

using namespace carving;

namespace
{

std::string RandomBytes(std::size_t size, std::mt19937_64& random)
{
  std::string bytes;
  for (std::size_t i = 0; i < size; ++i)
  {
    bytes += static_cast<char>(random());
  }
  return bytes;
}

template <class Message>
std::string Written(const Message& message)
{
  std::ostringstream out;
  Write(out, message);
  return out.str();
}

template <int D>
Decomposition<D> MakeRandom(std::mt19937_64& random)
{
  const std::string drawn = RandomBytes(200, random);
  Bytes bytes(reinterpret_cast<const std::uint8_t*>(drawn.data()), drawn.size());
  return MakeDecomposition<D>(bytes);
}

Job MakeJob(int i)
{
  Job job;
  job.Kind = static_cast<JobKind>(1 + i % 3);
  job.Initial = static_cast<InitialApproximation>(i / 3 % 3);
  job.Conformity = static_cast<Conformity>(i / 9 % 3);
  job.TimeLimit = i;
  job.Mesh = models::Box({ 0, 0, 0 }, { 1, 1, 1 });
  job.InitialMesh = models::Tetrahedron();
  job.Contours = { job.Mesh.Points, { { 0, 1 }, { 1, 2 } } };
  return job;
}

Reply MakeReply(int i, std::mt19937_64& random)
{
  Reply reply;
  if (i % 3 == 0)
  {
    reply.Plane = MakeRandom<2>(random);
  }
  else
  {
    reply.Result = MakeRandom<3>(random);
  }
  reply.Error = i % 16 == 0 ? "an error" : "";
  reply.Strategy = "a strategy";
  reply.Attempts = "one\nanother\n";
  reply.Limits = "a limit\n";
  reply.StageSeconds.assign(NumberOfStages, 0.5);
  return reply;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::mt19937_64 random(1);
  const auto write = [&](const char* target, int i, const std::string& bytes)
  {
    std::filesystem::create_directories(folder / target);
    std::ofstream(folder / target / std::to_string(i), std::ios::binary) << bytes;
  };
  for (int i = 0; i < 64; ++i)
  {
    write("core", i, static_cast<char>(i) + RandomBytes(8 << i % 6, random));
    write("extract", i, static_cast<char>(i) + RandomBytes(8 << i % 6, random));
    write("protocol", 3 * i, '\0' + Written(MakeJob(i)));
    write("protocol", 3 * i + 1, '\1' + RandomBytes(63, random) + Written(MakeReply(i, random)));
    write("protocol", 3 * i + 2,
      '\2' + ProgressLine({ static_cast<Stage>(i % NumberOfStages), i / 64.0, "TetGen" }));
  }
  return 0;
}
