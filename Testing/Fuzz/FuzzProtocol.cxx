// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fuzz target: the messages between a host and the helper program. An accepted message is written
 * back with equal bytes, an accepted reply can be carved, and its decimated surfaces exist.
 */
#include "Carving.h"
#include "Core/Carving/Carver.h"
#include "Core/Protocol/Protocol.h"
#include "Core/Stream/Level.h"
#include "Core/Surface/Manifold.h"

#include <cstdint>
#include <sstream>
#include <string>

using namespace carving;

namespace
{

/** Reads a message; returns whether it is accepted. */
template <class Message>
bool ReadBack(const Bytes& bytes, Message& message)
{
  if (!Read(bytes.Data(), bytes.Size(), message).empty())
  {
    return false;
  }
  std::ostringstream written;
  Write(written, message);
  Require(written.str() == std::string(bytes.Data(), bytes.Size()));
  return true;
}

template <int D>
void Carve(Bytes settings, const Decomposition<D>& mesh)
{
  if (mesh.Cells.empty())
  {
    return; // the reply has no cells of this dimension
  }
  const Carving<D> carved = CarveWith(settings, mesh);
  for (const int step : carved.Steps)
  {
    const Level<D> level = ExtractLevel(carved.Stored, step);
    Require(CutIntoManifold(carved.Stored, level).Faces.size() == level.Faces.size());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  constexpr std::size_t sizeOfSettings = 64;
  Bytes bytes(data, size);
  switch (bytes.Below(3))
  {
    case 0:
    {
      Job job;
      ReadBack(bytes, job);
      break;
    }
    case 1:
    {
      const Bytes settings(data, size < sizeOfSettings ? size : sizeOfSettings);
      for (std::size_t i = 1; i < sizeOfSettings; ++i)
      {
        bytes.Below(2);
      }
      Reply reply;
      if (ReadBack(bytes, reply))
      {
        Carve(settings, reply.Result);
        Carve(settings, reply.Plane);
        for (const DecimatedSurface& surface : reply.Decimation.Surfaces)
        {
          ExtractSurface(reply.Decimation.Chain, surface.Collapses);
        }
      }
      break;
    }
    default:
    {
      WorkProgress progress;
      if (ParseProgress(std::string(bytes.Data(), bytes.Size()), progress))
      {
        StageName(progress.Stage);
      }
      break;
    }
  }
  return 0;
}
