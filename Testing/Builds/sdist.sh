#!/usr/bin/env bash
# The source archive of the Python package in a clean root of Debian 12: `pip install` of it stops with one message, which names
# all packages that are missing; with these installed the package is built, and its command works.
# Usage: Testing/Builds/sdist.sh [message]
#   message   does not build: half an hour of processor time less
# Needs root, debootstrap, the shared data and PyPI; takes the committed state. ISTHMUS_ROOTS, ISTHMUS_RELEASE_DIR, ISTHMUS_MIRROR
# and ccache as in release.sh.
source "$(dirname "${BASH_SOURCE[0]}")/roots.sh"

scope=${1:-build}
case $scope in build | message) ;; *) usage ;; esac
isolate "$@"
name=bookworm-sdist
make_root bookworm $name
clone_into_root /clone
# Certificates of this machine: those of a proxy may be among them.
cp /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs/"
export PIP_CERT=/etc/ssl/certs/ca-certificates.crt

# pip ARGUMENT...: that of an environment in the root
pip()
{
  # The names of the compilers are those of other builds, for ccache: pip would take those that Debian's Python was built by.
  inside "PIP_CERT=$PIP_CERT SKBUILD_BUILD_DIR=/isthmus/build_wheel CC=gcc CXX=g++ \
    CMAKE_BUILD_PARALLEL_LEVEL=${ISTHMUS_JOBS:-$(nproc)} /python/bin/pip $*"
}

say "The source archive"
inside "apt-get update -q && apt-get install -q -y --no-install-recommends python3-venv && rm -rf /python /clone/dist &&
  python3 -m venv /python" >"$logs/$name-packages.log"
# With the cache, the CMake that other builds have: groups of sources of another version are other files.
if [ ${#launcher[@]} -gt 0 ]; then
  inside "apt-get install -q -y --no-install-recommends ccache cmake ninja-build" >>"$logs/$name-packages.log"
fi
pip install -q build
inside "PIP_CERT=$PIP_CERT /python/bin/python -m build --sdist /clone" >"$logs/$name-archive.log" 2>&1
archive=$(cd "$root" && echo clone/dist/isthmus-*.tar.gz)

say "pip install $(basename "$archive")"
if pip install "/$archive" >"$logs/$name-message.log" 2>&1; then
  echo "Nothing is missing: $root is not clean." >&2
  exit 1
fi
grep -E -A 4 'CMake Error' "$logs/$name-message.log"
missing=$(sed -n 's/^ *apt install //p' "$logs/$name-message.log")
[ "$(grep -c 'CMake Error' "$logs/$name-message.log")" = 1 ] && [ -n "$missing" ] || {
  tail -n 40 "$logs/$name-message.log" >&2
  exit 1
}
[ $scope = build ] || exit 0

say "The same with these packages"
inside "apt-get install -q -y --no-install-recommends $missing" >>"$logs/$name-packages.log"
# Unpacked as pip does but in a folder with the same name each time, for ccache.
inside "tar -x -z --strip-components 1 -f /$archive"
pip install /isthmus >"$logs/$name-build.log" 2>&1 || {
  tail -n 40 "$logs/$name-build.log" >&2
  exit 1
}
inside "cd / && /python/bin/isthmus --version && /python/bin/python -c 'import isthmus
isthmus.off_surface_writer(isthmus.samples.torus(), \"/torus.off\")' && /python/bin/isthmus loops /torus.off" | tee "$logs/$name.txt"
grep -q 'loops 2, handles 1, tunnels 1' "$logs/$name.txt"
