#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Examples/gallery.sh [FOLDER [MESH...]]
#
# Installs the required packages, builds the project, generates models like those of the paper's figures and
# fetches meshes from a Debian package. Renders the levels of these meshes and of MESHes (OFF, PLY, OBJ, STL),
# together with a table of running times, to FOLDER/index.html (by default in build/gallery).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

require_packages "${build_packages[@]}" "${picture_packages[@]}" "${test_packages[@]}"
# The program that generates the models is built with the tests.
build gallery-build -DBUILD_TESTING=ON

folder=${1:-$build_root/gallery}
models=$build_root/meshes/models
program=$build_root/gallery-build
mkdir -p "$folder" "$models"

say "Generating models"
for name in $("$program/bin/carving-model" --list); do
  case $name in
    carved-figure | snaking-contour) extension=vtk ;;
    *) extension=off ;;
  esac
  "$program/bin/carving-model" "$name" "$models/$name.$extension"
done
meshes=("${@:2}")
for name in bones.off elephant.off cheese.off; do
  meshes+=("$(cgal_mesh "$name")")
done

say "Rendering"
PYTHONPATH=$program/lib/python3/dist-packages \
  xvfb-run -a /usr/bin/python3 "$root/Examples/Python/gallery.py" \
  --models "$models" --output "$folder" "${meshes[@]}"

say "Done"
printf 'gallery   %s\n' "$folder/index.html"
