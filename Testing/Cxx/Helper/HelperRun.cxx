// SPDX-License-Identifier: BSD-3-Clause
#include "HelperRun.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

/** The arguments that SetHelperCommand gives the helper program, for a shell. */
std::string ArgumentsFor(const std::string& job, const std::string& reply)
{
#ifdef TOPOLOGYCARVING_PORTABLE
  return "\"" + job + "\" \"" + reply + "\" > /dev/null";
#else
  return "< \"" + job + "\" > \"" + reply + "\"";
#endif
}

} // namespace

HelperRun RunHelper(const std::string& input)
{
  // A unique name, since tests may run in parallel.
  const std::string folder = testing::TempDir() + "carving-helper-test-" + std::to_string(getpid());
  std::filesystem::create_directory(folder);
  const std::string job = folder + "/job", reply = folder + "/reply";
  std::ofstream(job, std::ios::binary) << input;
  const std::string command =
    "\"" CARVING_HELPER "\" " + ArgumentsFor(job, reply) + " 2> /dev/null";
  const int status = std::system(command.c_str());

  HelperRun run;
  run.ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  std::ifstream in(reply, std::ios::binary);
  run.Output.assign(std::istreambuf_iterator<char>(in), {});
  run.Mistake = carving::Read(run.Output.data(), run.Output.size(), run.Reply);
  std::filesystem::remove_all(folder);
  return run;
}

HelperRun RunHelper(const carving::Job& job)
{
  return RunHelper(ToBytes(job));
}

HelperRun RunHelper(const carving::TriangleMesh& mesh, carving::JobKind kind)
{
  carving::Job job;
  job.Kind = kind;
  job.Mesh = mesh;
  return RunHelper(job);
}

carving::Reply GetReply(const carving::Job& job)
{
  HelperRun run = RunHelper(job);
  if (!run.Succeeded())
  {
    throw std::runtime_error("carving-helper: " + run.Mistake + run.Reply.Error);
  }
  return std::move(run.Reply);
}

carving::Reply GetReply(const carving::TriangleMesh& mesh)
{
  carving::Job job;
  job.Mesh = mesh;
  return GetReply(job);
}

carving::Reply GetReply(const carving::TriangleMesh& mesh, carving::Conformity conformity,
  double tolerance, carving::InitialApproximation initial)
{
  carving::Job job;
  job.EnclosingTolerance = tolerance;
  job.Mesh = mesh;
  job.Initial = initial;
  job.Conformity = conformity;
  return GetReply(job);
}
