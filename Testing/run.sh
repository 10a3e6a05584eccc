#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/run.sh [slice]
#
# Installs the required packages in Debian's newest version, builds the project and runs all tests:
# - the format of the sources,
# - the whole project, with warnings as errors,
# - the plugin in ParaView,
# - the Debian packages, which are made and unpacked (see packages.sh for their installation),
# - what runs processes, in the portable build, and what can be compiled for Windows,
# - core, helper program and module under the address and undefined-behavior sanitizers,
# - the fuzz targets, for some seconds each,
# - a slice of this on Debian's other release, if this process may make one (see run_on.sh).
# The slice has the whole project, with warnings as errors, short tests of all parts, and the packages.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

[ "$*" = "" ] || [ "$*" = slice ] || die "usage: bash Testing/run.sh [slice]"
selection=()
if [ "$*" = slice ]; then
  selection=(-E '^(Budgets|Decimation|Enclose|Faults|InTree|Properties|SimplifiedLevels|Soups|Strategies)')
  selection[1]+='|^pvcs|^test_(balance|carve$|filters|messages)'
fi

# ParaView's client finds its server by the name of the machine, which a minimal system may not resolve.
getent hosts "$(uname -n)" >/dev/null || test_packages+=(libnss-myhostname)
require_packages "${build_packages[@]}" "${picture_packages[@]}" "${test_packages[@]}" \
  "${paraview_packages[@]}"
meshes=$build_root/meshes/off
# Two tests at a time: the machine may be busy, and some tests compile programs.
jobs=2

say "Checking the format"
mapfile -d '' -t sources < <(find "$root/Examples" "$root/Filters" "$root/Plugin" "$root/Testing" \
  \( -name '*.cxx' -o -name '*.h' \) -print0)
long=$(awk 'length > 100 { print FILENAME ":" FNR }' "${sources[@]}")
[ -z "$long" ] || die "Lines of more than 100 columns: $long"
if clang-format --version | grep -q 'version 14\.'; then
  clang-format --dry-run --Werror "${sources[@]}" || die "Run clang-format -i on these files."
else
  printf 'Skipped: only clang-format 14 (Debian 12) formats as these sources are.\n'
fi

build testing -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DTOPOLOGYCARVING_MESHES="$meshes"
say "Testing"
xvfb-run -a ctest --test-dir "$build_root/testing" -j$jobs --output-on-failure "${selection[@]}"

bash "$root/Testing/paraview_prefix.sh" "$build_root/paraview"
build plugin -DTOPOLOGYCARVING_PARAVIEW=ON -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" \
  -DParaView_ROOT="$build_root/paraview/usr" \
  -DTOPOLOGYCARVING_CARVE="$build_root/testing/bin/carve"
say "Testing the plugin for ParaView"
# Without -noreset, the X server refuses clients that connect while the last client disconnects.
xvfb-run -a -s '-screen 0 1500x1000x24 -noreset' \
  ctest --test-dir "$build_root/plugin" -j$jobs --output-on-failure "${selection[@]}"

bash "$root/Packaging/make.sh"
say "Carving with the packages, unpacked"
unpacked=$build_root/unpacked
rm -rf "$unpacked"
for package in "$build_root"/packages/*.deb; do
  dpkg-deb -x "$package" "$unpacked"
done
(
  LD_LIBRARY_PATH=$unpacked/usr/lib/$(dpkg-architecture -q DEB_HOST_MULTIARCH)
  export LD_LIBRARY_PATH PYTHONPATH=$unpacked/usr/lib/python3/dist-packages
  "$unpacked/usr/bin/carve" "$meshes/bones.off"
  /usr/bin/python3 "$root/Testing/Python/test_package.py"
)
if [ "$*" = slice ]; then
  say "The slice passed"
  exit
fi

targets="carve carving-helper FilterTests HelperTests" build portable -DTOPOLOGYCARVING_PORTABLE=ON \
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DTOPOLOGYCARVING_MESHES="$meshes"
say "Testing child processes and temporary files in the portable build"
xvfb-run -a ctest --test-dir "$build_root/portable" -j$jobs --output-on-failure \
  -R '^(ChildProcess|Helper|Strategies|Faults|Composite|Conformity|Reuse|TopologyCarver|test_carve$)'

# File by file, which finds missing includes.
source=$root/Testing/Windows build windows -DCMAKE_UNITY_BUILD=OFF \
  -DCMAKE_TOOLCHAIN_FILE="$root/Testing/Windows/mingw-w64.cmake" -DVTK_INCLUDE_DIR="$(echo /usr/include/vtk-9*)" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"

# Warnings stay off: under sanitizers, the compiler reports false ones in CGAL. More optimization and more symbols than
# these take half as long again to compile.
targets="CoreTests FilterTests HelperTests ModelTests" build sanitize -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1 -DNDEBUG" \
  -DCMAKE_CXX_FLAGS="-fsanitize=address,undefined -fno-sanitize-recover=all" \
  -DTOPOLOGYCARVING_MESHES="$meshes"
say "Testing core, helper program and module under sanitizers"
# Tests take ten times as long under sanitizers. The two largest real meshes are left out, because they reach no
# code that the others do not reach.
ctest --test-dir "$build_root/sanitize" -j$jobs --output-on-failure -L WithoutVTK -E 'RealMesh.*(cheese|bunny)'
# Tests that render, and tests that wait for limits, are left out: the sanitizer itself exceeds one of the limits.
ctest --test-dir "$build_root/sanitize/Testing/Cxx/Filters" -j$jobs --output-on-failure -E '^(Faults|Image|Soup)'

# libFuzzer is part of clang.
build fuzz -DTOPOLOGYCARVING_FUZZ=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++
say "Fuzzing the core, the protocol of the helper program and the reading of streams"
ctest --test-dir "$build_root/fuzz" -j$jobs --output-on-failure

case $(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}") in
  trixie) other=bookworm ;;
  *) other=trixie ;;
esac
say "Building and testing on $other"
# All tests end within 75 minutes, also on a slow machine.
limit=$((4500 - SECONDS))
limit=$((limit < 1 ? 1 : limit < 1500 ? limit : 1500))
result=0
timeout --kill-after=60 $limit bash "$root/Testing/run_on.sh" $other 'bash Testing/run.sh slice' || result=$?
case $result in
  0) ;;
  77) printf 'Skipped: nothing was tested on %s.\n' $other ;;
  124) printf 'Ended after %s seconds: the remainder was not tested on %s.\n' $limit $other ;;
  *) die "The tests failed on $other." ;;
esac

say "All tests passed"
