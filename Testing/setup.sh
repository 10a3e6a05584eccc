# SPDX-License-Identifier: BSD-3-Clause
# Functions that Examples/run.sh and Testing/run.sh share: packages, build, meshes. To be sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# Everything that is made goes below this folder.
build_root=${BUILD_DIR:-$root/build}
# What one clone has compiled need not be compiled by another.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# Whatever a build or a test uses itself is named, so that a machine with more on it hides nothing.
build_packages=(
  ca-certificates ccache cmake g++ libcgal-dev libgmp-dev libmpfr-dev libtet1.5-dev libvtk9-dev
  libx11-dev ninja-build zlib1g-dev)
picture_packages=(libgl1-mesa-dri python3 python3-vtk9 xauth xvfb)
test_packages=(clang clang-format libclang-rt-dev libgtest-dev python3-numpy)
# Without python3-paraview, which excludes python3-vtk9: paraview_prefix.sh unpacks it elsewhere.
# ParaView's icons are drawn by libqt5svg5, and its files parsed by libexpat1.
paraview_packages=(
  libdouble-conversion-dev libexpat1 libexpat1-dev libgl-dev libopenmpi-dev libqt5svg5 mpi-default-bin
  paraview paraview-dev python3-xlib qtbase5-dev)

say() {
  printf '\n== %s\n' "$*"
}

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

# outdated PACKAGE...: what apt knows newer versions of, among the packages and all that they rely on.
outdated() {
  comm -12 \
    <(apt-cache depends --recurse --installed --important "$@" | grep '^[a-z0-9]' | sort -u) \
    <(apt-get -s -qq dist-upgrade | awk '$1 == "Inst" { print $2 }' | sort -u)
}

# install_packages PACKAGE...: install or upgrade, or say what to run to that end.
install_packages() {
  local log=$build_root/apt.log
  if [ "$(id -u)" -ne 0 ]; then
    printf 'Packages are missing or outdated. Install them first:\n\n' >&2
    printf '  sudo apt-get install -y --no-install-recommends %s\n\n' "$*" >&2
    return 1
  fi
  say "Installing $*"
  DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    -o Dpkg::Options::=--force-confold "$@" >"$log" 2>&1 || { tail -n 20 "$log" >&2; return 1; }
}

# require_packages PACKAGE...: install what is missing and, once a day, upgrade what is outdated: an old
# library may hide what users of today's version meet. Offline, what is installed has to do.
require_packages() {
  local package missing=() old=() today=$build_root/.packages-of-today
  command -v dpkg-query >/dev/null || die "This script is for Debian 12. Elsewhere, follow 'Building by hand' in README.md."
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ] && [ "$(find "$today" -mtime -1 -exec cat {} + 2>/dev/null)" = "$*" ]; then
    return
  fi
  say "Looking for packages to install or upgrade"
  if [ "$(id -u)" -eq 0 ] && ! apt-get update -qq --error-on=any -o Acquire::Retries=0; then
    printf 'What is installed may be outdated.\n' >&2
    today=/dev/null
  fi
  if [ ${#missing[@]} -gt 0 ] && ! install_packages "${missing[@]}"; then
    exit 1
  fi
  mapfile -t old < <(outdated "$@")
  if [ ${#old[@]} -gt 0 ] && ! install_packages "${old[@]}"; then
    today=/dev/null
  fi
  printf '%s' "$*" >"$today"
}

# build NAME [CMAKE_OPTION...]: configure and build, all or only $targets, into a folder of that name.
build() {
  local directory=$build_root/$1 log=$build_root/$1.log
  shift
  say "Building in $directory"
  {
    cmake -S "$root" -B "$directory" -G Ninja -DCMAKE_CXX_COMPILER_LAUNCHER=ccache "$@" &&
      ninja -C "$directory" ${targets:-}
  } >"$log" 2>&1 || { grep -vE '^-- ' "$log" | tail -n 60 >&2; die "The build failed; all of it is in $log"; }
}

# fetch PACKAGE: unpack a Debian package into the mesh folder, without installing it.
fetch() {
  local target=$build_root/meshes/$1
  [ -e "$target/.complete" ] && return
  say "Fetching meshes from Debian's package $1"
  rm -rf "$target"
  mkdir -p "$target"
  (
    cd "$target"
    # Root's apt drops its rights for the download, for which it would need to own the folder.
    apt-get -qq -o APT::Sandbox::User=root download "$1" || {
      [ "$(id -u)" -eq 0 ] && apt-get update -qq &&
        apt-get -qq -o APT::Sandbox::User=root download "$1"
    }
    dpkg-deb -x ./*.deb .
    rm ./*.deb
  ) || die "The package $1 could not be fetched; it has the meshes that are used here."
  touch "$target/.complete"
}

# cgal_mesh NAME: the path of a mesh out of libcgal-demo.
cgal_mesh() {
  local package=$build_root/meshes/libcgal-demo
  fetch libcgal-demo >&2
  if [ ! -e "$package/data/meshes/$1" ]; then
    tar -xzf "$package/usr/share/doc/libcgal-dev/data.tar.gz" -C "$package" "data/meshes/$1" ||
      die "The package libcgal-demo has no mesh $1."
  fi
  printf '%s\n' "$package/data/meshes/$1"
}

mkdir -p "$build_root"
