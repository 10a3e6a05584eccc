// SPDX-License-Identifier: BSD-3-Clause
#include "Carving.h"
#include "Core/Carving/Carver.h"

#include "Core/Measure/StreamTopology.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

using namespace carving;

namespace
{

/** One of `count` possibilities: the multiples of `unit` from 0 on, and the largest double. */
double DrawUpToHuge(Bytes& bytes, int count, double unit)
{
  const int drawn = bytes.Below(count);
  return drawn + 1 < count ? unit * drawn : std::numeric_limits<double>::max();
}

CarveOptions DrawOptions(Bytes& bytes, std::size_t numberOfCells)
{
  CarveOptions options;
  options.Measure = static_cast<PriorityMeasure>(bytes.Below(5));
  options.DepthExponent = DrawUpToHuge(bytes, 6, 0.5);
  options.BreadthRadius = DrawUpToHuge(bytes, 8, 0.3);
  options.CarveExposed = bytes.Bit();
  options.CarveVoids = bytes.Bit();
  if (bytes.Bit())
  {
    for (std::size_t i = 0; i < numberOfCells; ++i)
    {
      options.Depths.push_back(0.01 + bytes.Below(8));
    }
  }
  if (bytes.Bit())
  {
    for (int& limit : options.Budget)
    {
      limit = bytes.Below(5) - 1;
    }
  }
  return options;
}

} // namespace

template <int D>
Carving<D> CarveWith(Bytes& bytes, const Decomposition<D>& mesh)
{
  Carving<D> result;
  const Classification regions = Classify(mesh, static_cast<SolidRule>(bytes.Below(3)));
  const CarveOptions options = DrawOptions(bytes, mesh.Cells.size());
  result.Budget = options.Budget;
  Stream& stream = result.Order;
  Carve(mesh, regions, options, stream);
  result.Stored = Store(mesh, regions, stream);
  result.Stored.Measure = options.Measure;
  result.Stored.Folds = bytes.Bit() ? FoldSides::Both : FoldSides::One;
  result.Profile = ComputeProfile(result.Stored);
  static_cast<StreamTopology&>(result.Profile) = ComputeTopology(mesh, regions, stream);
  const int last = result.Profile.LastStep();
  result.Steps = SpreadLevels(result.Profile, 1 + bytes.Below(5));
  for (const LevelTarget type :
    { LevelTarget::Vertices, LevelTarget::Triangles, LevelTarget::FeatureSize, LevelTarget::Step })
  {
    GetTargetRange(result.Profile, type);
    result.Steps.push_back(SelectStep(result.Profile, type, bytes.Double()).Step);
  }
  Require(std::all_of(
    result.Steps.begin(), result.Steps.end(), [last](int s) { return 0 <= s && s <= last; }));
  return result;
}

template Carving<2> CarveWith<2>(Bytes&, const Decomposition<2>&);
template Carving<3> CarveWith<3>(Bytes&, const Decomposition<3>&);

void Require(bool holds)
{
  if (!holds)
  {
    std::abort();
  }
}
