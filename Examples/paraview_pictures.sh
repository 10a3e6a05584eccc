#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Examples/paraview_pictures.sh [FOLDER]
#
# Installs the required packages, builds the plugin, replays the recorded sessions of the tests in ParaView with
# the bones of a foot, and writes pictures of ParaView's window to FOLDER (by default Examples/images). Their names have
# ParaView's version.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

folder=$(realpath -m "${1:-$root/Examples/images}")
require_packages "${build_packages[@]}" "${picture_packages[@]}" "${paraview_packages[@]}" \
  imagemagick
build release -DBUILD_TESTING=OFF
bash "$root/Testing/paraview_prefix.sh" "$build_root/paraview"
build plugin-release -DTOPOLOGYCARVING_PARAVIEW=ON -DBUILD_TESTING=OFF \
  -DParaView_ROOT="$build_root/paraview/usr"
plugin=$(dirname "$build_root"/plugin-release/lib/paraview-*/plugins/TopologyCarving/TopologyCarving.so)
version=$(basename "$build_root"/plugin-release/lib/paraview-*)

work=$build_root/paraview-pictures
mkdir -p "$folder" "$work"
# ParaView cannot read OFF files. The only level of a carving with one level is the input.
"$build_root/release/bin/carve" "$(cgal_mesh bones.off)" --levels 1 -o "$work/bones.ply" >/dev/null
mv "$work/bones_0.ply" "$work/bones.ply"

# picture SESSION NAME: replays a recorded session and takes a picture of the window.
picture() {
  say "Playing $1"
  sed -e 's/eight-spheres/bones/' -e 's/arguments="3000"/arguments="1600"/' -e 's/arguments="31"/arguments="42"/' \
    "$root/Testing/ParaView/$1.xml" >"$work/$1.xml"
  HOME=$work PYTHONPATH=$build_root/paraview/usr/lib/python3/dist-packages \
    xvfb-run -a -s '-screen 0 1152x764x24' bash -c '
      "$1/usr/bin/paraview" --dr --plugin-search-paths="$2" --plugins=TopologyCarving \
        --data-directory="$3" --test-directory="$3" --test-script="$3/$4.xml" >"$3/$4.log" 2>&1 &
      until grep -q "is finished" "$3/$4.log" || ! kill -0 $!; do
        sleep 1
      done
      sleep 2
      import -window root "$5"
      kill $!' bash "$build_root/paraview" \
      "$plugin" "$work" "$1" "$work/$2.png"
  grep -q 'Success =  true' "$work/$1.log" || die "The session $1 failed; see $work/$1.log"
  # Smaller and with fewer colors, for the web.
  convert "$work/$2.png" -resize 900x -colors 128 "$folder/$2.png"
}
picture FirstLevel "$version-first"
picture PickLevel "$version-slider"
picture PlayCarving "$version-play"

say "Done"
printf 'pictures  %s\n' "$folder/$version"-{first,slider,play}.png
