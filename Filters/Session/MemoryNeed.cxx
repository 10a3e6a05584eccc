// SPDX-License-Identifier: BSD-3-Clause
#include "Session/MemoryNeed.h"

#include "Core/Mesh/CornerPoints.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace
{

std::size_t CountVertices(const carving::TriangleMesh& mesh)
{
  std::vector<carving::Point> points = carving::CornerPoints(mesh);
  std::sort(points.begin(), points.end());
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

std::string AsText(double bytes)
{
  const double mebibytes = bytes / (1024.0 * 1024.0);
  char text[32];
  if (mebibytes < 10000.0)
  {
    std::snprintf(text, sizeof(text), "%.0f MiB", mebibytes);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f GiB", mebibytes / 1024.0);
  }
  return text;
}

} // namespace

MemoryNeed MemoryNeed::Estimate(
  double vertices, double triangles, const carving::HelperOptions& options)
{
  const bool usesTetGen = options.Conformity != carving::Conformity::Enclosing &&
    options.Strategy != carving::Strategy::Recover;
  MemoryNeed need;
  need.Host = 1460.0 * vertices;
  need.Helper =
    usesTetGen ? 3200.0 * vertices + 1400.0 * triangles : 1350.0 * vertices + 500.0 * triangles;
  return need;
}

double GetMemoryOfMachine()
{
  vtksys::SystemInformation system;
  return 1024.0 * static_cast<double>(system.GetHostMemoryAvailable("PV_HOST_MEMORY_LIMIT"));
}

std::string CheckMemory(const carving::Job& job)
{
  const double present = GetMemoryOfMachine();
  const auto needOf = [&job](std::size_t vertices)
  {
    return MemoryNeed::Estimate(
      static_cast<double>(vertices), static_cast<double>(job.Mesh.Triangles.size()), job);
  };
  // The program's peak has passed when the filter's begins.
  const auto isTooMuch = [present](const MemoryNeed& need)
  { return std::max(need.Host, need.Helper) > present; };
  if (job.MemoryLimit > 0.0 || present <= 0.0 || !isTooMuch(needOf(job.Mesh.Points.size())))
  {
    return {};
  }
  // Points may be repeated, one for each triangle, or belong to none. Counting others takes time.
  const std::size_t vertices = CountVertices(job.Mesh);
  const MemoryNeed need = needOf(vertices);
  if (!isTooMuch(need))
  {
    return {};
  }
  return "The mesh has " + std::to_string(vertices) + " vertices and " +
    std::to_string(job.Mesh.Triangles.size()) + " triangles: the helper program would need about " +
    AsText(need.Helper) + " of memory and this process " + AsText(need.Host) + ", but there are " +
    AsText(present) +
    ". Decimate the mesh first, carve its parts one by one, or use a machine with more memory. "
    "With "
    "Conformity ENCLOSING or Strategy RECOVER the helper program needs less than half. To try "
    "nevertheless, set MemoryLimit.";
}
