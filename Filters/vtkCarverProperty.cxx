// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCarverProperty.h"

#include "vtkCarverAlgorithm.h"

#include <sstream>
#include <type_traits>

namespace
{

template <class Value>
constexpr bool IsIntegral(Value (vtkCarverAlgorithm::*)())
{
  return std::is_integral_v<Value>;
}

/** The members from Name to IsInteger. */
// clang-format off
#define NAMED(name) \
  #name, \
  [](vtkCarverAlgorithm* carver) { return static_cast<double>(carver->Get##name()); }, \
  [](vtkCarverAlgorithm* carver, double value) \
  { carver->Set##name(static_cast<decltype(carver->Get##name())>(value)); }, \
  IsIntegral(&vtkCarverAlgorithm::Get##name)
// clang-format on

const std::vector<std::string> Switch = { "Off", "On" };
const std::vector<std::string> NoChoices;

constexpr bool Stored = true;
/** The stream stores the value itself, or does not depend on it. */
constexpr bool NotStored = false;

std::vector<vtkCarverProperty> MakeProperties()
{
  return {
    { NAMED(InitialApproximation), { "CONVEX_HULL", "BOUNDING_BOX", "CUSTOM" }, 0, 0, Stored,
      "Level 0: the convex hull of the mesh, its bounding box, or the mesh of --initial-mesh. The "
      "box is grown by a hundredth of its diagonal on every side; its corners are new vertices. "
      "(Section 3.1)" },
    { NAMED(Conformity), { "EXACT", "ENCLOSING", "AUTO" }, 0, 0, Stored,
      "How a mesh is treated that TetGen cannot tetrahedralize. exact: as an error. enclosing: "
      "TetGen is not used for any mesh; all levels enclose the mesh, and the last one is not the "
      "mesh itself. auto: exact, and enclosing where exact fails." },
    { NAMED(Strategy), { "TETGEN", "RECOVER", "AUTO" }, 0, 0, NotStored,
      "How the mesh's triangles become faces of tetrahedra: by TetGen, by recovery in a Delaunay "
      "tetrahedralization, or by both: recovery first where it is faster, or else where TetGen "
      "fails, on meshes that do not cross themselves." },
    { NAMED(EnclosingTolerance), NoChoices, 0.0, 1.0, Stored,
      "The distance that the uncarvable tetrahedra may reach from a mesh that is only enclosed, as "
      "a share of the mesh's diagonal. Vertices are added until the limit holds. 0: no vertex is "
      "added." },
    { NAMED(SnapTolerance), NoChoices, 0.0, 1.0, Stored,
      "The distance that points may be moved where the mesh cannot be tetrahedralized as given, as "
      "a share of the mesh's diagonal, so that parts that nearly touch do touch. The snapped mesh "
      "then takes the place of the mesh. The default removes roundings. 0: no point is moved. "
      "Worth a try if parts nearly touch: 1e-6." },
    { NAMED(TimeLimit), NoChoices, 0.0, VTK_DOUBLE_MAX, NotStored,
      "The wall-clock time that one attempt at a tetrahedralization may take, in seconds. 0: a "
      "limit that is rarely reached. With auto conformity, all exact attempts together get 10 s "
      "and 0.1 ms per triangle of processor time, or this time if it is more." },
    { NAMED(MemoryLimit), NoChoices, 0.0, VTK_DOUBLE_MAX, NotStored,
      "The memory that one attempt at a tetrahedralization may take, in MiB. 0: no limit. "
      "Without effect in the portable build." },
    { NAMED(SolidRule), { "NONZERO_WINDING", "EVEN_ODD", "SURFACE_ONLY" }, 0, 0, Stored,
      "The solid part of the space that the mesh encloses: where the winding number is at least "
      "one half in magnitude, where an odd number of surfaces lies between a point and the "
      "outside, or nowhere." },
    { NAMED(PriorityMeasure),
      { "LONGEST_EDGE", "VOLUME", "CIRCUMRADIUS", "EDGE_VOLUME", "EDGE_DISTANCE", "AUTO_MEASURE" },
      0, 0, NotStored,
      "The tetrahedra that are carved first: those with the longest edge, the largest volume, the "
      "largest circumscribed sphere, the largest geometric mean of the longest edge and the cube "
      "root of the volume, or the largest product of the longest edge and the square of the "
      "distance from the mesh. "
      "auto-measure: the last one with --simplify, else the first. (Section 4)" },
    { NAMED(DepthExponent), NoChoices, 0.0, VTK_DOUBLE_MAX, Stored,
      "Divides every priority by the depth to the power of this number, so that carving advances "
      "more evenly from all sides. (Section 5.3)" },
    { NAMED(DepthMeasure), { "HIERARCHY", "DISTANCE" }, 0, 0, Stored,
      "The depth of a tetrahedron: the number of tetrahedra on the way from level 0, or the "
      "distance from level 0. (Section 5.3)" },
    { NAMED(BreadthRadius), NoChoices, 0.0, VTK_DOUBLE_MAX, Stored,
      "A step carves all tetrahedra within this distance of the first one, in the mesh's units. 0: "
      "one tetrahedron a step. (Section 5.4)" },
    { NAMED(CarveExposed), Switch, 0, 0, Stored,
      "Whether tetrahedra that lose more than one face to the exterior are carved in the same "
      "step, which saves triangles. (Section 3.4)" },
    { NAMED(CarveVoids), Switch, 0, 0, Stored,
      "Whether hollows that the mesh encloses are carved, too. (Section 3)" },
    { NAMED(MaximumComponents), NoChoices, -1, VTK_INT_MAX, Stored,
      "The largest number of connected components of any level. A tetrahedron that would exceed "
      "this limit is not carved, so that the last level may not be the mesh. With at most 1 "
      "component, 0 tunnels and 0 voids, the last level is a tight wrap of the mesh without gaps "
      "or holes. -1: no limit." },
    { NAMED(MaximumTunnels), NoChoices, -1, VTK_INT_MAX, Stored,
      "The largest number of tunnels of any level. -1: no limit." },
    { NAMED(MaximumVoids), NoChoices, -1, VTK_INT_MAX, Stored,
      "The largest number of voids (hollows) of any level. -1: no limit." },
    { NAMED(ComputeError), Switch, 0, 0, NotStored,
      "Whether the distance of every level from the mesh is computed, for the stream and the "
      "profile: the distance of the farthest point, never too small and at most 1 %, or a "
      "millionth of the diagonal, too large. The computation takes longer than carving. "
      "--error-bound implies it." },
    { NAMED(NumberOfThreads), NoChoices, 0, 1024, NotStored, "" },
    { NAMED(ReuseDecomposition), Switch, 0, 0, NotStored, "" },
    { NAMED(NumberOfLevels), NoChoices, 1, 1000, NotStored, "" },
    { NAMED(LevelTargetType),
      { "VERTICES", "TRIANGLES", "FEATURE_SIZE", "TUNNELS", "COMPONENTS", "ERROR_BOUND", "STEP" },
      0, 0, NotStored, "" },
    { NAMED(LevelSimplification), { "SUBSET", "ENCLOSING_COLLAPSE" }, 0, 0, NotStored, "" },
    { NAMED(MaximumVertices), NoChoices, 0, VTK_INT_MAX, NotStored,
      "With --simplify, the largest number of vertices of a level that --tunnels, --components, "
      "--feature-size or --step picks. 0: no limit." },
    { NAMED(KeepBothFoldSides), { "Off", "On", "AUTO" }, 0, 0, NotStored,
      "Whether a sheet without solid on either side shows with both of its sides, as a closed "
      "surface. auto: only if a maximum of components, tunnels or voids is set, or with "
      "--simplify. (Section 3.3)" },
    { NAMED(ManifoldOutput), Switch, 0, 0, NotStored,
      "Whether levels are cut apart where more than two triangles meet in an edge, or several fans "
      "of triangles in a vertex. (Section 3.3)" },
    { NAMED(AppendInput), Switch, 0, 0, NotStored,
      "Whether a mesh that is only enclosed follows as the last level." },
    { NAMED(OutputType), { "MULTIBLOCK", "PARTITIONED_COLLECTION" }, 0, 0, NotStored, "" },
  };
}

} // namespace

std::string vtkCarverProperty::GetText(vtkCarverAlgorithm* carver) const
{
  const double value = this->Get(carver);
  std::ostringstream text;
  if (!this->Choices.empty())
  {
    text << this->Choices[static_cast<std::size_t>(value)];
  }
  else if (this->IsInteger)
  {
    text << static_cast<int>(value);
  }
  else
  {
    text << value;
  }
  return text.str();
}

const std::vector<vtkCarverProperty>& vtkCarverProperty::GetAll()
{
  static const std::vector<vtkCarverProperty> properties = MakeProperties();
  return properties;
}
