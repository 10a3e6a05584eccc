#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/packages.sh bookworm|trixie
#
# Makes the Debian packages of that release in one bare system, installs them in a second one, which has no package that
# only the build needs, and tries them there. Needs root and debootstrap, see run_on.sh.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

[ $# -eq 1 ] || die "usage: bash Testing/packages.sh bookworm|trixie"
bash "$root/Testing/run_on.sh" "$1" 'bash Packaging/make.sh'

export BUILD_DIR=$build_root/users
rm -rf "$BUILD_DIR/roots/$1"
bash "$root/Testing/run_on.sh" "$1" true
mkdir "$BUILD_DIR/roots/$1/srv/packages"
cp "$build_root/roots/$1"/srv/topologycarving/build/packages/*.deb "$BUILD_DIR/roots/$1/srv/packages"
bash "$root/Testing/run_on.sh" "$1" 'bash Testing/try_packages.sh /srv/packages'
