// SPDX-License-Identifier: AGPL-3.0-or-later
#ifndef carving_KeptDistances_h
#define carving_KeptDistances_h

namespace carving::helper
{

/** The distances from M of the points on exposed faces; 0 if no tetrahedron is pierced. */
struct KeptDistances
{
  double Maximum;      ///< to within 5 %, but at least the negligible distance
  double Percentile99; ///< of all but a hundredth of the area
  double Mean;         ///< over the area
};

} // namespace carving::helper

#endif
