#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/try_packages.sh FOLDER
#
# Installs the Debian packages of FOLDER, as root, and tries what users do with them. For a bare system, see packages.sh.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

install() {
  apt-get install -y -qq --no-install-recommends "$@" >"$build_root/apt.log" 2>&1 ||
    { tail -n 20 "$build_root/apt.log" >&2; die "The packages could not be installed: $*"; }
}

packages=$(realpath "$1")
say "Installing the packages of $packages"
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
# The program alone, then everything.
install "$packages"/topologycarving_*.deb
mesh=$(cgal_mesh bones.off)
mkdir -p "$build_root/levels"
cd "$build_root/levels"

say "Carving with the program"
carve "$mesh" -o levels.ply
# The first level is the hull, of which Euler's formula holds: with V vertices, 2 V - 4 triangles.
awk '$1 == "0" { found = $4 == 2 * $3 - 4 } END { exit !found }' < <(carve "$mesh" | tr -d ,) ||
  die "Level 0 is not a convex hull."

say "Completing and reading the manual page"
install man-db bash-completion "$packages"/*.deb
completed=$(bash -c '
  source /usr/share/bash-completion/completions/carve
  COMP_WORDS=(carve --conformity e) COMP_CWORD=2
  _carve carve
  echo "${COMPREPLY[*]}"')
[ "$completed" = "exact enclosing" ] || die "The completion of --conformity e is '$completed'."
[ "$(man --warnings -l "$(dpkg -L topologycarving | grep 'carve\.1')" 2>&1 >/dev/null)" = "" ] ||
  die "The manual page has errors."

say "Importing the Python package"
install python3-numpy
(cd / && PYTHONPATH=$root/Testing/Python /usr/bin/python3 "$root/Testing/Python/test_package.py")

say "Building a program with the CMake package"
install cmake g++
cmake -S "$root/Testing/Consumer/Installed" -B consumer >consumer.log
cmake --build consumer >>consumer.log
./consumer/consumer

say "Carving in ParaView's window"
install xvfb xauth libgl1-mesa-dri
cp levels_7.ply eight-spheres.ply
export HOME=$PWD
xvfb-run -a paraview --dr --exit --test-script="$root/Testing/ParaView/PickLevel.xml" \
  --data-directory="$PWD" --test-directory="$PWD" >paraview.log 2>&1 ||
  { tail -n 40 paraview.log >&2; die "ParaView did not find the plugin."; }

say "Carving in ParaView's Python, which takes the place of VTK's"
install python3-paraview
pvbatch --dr /dev/stdin <<'PYTHON'
from paraview import simple
carver = simple.TopologyCarver(Input=simple.Cone())
carver.UpdatePipeline()
assert carver.GetDataInformation().GetNumberOfPoints() > 0
PYTHON
say "Removing the plugin"
apt-get remove -y -qq paraview-topologycarving >"$build_root/apt.log" 2>&1
[ "$(dpkg --verify paraview)" = "" ] || die "Removing the plugin left ParaView changed: $(dpkg --verify paraview)"
say "The packages work"
