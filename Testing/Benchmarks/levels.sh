#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/Benchmarks/levels.sh [MESH.off...]
#
# Compares simplified levels of meshes (by default bones, an elephant and a piece of cheese from a Debian package, and a
# tree that is made by code) with CGAL's alpha wrap and VTK's quadric decimation at equal numbers of vertices. Prints a
# table, and draws pictures to build/levels/index.html.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

require_packages "${build_packages[@]}" "${picture_packages[@]}" libgtest-dev python3-numpy
targets="carve carving-helper carving-model alpha-wrap" build benchmark -DTOPOLOGYCARVING_PEERS=ON

meshes=("$@")
if [ $# -eq 0 ]; then
  for name in bones.off elephant.off cheese.off; do
    meshes+=("$(cgal_mesh "$name")")
  done
  "$build_root/benchmark/bin/carving-model" tree "$build_root/meshes/tree.off"
  meshes+=("$build_root/meshes/tree.off")
fi
PYTHONPATH=$root/Examples/Python \
  xvfb-run -a /usr/bin/python3 "$root/Testing/Benchmarks/compare_levels.py" \
  "$build_root/benchmark/bin/carve" "$build_root/benchmark/bin/alpha-wrap" "$build_root/levels" "${meshes[@]}"
printf 'pictures  %s\n' "$build_root/levels/index.html"
