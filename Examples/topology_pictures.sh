#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Examples/topology_pictures.sh [FOLDER]
#
# Installs the required packages, builds the project, and renders the pictures of Filters/TOPOLOGY.md to FOLDER
# (by default Examples/images).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

require_packages "${build_packages[@]}" "${picture_packages[@]}" "${test_packages[@]}"
# The program that generates the models is built with the tests.
build gallery-build -DBUILD_TESTING=ON

folder=${1:-$root/Examples/images}
models=$build_root/meshes/models
program=$build_root/gallery-build
mkdir -p "$folder" "$models"
"$program/bin/carving-model" scone "$models/scone.off"
cheese=$(cgal_mesh cheese.off)

say "Rendering"
PYTHONPATH=$program/lib/python3/dist-packages \
  xvfb-run -a /usr/bin/python3 "$root/Examples/Python/topology_pictures.py" \
  "$cheese" "$models/scone.off" "$folder"
xvfb-run -a "$program/bin/carve" "$cheese" --levels 1 --profile "$folder/topology-profile.png" >/dev/null

say "Done"
printf 'pictures  %s\n' "$folder"/topology-*.png
