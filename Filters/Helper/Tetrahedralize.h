// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_Tetrahedralize_h
#define carving_Tetrahedralize_h

#include "Mesh.h"

#include <string>

/**
 * Constrained Delaunay tetrahedralization of the convex hull of a resolved mesh, by TetGen and
 * without Steiner points on the surface: every triangle of the mesh is a face of it.
 *
 * Fills the other members of `result`, whose `Surface` is given, and appends Steiner points, all of
 * them off the surface. Returns an empty string or what went wrong. Where TetGen fails it may as
 * well end the process: its assertions are on, and it frees memory twice when it gives up.
 */
std::string Tetrahedralize(carving::Tetrahedralization& result);

#endif
