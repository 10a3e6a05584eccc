// SPDX-License-Identifier: BSD-3-Clause
#include "Profile.h"

#include "Faces.h"

#include <numeric>

namespace carving
{
namespace
{

/** One more during [birth, death), as differences that a prefix sum turns into counts. */
void Count(std::vector<int>& differences, int birth, int death)
{
  if (birth < death)
  {
    ++differences[birth];
    if (death != Stream::Never)
    {
      --differences[death];
    }
  }
}

} // namespace

Profile ComputeProfile(const Tetrahedralization& mesh, const Stream& stream)
{
  Profile profile;
  profile.Vertices.assign(stream.StepPriority.size(), 0);
  profile.Triangles.assign(stream.StepPriority.size(), 0);
  // A vertex shows on C_j while some face around it does.
  const std::size_t numberOfPoints = mesh.Surface.Points.size();
  std::vector<int> birth(numberOfPoints, Stream::Never);
  std::vector<int> death(numberOfPoints, 0);
  ForEachFace(mesh, stream,
    [&](const FaceLife& face)
    {
      Count(profile.Triangles, face.Birth, face.Death);
      for (const int vertex : mesh.OutwardFace(face.Cell, face.Corner))
      {
        birth[vertex] = std::min(birth[vertex], face.Birth);
        death[vertex] = std::max(death[vertex], face.Death);
      }
    });
  for (std::size_t vertex = 0; vertex < numberOfPoints; ++vertex)
  {
    Count(profile.Vertices, birth[vertex], death[vertex]);
  }
  for (std::vector<int>* counts : { &profile.Vertices, &profile.Triangles })
  {
    std::partial_sum(counts->begin(), counts->end(), counts->begin());
  }
  return profile;
}

} // namespace carving
