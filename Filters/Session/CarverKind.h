// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The differences between carving meshes (D = 3) and contours in a plane (D = 2).
 */
#ifndef CarverKind_h
#define CarverKind_h

#include "Convert/CarverInput.h"
#include "Convert/ContourInput.h"
#include "Core/Protocol/Protocol.h"

#include <string>
#include <utility>

/**
 * - Input: the input as the core needs it.
 * - GatherInitial: gathers the mesh for InitialApproximation::Custom. Returns an empty string, or
 *   an error.
 * - GetResult: the decomposition in a reply of the helper program.
 * - IsWithoutSolid: whether the solid has been dropped from it.
 * - Fill: moves the input into a job for the helper program.
 */
template <int D>
struct Kind;

template <>
struct Kind<3>
{
  using Input = CarverInput;
  static std::string GatherInitial(vtkPolyData* initial, const Input&, Input& gathered)
  {
    return gathered.Gather(initial);
  }
  static const carving::Decomposition<3>& GetResult(const carving::Reply& reply)
  {
    return reply.Result;
  }
  static bool IsWithoutSolid(const carving::Reply& reply)
  {
    return !reply.Regions.SolidRegions.empty();
  }
  static void Fill(carving::Job& job, Input& input, Input& initial)
  {
    job.Kind = carving::JobKind::Tetrahedralize;
    job.Mesh = std::move(input.Mesh);
    job.InitialMesh = std::move(initial.Mesh);
  }
};

template <>
struct Kind<2>
{
  using Input = ContourInput;
  static std::string GatherInitial(vtkPolyData* initial, const Input& input, Input& gathered)
  {
    return gathered.GatherInPlaneOf(input, initial);
  }
  static const carving::Decomposition<2>& GetResult(const carving::Reply& reply)
  {
    return reply.Plane;
  }
  static bool IsWithoutSolid(const carving::Reply&)
  {
    return false;
  }
  static void Fill(carving::Job& job, Input& input, Input& initial)
  {
    job.Kind = carving::JobKind::Triangulate;
    job.Contours = std::move(input.Contours);
    job.InitialContours = std::move(initial.Contours);
  }
};

#endif
