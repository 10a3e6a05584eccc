#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: make_models.sh CARVING_MODEL FOLDER
#
# Writes the models for the ParaView tests to FOLDER.
set -euo pipefail
"$1" eight-spheres "$2/eight-spheres.ply"
"$1" two-spheres "$2/two-spheres.ply"
"$1" carved-figure "$2/carved-figure.vtk"
