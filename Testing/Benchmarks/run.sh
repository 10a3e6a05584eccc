#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/Benchmarks/run.sh [--large] [--repetitions N] [--output FOLDER] [MESH...]
#
# Measures the stages of carve on generated meshes from 1,000 to 200,000 vertices, on real ones from Debian packages and
# on MESHes (OFF, PLY, OBJ, STL, also gzipped), beside TetGen, CGAL's alpha wrap and VTK's decimations. Writes RESULTS.md
# and growth.svg to FOLDER, by default build/results; Testing/Benchmarks has those that are kept. N is 3 by default.
# --large adds generated meshes of up to two million vertices. By the bytes per tetrahedron of smaller ones, they need
# about 20 GiB of memory.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../setup.sh"

command="bash Testing/Benchmarks/run.sh"
sizes=(1000 2000 5000 10000 20000 50000 100000 200000)
repetitions=3
output=$build_root/results
meshes=()
while [ $# -gt 0 ]; do
  case $1 in
    --large) sizes+=(500000 1000000 2000000); command+=" --large" ;;
    --repetitions) repetitions=$2; command+=" --repetitions $2"; shift ;;
    --output) output=$2; shift ;;
    --*) die "usage: bash Testing/Benchmarks/run.sh [--large] [--repetitions N] [--output FOLDER] [MESH...]" ;;
    *)
      [ -r "$1" ] || die "There is no file '$1' that can be read."
      meshes+=("$1")
      command+=" $(basename "$1")"
      ;;
  esac
  shift
done

require_packages "${build_packages[@]}" "${picture_packages[@]}" libgtest-dev python3-matplotlib python3-numpy tetgen
targets="carve carving-helper carving-model alpha-wrap" build benchmark -DTOPOLOGYCARVING_PEERS=ON
bash "$root/Testing/fetch_meshes.sh" "$build_root/meshes/off"

say "Making models"
models=$build_root/meshes/models
mkdir -p "$models"
generated=()
for kind in bumpy-torus tree; do
  for size in "${sizes[@]}"; do
    generated+=("$models/$kind-$size.ply")
    "$build_root/benchmark/bin/carving-model" "$kind:$size" "${generated[-1]}"
  done
done

say "Measuring"
PYTHONPATH=$root/Examples/Python /usr/bin/python3 "$root/Testing/Benchmarks/benchmark.py" \
  --programs "$build_root/benchmark/bin" --root "$root" --output "$output" --command "$command" \
  --repetitions "$repetitions" "${generated[@]}" "$build_root"/meshes/off/*.off ${meshes[@]+"${meshes[@]}"}
printf 'page  %s\n' "$output/RESULTS.md"
