# SPDX-License-Identifier: BSD-3-Clause
# Functions shared by the scripts in Examples and Testing: packages, builds, meshes. To be sourced.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# All generated files are below this folder.
build_root=${BUILD_DIR:-$root/build}
# Clones share the results of the compiler cache.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# Every package that a build or a test uses directly is listed, so that a machine with more packages hides no omission.
build_packages=(
  ca-certificates ccache cmake g++ libcgal-dev libgmp-dev libmpfr-dev libtet1.5-dev libvtk9-dev
  libx11-dev ninja-build zlib1g-dev)
picture_packages=(libgl1-mesa-dri python3 python3-vtk9 xauth xvfb)
test_packages=(
  clang clang-format g++-mingw-w64-x86-64-posix libclang-rt-dev libgtest-dev python3-numpy)
# python3-paraview conflicts with python3-vtk9 and is not installed: paraview_prefix.sh unpacks it elsewhere.
# ParaView parses its files with libexpat1.
paraview_packages=(
  libdouble-conversion-dev libexpat1 libexpat1-dev libgl-dev libopenmpi-dev mpi-default-bin
  paraview paraview-dev python3-xlib)
# The Qt of ParaView; ParaView draws its icons with the second package.
case $(. /etc/os-release && printf '%s' "${VERSION_ID:-}") in
  12) paraview_packages+=(qtbase5-dev libqt5svg5) ;;
  *) paraview_packages+=(qt6-base-dev qt6-svg-plugins) ;;
esac

say() {
  printf '\n== %s\n' "$*"
}

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

# outdated PACKAGE...: prints those of the packages and their dependencies of which apt has a newer version.
outdated() {
  comm -12 \
    <(apt-cache depends --recurse --installed --important "$@" | grep '^[a-z0-9]' | sort -u) \
    <(apt-get -s -qq dist-upgrade | awk '$1 == "Inst" { print $2 }' | sort -u)
}

# install_packages PACKAGE...: installs or upgrades the packages as root, or prints the command to run.
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

# require_packages PACKAGE...: installs missing packages and, once a day, upgrades outdated ones: an old library may
# hide problems that users of the current version have. Offline, the installed versions are used.
require_packages() {
  local package missing=() old=() today
  today=$build_root/.packages-of-today-$(cksum <<<"$*" | cut -d ' ' -f 1)
  command -v dpkg-query >/dev/null || die "This script is for Debian 12 and 13. Elsewhere, follow 'Building by hand' in README.md."
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ] && [ -n "$(find "$today" -mtime -1 2>/dev/null)" ]; then
    return
  fi
  say "Looking for packages to install or upgrade"
  if [ "$(id -u)" -eq 0 ] && ! apt-get update -qq --error-on=any -o Acquire::Retries=0; then
    printf 'The package lists could not be updated: installed packages may be outdated.\n' >&2
    today=/dev/null
  fi
  if [ ${#missing[@]} -gt 0 ] && ! install_packages "${missing[@]}"; then
    exit 1
  fi
  mapfile -t old < <(outdated "$@")
  if [ ${#old[@]} -gt 0 ] && ! install_packages "${old[@]}"; then
    today=/dev/null
  fi
  : >"$today"
}

# build NAME [CMAKE_OPTION...]: configures and builds everything, or only $targets, of the project or of the folder
# $source, in a folder of that name. Unity builds take a third of the time, nearly all of which goes into headers.
build() {
  local directory=$build_root/$1 log=$build_root/$1.log
  shift
  say "Building in $directory"
  {
    cmake -S "${source:-$root}" -B "$directory" -G Ninja -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
      -DCMAKE_UNITY_BUILD=ON "$@" &&
      ninja -C "$directory" ${targets:-}
  } >"$log" 2>&1 || { grep -vE '^-- ' "$log" | tail -n 60 >&2; die "The build failed; the whole log is $log"; }
}

# fetch PACKAGE: unpacks a Debian package in the mesh folder, without installing it.
fetch() {
  local target=$build_root/meshes/$1
  [ -e "$target/.complete" ] && return
  say "Fetching meshes from Debian's package $1"
  rm -rf "$target"
  mkdir -p "$target"
  # `set -e` has no effect on the left of `||`.
  (
    cd "$target" &&
    # By default, apt run by root downloads as another user, who may not write to this folder.
    { apt-get -qq -o APT::Sandbox::User=root download "$1" ||
      { [ "$(id -u)" -eq 0 ] && apt-get update -qq &&
        apt-get -qq -o APT::Sandbox::User=root download "$1"; }; } &&
    dpkg-deb -x ./*.deb . &&
    rm ./*.deb
  ) || die "The package $1, which contains the meshes, could not be fetched."
  touch "$target/.complete"
}

# cgal_mesh NAME: prints the path of a mesh from the package libcgal-demo.
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
