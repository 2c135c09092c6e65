#!/usr/bin/env bash
# Tries a Debian package in a fresh root: it is installed with what it depends on and nothing to build
# with; the plugin loads by itself in pvpython and in the window, a button of the toolbar works, and
# removal leaves nothing.
# Usage: Testing/Builds/try_package.sh SUITE PACKAGE
#
# SUITE     bookworm, trixie, testing: the version of Debian that PACKAGE was built on
# PACKAGE   what `cpack -G DEB` made
#
# Needs root, debootstrap and the shared data. The root is made anew each time.
# ISTHMUS_ROOTS          where the root is left for a look, as SUITE-package; else it is removed
# ISTHMUS_DATA_DIR, ISTHMUS_RELEASE_DIR, ISTHMUS_MIRROR: as for release.sh
source "$(dirname "${BASH_SOURCE[0]}")/roots.sh"

[ $# -eq 2 ] || usage
case $1 in *[!a-z]*) usage ;; esac
isolate "$@"
suite=$1
package=$(realpath "$2")
name=$suite-package
if [ -n "${ISTHMUS_ROOTS:-}" ]; then
  rm -rf --one-file-system "${ISTHMUS_ROOTS:?}/$name"
fi
unset CMAKE_CXX_COMPILER_LAUNCHER
make_root "$suite" "$name"
# Of the clone only the tests of the window and the script for pvpython.
cp -r "$source_dir/Testing/Python" "$source_dir/Testing/Builds/check_package.py" "$root/isthmus/"
cp "$package" "$root/isthmus/isthmus.deb"

# What the package needs, and what the test looks and clicks with.
say "Installing what $(basename "$package") depends on"
depends=$(dpkg-deb -f "$package" Depends | sed 's/([^)]*)//g; s/|[^,]*//g; s/,/ /g')
inside "apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
  $depends python3-numpy xvfb xauth xdotool imagemagick" >"$logs/$name-depends.log" 2>&1

files() { inside "find /etc /opt /srv /usr /var/lib -xdev \( -path /var/lib/apt -o -path /var/lib/dpkg/info \) -prune -o -print | sort"; }
# Compiled Python files of other packages come as these are used.
files | grep -v __pycache__ >"$logs/$name-before.txt"
display='xvfb-run -a -s "-screen 0 1600x1000x24 -noreset"'

say "Installing the package"
inside "DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends ./isthmus.deb" \
  >"$logs/$name-install.log" 2>&1
say "pvpython"
inside "$display pvpython check_package.py"
say "The window"
inside "ISTHMUS_DEFAULT_DATA_DIR=/shared/data ISTHMUS_TEST_OUTPUT_DIR=/isthmus/output $display \
  pvpython Python/Toolbar.py map_to_curvature"
cp "$root/isthmus/output/Toolbar/map_to_curvature/window.png" "$logs/$name-window.png"

say "Removing the package"
inside "DEBIAN_FRONTEND=noninteractive apt-get purge -q -y isthmus" >"$logs/$name-remove.log" 2>&1
files | grep -v -e __pycache__ >"$logs/$name-after.txt"
if ! diff "$logs/$name-before.txt" "$logs/$name-after.txt" || inside "find / -xdev -iname '*isthmus*' \
    -not -path '/isthmus*' -not -path '/root/*' -not -path '/proc/*' -not -path /etc/apt/apt.conf.d/90isthmus \
    -not -path '/var/log/*' -print" | grep .; then
  echo "Removal left the files above, or took others with it." >&2
  exit 1
fi
if inside "$display pvpython check_package.py" >"$logs/$name-removed.log" 2>&1; then
  echo "The plugin still loads after removal." >&2
  exit 1
fi
echo "$(basename "$package") works on $suite, and removal leaves nothing."
