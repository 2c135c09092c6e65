#!/usr/bin/env bash
# Checks a release on one version of Debian: a clean root, both commands of README in it, a summary.
# Usage: Testing/Builds/release.sh SUITE [plain] [ctest arguments]
#
# The commands are ./Examples/run.sh and ./Testing/run.sh, the latter with --all: every test, whatever its
# turn. The shared data are required.
#
# SUITE     bookworm, trixie, testing: a name that debootstrap knows
# plain     Isthmus without ParaView on the suite's own VTK (libvtk9-dev): all unit tests
#
# Needs root, debootstrap and the shared data; takes the committed state, not the working tree.
# ISTHMUS_ROOTS          where roots are kept and used again, as SUITE or SUITE-plain; without it
#                        the root is made in a temporary folder and removed at the end
# ISTHMUS_DATA_DIR       the shared data, by default ../shared/data beside the clone
# ISTHMUS_RELEASE_DIR    where logs and the summary are left, by default build/release
# ISTHMUS_MIRROR         by default http://deb.debian.org/debian
# CMAKE_CXX_COMPILER_LAUNCHER=ccache: installed in the root, with its cache in $ISTHMUS_ROOTS/ccache
set -euo pipefail

usage() { sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//;p}' "${BASH_SOURCE[0]}" >&2; exit 2; }
[ $# -ge 1 ] || usage
suite=$1
shift
kind=paraview
if [ "${1:-}" = plain ]; then
  kind=plain
  shift
fi
case $suite in *[!a-z]*) usage ;; esac

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
data=$(cd "${ISTHMUS_DATA_DIR:-$source_dir/../shared/data}" && pwd)
logs=${ISTHMUS_RELEASE_DIR:-$source_dir/build/release}
mirror=${ISTHMUS_MIRROR:-http://deb.debian.org/debian}
name=$suite
[ $kind = paraview ] || name=$suite-$kind

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "release.sh needs root and the package debootstrap." >&2
  exit 1
fi
# In mounts and processes of its own: none is left behind, and removing the root touches nothing else.
if [ "${ISTHMUS_RELEASE_INSIDE:-}" != yes ]; then
  [ $kind = paraview ] || set -- plain "$@"
  exec env ISTHMUS_RELEASE_INSIDE=yes unshare --mount --pid --fork --kill-child \
    "${BASH_SOURCE[0]}" "$suite" "$@"
fi

# The first process of its own tree hears signals only where it handles them.
trap 'exit 130' INT TERM

say() { printf '\n== %s\n' "$*"; }

mkdir -p "$logs"
logs=$(cd "$logs" && pwd)
if [ -n "${ISTHMUS_ROOTS:-}" ]; then
  roots=$ISTHMUS_ROOTS
  mkdir -p "$roots"
else
  roots=$(mktemp -d)
  # The mounts go first, then what is on this file system alone.
  trap 'umount -R "$roots/$name" 2>/dev/null; rm -rf --one-file-system "$roots"' EXIT
fi
root=$roots/$name

if [ ! -e "$root/etc/debian_version" ]; then
  say "Making a root of $suite in $root"
  script=()
  [ -e "/usr/share/debootstrap/scripts/$suite" ] || script=(sid)
  # git and certificates: who has a clone has them.
  debootstrap --variant=minbase --include=ca-certificates,git "$suite" "$root" "$mirror" \
    "${script[@]}" >"$logs/$name-debootstrap.log"
  # Snapshots of testing outlive their date.
  echo 'Acquire::Check-Valid-Until "false";' >"$root/etc/apt/apt.conf.d/90isthmus"
else
  say "Using the root $root; remove it to begin with a clean one"
fi

mount --bind "$root" "$root" # a mount point of its own, for umount -R
mount --make-rprivate "$root"
mkdir -p "$root/shared/data" "$root/isthmus"
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --rbind /sys "$root/sys"
mount --make-rslave "$root/dev"
mount --make-rslave "$root/sys"
mount --bind -o ro "$data" "$root/shared/data"
cp /etc/resolv.conf "$root/etc/resolv.conf"
launcher=()
if [ "${CMAKE_CXX_COMPILER_LAUNCHER:-}" = ccache ] && [ -n "${ISTHMUS_ROOTS:-}" ]; then
  mkdir -p "$roots/ccache" "$root/ccache"
  mount --bind "$roots/ccache" "$root/ccache"
  launcher=(CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache CCACHE_DIR=/ccache)
fi

# inside COMMAND: in the clone in the root, as a user of a new machine has it.
inside()
{
  chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 ISTHMUS_REQUIRE_DATA=1 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    "${launcher[@]}" bash -c "cd /isthmus && $1"
}

say "The clone of $(git -C "$source_dir" rev-parse --short HEAD)"
if [ -d "$root/isthmus/.git" ]; then
  git -C "$root/isthmus" fetch -q "$source_dir" HEAD
  git -C "$root/isthmus" checkout -q --detach FETCH_HEAD
  git -C "$root/isthmus" clean -q -x -d -f -f
else
  git clone -q --no-local "$source_dir" "$root/isthmus"
fi
if [ ${#launcher[@]} -gt 0 ]; then
  inside "apt-get update -q && apt-get install -q -y --no-install-recommends ccache" >"$logs/$name-ccache.log"
fi

failed=0
arguments=$(printf '%q ' "$@")
if [ $kind = paraview ]; then
  say "./Examples/run.sh"
  inside ./Examples/run.sh >"$logs/$name-example.log" 2>&1 || failed=1
  tail -n 25 "$logs/$name-example.log"
  say "./Testing/run.sh --all"
  inside "./Testing/run.sh --all $arguments" \
    >"$logs/$name-tests.log" 2>&1 || failed=1
else
  say "Isthmus on the VTK of $suite"
  inside "./Testing/Builds/plain_vtk.sh --output-junit /isthmus/build/tests.xml $arguments" \
    >"$logs/$name-tests.log" 2>&1 || failed=1
fi
tail -n 25 "$logs/$name-tests.log"

say "Summary"
rm -f "$logs/$name.xml"
if [ -e "$root/isthmus/build/tests.xml" ]; then
  cp "$root/isthmus/build/tests.xml" "$logs/$name.xml"
  inside "python3 Testing/Builds/release_summary.py build/tests.xml" | tee "$logs/$name.txt"
else
  echo "No test ran: see $logs/$name-*.log"
  failed=1
fi
exit $failed
