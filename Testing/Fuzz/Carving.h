// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A decomposition carved with settings drawn from bytes.
 */
#ifndef Carving_h
#define Carving_h

#include "Bytes.h"
#include "Core/Measure/LevelSelection.h"
#include "Core/Mesh/BettiNumbers.h"
#include "Core/Stream/StoredStream.h"

template <int D>
struct Carving
{
  carving::BettiNumbers Budget;
  carving::Stream Order; ///< of all cells; `Stored` may lack the cells of the solid
  carving::StoredStream<D> Stored;
  carving::Profile Profile;
  std::vector<int> Steps; ///< of the levels
};

/** Classifies the regions, carves, and picks levels. */
template <int D>
Carving<D> CarveWith(Bytes& bytes, const carving::Decomposition<D>& mesh);

/** Aborts the program, which the fuzzer reports, if a condition does not hold. */
void Require(bool holds);

#endif
