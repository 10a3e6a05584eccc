// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/ObstacleSearch.h"

#include "Core/Mesh/Box.h"

namespace carving::helper
{
namespace
{

/** Of more triangles, the tree passes over most, but a pass over copies does not. */
constexpr std::size_t MostCopies = 256;

} // namespace

void ObstacleSearch::MoveTo(const Box& region)
{
  if (this->HasCopies && this->Region.Contains(region))
  {
    return;
  }
  this->Copies.clear();
  this->Region = region;
  this->HasCopies = !this->Tree.AnyOverlap(region,
    [this](int t)
    {
      const auto corners = this->Tree.GetItems().CornersOf(t);
      this->Copies.push_back({ BoxAround(corners), corners, t });
      return this->Copies.size() > MostCopies;
    });
}

} // namespace carving::helper
