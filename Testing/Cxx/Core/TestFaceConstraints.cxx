// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Mesh/FaceConstraints.h"
#include "Core/Mesh/Validity.h"
#include "SmallMeshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace carving;
using namespace small;

namespace
{

/** Random facets of random numbers of cells are found again, face by face and cell by cell. */
template <int D>
void CheckTables()
{
  using Facets = typename FaceConstraints<D>::Facets;
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i)
  {
    const int oneIn = 1 + static_cast<int>(random() % 6);
    std::vector<Facets> table(random() % 40);
    for (Facets& facets : table)
    {
      for (int& facet : facets)
      {
        facet = random() % oneIn == 0 ? static_cast<int>(random() % 1000) : -1;
      }
    }
    const FaceConstraints<D> constraints(table);
    ASSERT_EQ(constraints.NumberOfCells, static_cast<int>(table.size()));
    for (int cell = 0; cell < constraints.NumberOfCells; ++cell)
    {
      EXPECT_EQ(constraints.Get(cell), table[cell]);
      for (int f = 0; f <= D; ++f)
      {
        EXPECT_EQ(constraints.Get(cell, f), table[cell][f]);
        EXPECT_EQ(constraints.Has(cell, f), table[cell][f] >= 0);
      }
    }
  }
}

} // namespace

// The facets of tetrahedra are those of the table from which they were made.
TEST(FaceConstraints, HoldATableOfTetrahedra)
{
  CheckTables<3>();
}

// The facets of triangles are those of the table from which they were made.
TEST(FaceConstraints, HoldATableOfTriangles)
{
  CheckTables<2>();
}

// Bits, counts and facets that do not belong together are found as a mistake.
TEST(FaceConstraints, AreCheckedForConsistency)
{
  const auto mistakeAfter = [](const std::function<void(FaceConstraints<3>&)>& change)
  {
    Tetrahedralization mesh = HollowTetrahedron();
    change(mesh.Constraints);
    return FindMistake(mesh);
  };
  EXPECT_EQ(mistakeAfter([](FaceConstraints<3>&) {}), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.OfFaces.pop_back(); }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.OfFaces.back() = 8; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.OfFaces.back() = -1; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.Blocks[0].Faces ^= 1; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.Blocks.back().Faces ^= 1u << 31; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { ++c.Blocks.back().Before; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.Blocks.push_back({ 0, 8 }); }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { ++c.NumberOfCells; }), "");
  EXPECT_NE(mistakeAfter([](FaceConstraints<3>& c) { c.NumberOfCells = -1; }), "");
}
