// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Helper/Decimation/ObstacleSearch.h"

#include "Core/Mesh/Box.h"

namespace carving::helper
{
namespace
{

/** To copy more triangles takes longer than to search the tree. */
constexpr std::size_t MostCopies = 4096;

} // namespace

void ObstacleSearch::MoveTo(const Box& region)
{
  if (this->HasCopies && this->Region.Contains(region))
  {
    return;
  }
  this->Copies.clear();
  this->Groups.clear();
  this->Region = region;
  this->HasCopies = !this->Tree.AnyOverlap(region,
    [this](int t)
    {
      const auto corners = this->Tree.GetItems().CornersOf(t);
      if (this->Copies.size() % GroupSize == 0)
      {
        this->Groups.emplace_back();
      }
      this->Copies.push_back({ BoxAround(corners), corners, t });
      this->Groups.back().Add(this->Copies.back().Bounds);
      return this->Copies.size() > MostCopies;
    });
}

} // namespace carving::helper
