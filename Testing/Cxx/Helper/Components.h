// SPDX-License-Identifier: BSD-3-Clause
#ifndef Components_h
#define Components_h

#include "Carver.h"
#include "Mesh.h"

#include <vector>

/**
 * Per step, the components of M, the solid and the tetrahedra that are not carved, as a point set:
 * counted by putting the tetrahedra back in reverse order.
 */
std::vector<int> CountComponents(
  const carving::Tetrahedralization& mesh, const carving::Stream& stream);

#endif
