#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Packaging/make.sh
#
# Installs what the builds need and makes Debian packages in build/packages, for the release of Debian that runs:
#   topologycarving            the program carve, the library and the helper program
#   topologycarving-dev        headers and the CMake package
#   python3-topologycarving    the Python package
#   paraview-topologycarving   the ParaView plugin
# DEBFULLNAME and DEBEMAIL name who makes them.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Testing/setup.sh"

require_packages "${build_packages[@]}" "${paraview_packages[@]}" dpkg-dev file lintian python3 python3-vtk9
own_address=${DEBEMAIL:-}
export DEBFULLNAME=${DEBFULLNAME:-TopologyCarving contributors} DEBEMAIL=${DEBEMAIL:-topologycarving@$(hostname)}
LDFLAGS=$(dpkg-buildflags --get LDFLAGS)
export LDFLAGS

bash "$root/Testing/paraview_prefix.sh" "$build_root/paraview"
# With the flags of Testing/run.sh, both share the compiler cache.
options=(-DTOPOLOGYCARVING_PACKAGES=ON -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_TESTING=OFF
  -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror")
build package "${options[@]}"
build package-plugin "${options[@]}" -DTOPOLOGYCARVING_PARAVIEW=ON -DParaView_ROOT="$build_root/paraview/usr"

packages=$build_root/packages
rm -rf "$packages"
for name in package package-plugin; do
  say "Packing $build_root/$name"
  log=$build_root/$name-cpack.log
  (cd "$build_root/$name" && cpack -B "$packages") >"$log" 2>&1 || { tail -n 40 "$log" >&2; die "cpack failed; see $log"; }
done
rm -rf "$packages/_CPack_Packages"

say "Checking the packages"
# The library has no package of its own. ParaView's list of plugins is no program. CPack's scripts call ldconfig, where
# Debian's own tools would use a trigger.
accepted=package-name-doesnt-match-sonames,no-manual-page,maintscript-calls-ldconfig,lacks-ldconfig-trigger
[ -n "$own_address" ] || accepted+=,bogus-mail-host,bogus-mail-host-in-debian-changelog
lintian --allow-root --fail-on error,warning --suppress-tags "$accepted" "$packages"/*.deb
ls "$packages"
