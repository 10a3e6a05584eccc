#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# conda-build runs this script in a copy of the sources.
set -euo pipefail
cmake -S . -B conda-build -G Ninja ${CMAKE_ARGS:-} -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" \
  -DPython3_EXECUTABLE="$PYTHON" -DBUILD_TESTING=OFF
cmake --build conda-build
cmake --install conda-build
