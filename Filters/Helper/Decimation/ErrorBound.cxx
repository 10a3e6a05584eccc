// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/ErrorBound.h"

#include <algorithm>
#include <limits>

namespace carving::helper
{
namespace
{

/**
 * The most queries for one new face. A face that is still undecided then is refused.
 * Large faces above fine facets take some hundred. With 64, surfaces kept up to five times as many
 * vertices.
 */
constexpr long long MostQueries = 4000;

/**
 * Queries per face on average. Most faces take 5 to 30. Where large parts of faces are about as far
 * as the bound, every face would take the greatest number and still be turned away.
 */
constexpr long long MostQueriesOnAverage = 100;

/** So that the first faces may take the greatest number. */
constexpr long long QueriesSavedAtFirst = 100 * MostQueries;

} // namespace

ErrorBound::ErrorBound(const FaceDistance<3>& fromM, std::size_t numberOfEdges)
  : FromM(fromM)
  , Heights(fromM.GetTree().GetItems().GetMesh())
  , Excesses(numberOfEdges, 0.0)
  , SavedQueries(QueriesSavedAtFirst)
{
}

bool ErrorBound::Raise(double bound)
{
  const bool rises = bound > this->Bound;
  this->Bound = std::max(this->Bound, bound);
  return rises;
}

bool ErrorBound::Allows(SurfaceMesh::Edge_index edge, const Star& star, const Point& w)
{
  const double excess = this->FindExcess(star, w);
  double& least = this->Excesses[edge];
  if (excess > 0.0)
  {
    least = least > 0.0 ? std::min(least, excess) : excess;
  }
  return excess == 0.0;
}

void ErrorBound::ForgetAll()
{
  std::fill(this->Excesses.begin(), this->Excesses.end(), 0.0);
}

/** The distance of a point of the new faces that is too large, or 0 if there is none. */
double ErrorBound::FindExcess(const Star& star, const Point& w)
{
  if (this->Bound == std::numeric_limits<double>::infinity())
  {
    return 0.0;
  }
  const FacetTree<3>& tree = this->FromM.GetTree();
  const auto closest = tree.Find(w, this->Bound);
  if (closest.Distance > this->Bound)
  {
    return closest.Distance;
  }
  const FacetCorners<3> nearby = tree.GetItems().CornersOf(closest.Item);
  std::vector<FacetCorners<3>> faces;
  for (const auto& [a, b] : star.Link)
  {
    const FacetCorners<3> face = { a, b, w };
    if (!this->Heights.IsWithin(face, this->Bound, closest.Item))
    {
      faces.push_back(face);
    }
  }
  const auto count = static_cast<long long>(star.Link.size());
  this->SavedQueries += count * MostQueriesOnAverage;
  const long long most = std::min(count * MostQueries, this->SavedQueries);
  long long left = most;
  const double excess = this->FromM.FindFarther(faces, this->Bound, left, nearby);
  this->SavedQueries -= most - left;
  return excess;
}

} // namespace carving::helper
