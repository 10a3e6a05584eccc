#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/fetch_meshes.sh FOLDER
#
# Extracts real meshes from Debian packages to FOLDER, as OFF files, for the tests. No package is installed, and
# meshes that exist already are not fetched again.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

[ $# -eq 1 ] || die "usage: bash Testing/fetch_meshes.sh FOLDER"
mkdir -p "$1"

for name in bones elephant cheese; do
  [ -s "$1/$name.off" ] || cp "$(cgal_mesh $name.off)" "$1/$name.off"
done

if [ ! -s "$1/bunny.off" ]; then
  fetch glmark2-data
  bunny=$build_root/meshes/glmark2-data/usr/share/glmark2/models/bunny.obj
  {
    printf 'OFF\n%d %d 0\n' "$(grep -c '^v ' "$bunny")" "$(grep -c '^f ' "$bunny")"
    awk '$1 == "v" { print $2, $3, $4 }' "$bunny"
    awk '$1 == "f" { printf NF - 1; for (i = 2; i <= NF; ++i) printf " " $i - 1; print "" }' "$bunny"
  } >"$1/bunny.off"
fi
