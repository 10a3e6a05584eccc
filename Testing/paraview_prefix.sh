#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/paraview_prefix.sh FOLDER
#
# Creates FOLDER/usr with ParaView, its headers and its Python modules, without installing python3-paraview.
# That package conflicts with python3-vtk9, which the tests of the VTK module need. The packages paraview and
# paraview-dev have to be installed; their files are linked.
set -euo pipefail
folder=$(realpath -m "$1")
[ -e "$folder/.complete" ] && exit
rm -rf "$folder"
mkdir -p "$folder"
dpkg -L paraview paraview-dev | sort -u | while read -r path; do
  if [ -f "$path" ] || [ -L "$path" ]; then
    printf '%s\0' "$path"
  fi
done | xargs -0 cp --parents --symbolic-link --no-dereference --target-directory="$folder"
(
  cd "$folder"
  apt-get -qq -o APT::Sandbox::User=root download python3-paraview
  dpkg-deb -x python3-paraview_*.deb .
  rm python3-paraview_*.deb
  # ParaView's exported targets name these files without the version of Python, which Debian 13 adds.
  find usr/lib/python3 -name '*.cpython-*.so' | while read -r module; do
    ln -s "$(basename "$module")" "${module%%.*}.so"
  done
)
touch "$folder/.complete"
