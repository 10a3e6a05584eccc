#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Examples/run.sh [MESH]
#
# Installs the required packages, builds the project, carves MESH (by default the bones of a foot, from a Debian
# package) out of its convex hull, prints a table of the levels and renders them side by side.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

[ $# -le 1 ] || die "usage: bash Examples/run.sh [MESH]"
require_packages "${build_packages[@]}" "${picture_packages[@]}"
build release -DBUILD_TESTING=OFF

mesh=${1:-$(cgal_mesh bones.off)}
name=$(basename "${mesh%.gz}")
results=$build_root/results
levels=$results/${name%.*}.vtm
picture=$results/${name%.*}.png
mkdir -p "$results"

say "Carving $mesh"
"$build_root/release/bin/carve" "$mesh" -o "$levels"
xvfb-run -a /usr/bin/python3 "$root/Examples/Python/show_levels.py" "$levels" "$picture"

say "Done"
cat <<EOF
levels    $levels   (can be opened in ParaView)
picture   $picture
program   $build_root/release/bin/carve   (--help prints its manual page)
EOF
