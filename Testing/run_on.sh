#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# usage: bash Testing/run_on.sh bookworm|trixie [COMMAND]
#
# Makes a bare Debian 12 (bookworm) or 13 (trixie) with debootstrap in build/roots/bookworm or build/roots/trixie, puts
# the last commit of this checkout there and runs COMMAND in it, by default 'bash Testing/run.sh'. Needs root.
#
# A system that exists is used again, with its packages and its build folder. To start anew, delete it.
#
# The exit status is COMMAND's, or 77 if no system can be made here.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"

usage="usage: bash Testing/run_on.sh bookworm|trixie [COMMAND]"
[ $# -eq 1 ] || [ $# -eq 2 ] || die "$usage"
release=$1
command=${2:-bash Testing/run.sh}

cannot() {
  printf '%s\n' "$*" >&2
  exit 77
}

[ "$release" = bookworm ] || [ "$release" = trixie ] || die "$usage"
[ "$(id -u)" -eq 0 ] || cannot "Only root can make a system and run commands in it: sudo bash Testing/run_on.sh $*"
command -v debootstrap >/dev/null || cannot "debootstrap was not found. Install it first: apt-get install debootstrap"
commit=$(git -C "$root" rev-parse --short HEAD) || cannot "$root is not a checkout of git, from which files could be copied."

# Mounts and processes of a namespace end with its first process, however that ends. So nothing stays mounted below a
# folder that somebody may delete.
isolated=(unshare --mount --propagation private --pid --fork --kill-child)
"${isolated[@]}" mount -t proc proc /proc ||
  cannot "This process may not make namespaces, in which the other system's folders are mounted (in a container: privileged?)."

system=$build_root/roots/$release
if [ ! -e "$system" ]; then
  say "Making a bare $release in $system"
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' | head -n 1)
  log=$build_root/roots/$release.log
  rm -rf "$system.part"
  mkdir -p "$system.part"
  "${isolated[@]}" debootstrap --variant=minbase "$release" "$system.part" "${mirror:-http://deb.debian.org/debian}" \
    >"$log" 2>&1 || { tail -n 20 "$log" >&2; cannot "debootstrap failed; the whole log is $log"; }
  mv "$system.part" "$system"
fi

say "Running on $release, with commit $commit: $command"
git -C "$root" diff --quiet HEAD || printf 'Changes that are not committed are left out.\n' >&2
copy=$system/srv/topologycarving
mkdir -p "$copy"
find "$copy" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
# Files get the time of their copy, so that a build never takes a changed file for an old one.
git -C "$root" archive HEAD | tar -x --touch -C "$copy"
cp /etc/resolv.conf "$system/etc/"

# Both systems share the compiler cache.
cache=${CCACHE_DIR:-$HOME/.cache/ccache}
mkdir -p "$cache" "$system/srv/ccache"
# unshare itself ignores the signals that end this script.
trap 'kill -KILL $! 2>/dev/null || true' EXIT
"${isolated[@]}" bash -c '
  set -e
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  mount --bind "$2" "$1/srv/ccache"
  exec env -i HOME=/srv CCACHE_DIR=/srv/ccache LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+"http_proxy=$http_proxy"} \
    chroot "$1" bash -c "cd /srv/topologycarving && $3"' run_on "$system" "$cache" "$command" <&0 &
wait $!
