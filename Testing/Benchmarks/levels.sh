#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/Benchmarks/levels.sh [MESH.off...]
#
# Compares simplified levels of meshes (by default of an elephant, from a Debian package) with CGAL's alpha wrap and
# VTK's quadric decimation at equal numbers of vertices, and prints a table.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

require_packages "${build_packages[@]}" "${picture_packages[@]}" libgtest-dev python3-numpy
targets="carve carving-helper alpha-wrap" build benchmark -DTOPOLOGYCARVING_PEERS=ON

meshes=("$@")
[ $# -gt 0 ] || meshes=("$(cgal_mesh elephant.off)")
/usr/bin/python3 "$root/Testing/Benchmarks/compare_levels.py" \
  "$build_root/benchmark/bin/carve" "$build_root/benchmark/bin/alpha-wrap" "${meshes[@]}"
