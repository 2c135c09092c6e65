# Clean roots of versions of Debian, for release.sh and try_package.sh. Sourced, not run.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
logs=${ISTHMUS_RELEASE_DIR:-$source_dir/build/release}
source "$source_dir/cmake/archive.sh"

say() { printf '\n== %s\n' "$*"; }

# The comment at the head of the calling script.
usage()
{
  sed -n '2,/^[^#]/{/^[^#]/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 2
}

# isolate ARGUMENT...: runs the calling script again in mounts and processes of its own: none is left
# behind, and removing the root touches nothing else.
isolate()
{
  if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
    echo "$(basename "$0") needs root and the package debootstrap." >&2
    exit 1
  fi
  if [ "${ISTHMUS_RELEASE_INSIDE:-}" != yes ]; then
    exec env ISTHMUS_RELEASE_INSIDE=yes unshare --mount --pid --fork --kill-child "$0" "$@"
  fi
  # The first process of its own tree hears signals only where it handles them.
  trap 'exit 130' INT TERM
}

# make_root SUITE NAME: sets `root`; the root is made unless $ISTHMUS_ROOTS has one of this NAME, and
# mounted with the data at /shared/data. With ccache, sets `launcher` for `inside`.
make_root()
{
  local suite=$1 name=$2 data=${ISTHMUS_DATA_DIR:-$source_dir/../shared/data} script=() roots mirror
  if [ ! -d "$data" ]; then
    echo "$(basename "$0") needs the shared data: Testing/fetch_data.sh, or ISTHMUS_DATA_DIR." >&2
    exit 1
  fi
  mkdir -p "$logs"
  logs=$(cd "$logs" && pwd)
  if [ -n "${ISTHMUS_ROOTS:-}" ]; then
    roots=$ISTHMUS_ROOTS
    mkdir -p "$roots"
    root=$roots/$name
  else
    roots=$(mktemp -d)
    root=$roots/$name
    # The mounts go first (also those that a process still uses), then what is on this file system alone.
    trap 'umount -R -l "$root" 2>/dev/null || true; rm -rf --one-file-system "$(dirname "$root")"' EXIT
  fi
  exec 9>"$root.lock" # one script at a time
  flock 9
  # The last file written: an interrupted debootstrap is begun again.
  if [ ! -e "$root/etc/apt/apt.conf.d/90isthmus" ]; then
    rm -rf --one-file-system "$root"
    mirror=$(archive_address)
    say "Making a root of $suite in $root from $mirror"
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
  # debootstrap makes none; tests connect to localhost.
  [ -e "$root/etc/hosts" ] || echo "127.0.0.1 localhost" >"$root/etc/hosts"
  launcher=()
  if [ "${CMAKE_CXX_COMPILER_LAUNCHER:-}" = ccache ] && [ -n "${ISTHMUS_ROOTS:-}" ]; then
    mkdir -p "$roots/ccache" "$root/ccache"
    mount --bind "$roots/ccache" "$root/ccache"
    launcher=(CMAKE_CXX_COMPILER_LAUNCHER=ccache CMAKE_C_COMPILER_LAUNCHER=ccache CCACHE_DIR=/ccache)
  fi
}

# clone_into_root [FOLDER]: the committed state in /isthmus or FOLDER. Files of an earlier build stay.
clone_into_root()
{
  local clone=$root${1:-/isthmus}
  say "The clone of $(git -C "$source_dir" rev-parse --short HEAD)"
  if [ -d "$clone/.git" ]; then
    git -C "$clone" fetch -q "$source_dir" HEAD
    git -C "$clone" checkout -q --detach FETCH_HEAD
  else
    git clone -q --no-local "$source_dir" "$clone"
  fi
}

# inside COMMAND: in /isthmus in the root, as a user of a new machine has it.
inside()
{
  chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 ISTHMUS_REQUIRE_DATA=1 \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
    "${launcher[@]}" bash -c "cd /isthmus && $1"
}
