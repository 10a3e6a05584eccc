// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The CGAL kernels of the helper program. Both have exact predicates; Inexact constructs in
 * doubles, Exact constructs exactly.
 */
#ifndef carving_Kernels_h
#define carving_Kernels_h

#include "Core/Mesh/Mesh.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>

namespace carving::helper
{

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

inline Inexact::Point_3 ToInexact(const Point& p)
{
  return { p[0], p[1], p[2] };
}

/** The corners of a triangle. */
using Corners3 = std::array<Inexact::Point_3, 3>;

inline Corners3 ToInexact(const std::array<Point, 3>& corners)
{
  return { ToInexact(corners[0]), ToInexact(corners[1]), ToInexact(corners[2]) };
}

inline Exact::Point_3 ToExact(const Point& p)
{
  return { p[0], p[1], p[2] };
}

} // namespace carving::helper

#endif
