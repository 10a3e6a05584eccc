// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solid/Winding.h"

#include "Core/Mesh/Vector.h"

#include <algorithm>
#include <utility>

namespace carving
{

double SolidAngle(const ResolvedMesh& mesh, std::size_t triangle, const Point& point)
{
  const Triangle& corner = mesh.Facets[triangle];
  const Point a = mesh.Points[corner[0]] - point;
  const Point b = mesh.Points[corner[1]] - point;
  const Point c = mesh.Points[corner[2]] - point;
  const double la = Length(a), lb = Length(b), lc = Length(c);
  // Van Oosterom and Strackee, "The solid angle of a plane triangle", 1983, equation (8).
  const double numerator = Dot(a, Cross(b, c));
  const double denominator = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  return 2.0 * std::atan2(numerator, denominator);
}

double WindingNumber(const ResolvedMesh& mesh, const Point& point)
{
  double angles = 0.0;
  for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
  {
    if (mesh.SignedMultiplicities[t] != 0)
    {
      angles += mesh.SignedMultiplicities[t] * SolidAngle(mesh, t, point);
    }
  }
  return angles / (4.0 * std::acos(-1.0));
}

double WindingNumber(const ResolvedInput<2>& contours, const Point& point)
{
  double angles = 0.0;
  for (std::size_t e = 0; e < contours.Facets.size(); ++e)
  {
    const auto& [from, to] = contours.Facets[e];
    const Point a = contours.Points[from] - point;
    const Point b = contours.Points[to] - point;
    angles += contours.SignedMultiplicities[e] *
      std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
  }
  return angles / (2.0 * std::acos(-1.0));
}

int CountCrossings(const ResolvedMesh& mesh, const Point& point)
{
  const Point direction = { 0.5377, 0.2913, 0.7912 };
  int count = 0;
  for (std::size_t t = 0; t < mesh.Facets.size(); ++t)
  {
    const Triangle& corner = mesh.Facets[t];
    const Point a = mesh.Points[corner[0]] - point;
    const Point b = mesh.Points[corner[1]] - point;
    const Point c = mesh.Points[corner[2]] - point;
    // The ray crosses the triangle if all edges pass it on the same side and the triangle lies
    // ahead.
    const double ab = Dot(direction, Cross(a, b)), bc = Dot(direction, Cross(b, c)),
                 ca = Dot(direction, Cross(c, a));
    const bool within = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    if (within && (Dot(a, Cross(b, c)) > 0) == (ab > 0))
    {
      count += mesh.Multiplicities[t];
    }
  }
  return count;
}

template <int D>
bool IsClosed(const ResolvedInput<D>& input)
{
  // Each ridge (in the plane, each end) of each facet, with the signed number of traversals.
  using Ridge = std::array<int, D - 1>;
  std::vector<std::pair<Ridge, int>> ridges;
  ridges.reserve(D * input.Facets.size());
  for (std::size_t f = 0; f < input.Facets.size(); ++f)
  {
    const std::array<int, D>& facet = input.Facets[f];
    for (int i = 0; i < D; ++i)
    {
      if constexpr (D == 3)
      {
        const int a = facet[i], b = facet[(i + 1) % 3];
        ridges.push_back({ { std::min(a, b), std::max(a, b) },
          a < b ? input.SignedMultiplicities[f] : -input.SignedMultiplicities[f] });
      }
      else
      {
        ridges.push_back({ { facet[i] },
          i == 0 ? -input.SignedMultiplicities[f] : input.SignedMultiplicities[f] });
      }
    }
  }
  std::sort(ridges.begin(), ridges.end());
  for (auto first = ridges.begin(); first != ridges.end();)
  {
    int sum = 0;
    auto last = first;
    for (; last != ridges.end() && last->first == first->first; ++last)
    {
      sum += last->second;
    }
    if (sum != 0)
    {
      return false;
    }
    first = last;
  }
  return true;
}

template bool IsClosed<2>(const ResolvedInput<2>&);
template bool IsClosed<3>(const ResolvedInput<3>&);

} // namespace carving
