#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/run.sh
#
# Installs the required packages in Debian's newest version, builds the project and runs all tests:
# - the format of the sources,
# - the whole project, with warnings as errors,
# - the plugin in ParaView,
# - core, helper program and module under the address and undefined-behavior sanitizers,
# - the fuzz targets, for some seconds each.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

# ParaView's client finds its server by the name of the machine, which a minimal system may not resolve.
getent hosts "$(uname -n)" >/dev/null || test_packages+=(libnss-myhostname)
require_packages "${build_packages[@]}" "${picture_packages[@]}" "${test_packages[@]}" \
  "${paraview_packages[@]}"
meshes=$build_root/meshes/off
# Two tests at a time: the machine may be busy, and some tests compile programs.
jobs=2

say "Checking the format"
find "$root/Examples" "$root/Filters" "$root/Plugin" "$root/Testing" \( -name '*.cxx' -o -name '*.h' \) -print0 |
  xargs -0 clang-format --dry-run --Werror || die "Run clang-format -i on these files."

build testing -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DTOPOLOGYCARVING_MESHES="$meshes"
say "Testing"
xvfb-run -a ctest --test-dir "$build_root/testing" -j$jobs --output-on-failure

bash "$root/Testing/paraview_prefix.sh" "$build_root/paraview"
build plugin -DTOPOLOGYCARVING_PARAVIEW=ON -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" \
  -DParaView_ROOT="$build_root/paraview/usr" \
  -DTOPOLOGYCARVING_CARVE="$build_root/testing/bin/carve"
say "Testing the plugin for ParaView"
# Without -noreset, the X server refuses clients that connect while the last client disconnects.
xvfb-run -a -s '-screen 0 1500x1000x24 -noreset' \
  ctest --test-dir "$build_root/plugin" -j$jobs --output-on-failure

# Warnings stay off: under sanitizers, the compiler reports false ones in CGAL.
targets="CoreTests FilterTests HelperTests ModelTests" build sanitize -DCMAKE_BUILD_TYPE=RelWithDebInfo \
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

say "All tests passed"
