// SPDX-License-Identifier: AGPL-3.0-or-later
/**
 * @file
 * The CGAL kernels of the helper program: Inexact decides exactly and constructs in double,
 * Exact constructs exactly too.
 */
#ifndef carving_Kernels_h
#define carving_Kernels_h

#include "Core/Mesh/Mesh.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

inline Inexact::Point_3 ToInexact(const carving::Point& p)
{
  return { p[0], p[1], p[2] };
}

inline Exact::Point_3 ToExact(const carving::Point& p)
{
  return { p[0], p[1], p[2] };
}

#endif
