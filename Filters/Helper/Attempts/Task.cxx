// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Attempts/Task.h"

#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace carving::helper
{
namespace
{

template <class Value>
void WriteArray(std::ostream& out, const Value* values, std::uint64_t count)
{
  out.write(reinterpret_cast<const char*>(&count), sizeof(count));
  out.write(
    reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(Value)));
}

template <class Array>
void ReadArray(std::istream& in, Array& array)
{
  std::uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof(count));
  array.resize(in ? count : 0);
  in.read(reinterpret_cast<char*>(array.data()),
    static_cast<std::streamsize>(array.size() * sizeof(array[0])));
}

template <class Message>
void WriteMessage(std::ostream& out, const Message& message)
{
  std::ostringstream bytes;
  Write(bytes, message);
  const std::string text = bytes.str();
  WriteArray(out, text.data(), text.size());
}

/** Returns an empty string, or an error. */
template <class Message>
std::string ReadMessage(std::istream& in, Message& message)
{
  std::string text;
  ReadArray(in, text);
  return Read(text.data(), text.size(), message);
}

/** Visits all members of a surface. */
template <class Surface, class Visit>
void VisitSurface(Surface& surface, const Visit& visit)
{
  visit(surface.Points);
  visit(surface.PointSources);
  visit(surface.Facets);
  visit(surface.FacetSources);
  visit(surface.SignedMultiplicities);
  visit(surface.Multiplicities);
}

} // namespace

void WriteTask(std::ostream& out, const Task& task, const Job& job, Reply& reply)
{
  out.write(reinterpret_cast<const char*>(&task), sizeof(task));
  WriteMessage(out, job);
  // By itself, since a reply with a surface and no tetrahedra would be refused.
  ResolvedMesh surface = std::move(reply.Result.Surface);
  reply.Result.Surface = {};
  VisitSurface(surface, [&](const auto& array) { WriteArray(out, array.data(), array.size()); });
  WriteMessage(out, reply);
  reply.Result.Surface = std::move(surface);
}

void ReadTask(std::istream& in, Task& task, Job& job, Reply& reply)
{
  in.read(reinterpret_cast<char*>(&task), sizeof(task));
  std::string mistake = ReadMessage(in, job);
  ResolvedMesh surface;
  VisitSurface(surface, [&](auto& array) { ReadArray(in, array); });
  mistake += ReadMessage(in, reply);
  reply.Result.Surface = std::move(surface);
  if (!mistake.empty())
  {
    throw std::runtime_error("work for a child process could not be read: " + mistake);
  }
}

} // namespace carving::helper
