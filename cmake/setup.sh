# Shared by Examples/run.sh and Testing/run.sh: installs what is missing, configures, builds.
# Sourced, not run. Every function says what it does before it does it.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${ISTHMUS_BUILD_DIR:-$source_dir/build}
jobs=$(nproc)

# Packages of Debian and Ubuntu. A name may be
#   A|B          the first of these that the archive has
#   qt5:A        only where ParaView is linked to this version of Qt
#   vtk9:A       only where ParaView is linked to VTK of another package (from Debian's 6.1 on)
#   optional:A   left out, with a message, where the archive does not have it
#   A-CLANG-B    with the version of the package `clang` for CLANG

# What Isthmus itself is built from and runs with.
build_packages=(
  g++ cmake ninja-build
  paraview paraview-dev python3-paraview
  libbz2-dev zlib1g-dev libisal-dev libeigen3-dev libcgal-dev 'libgemmi-dev|gemmi-dev' tao-pegtl-dev
  nlohmann-json3-dev
  tetgen xvfb xauth)

# What find_package(ParaView) of Debian's paraview-dev asks for without depending on it, and the icons
# of toolbars.
paraview_packages=(
  qt5:qtbase5-dev qt5:libqt5svg5-dev qt5:libqt5opengl5-dev qt5:qttools5-dev qt5:libqt5x11extras5-dev
  qt5:libqt5xmlpatterns5-dev qt5:qtxmlpatterns5-dev-tools
  qt6:qt6-base-dev qt6:qt6-tools-dev qt6:qt6-svg-dev qt6:qt6-5compat-dev qt6:qt6-svg-plugins qt6:xsltproc
  vtk9:libvtk9-dev vtk9:libvtk9-qt-dev
  libopenmpi-dev python3-dev
  libdouble-conversion-dev libexpat1-dev libfreetype-dev libgl2ps-dev libglew-dev
  libhdf5-openmpi-dev libjpeg-dev libpng-dev libtiff-dev liblz4-dev liblzma-dev libnetcdf-dev
  libogg-dev libtheora-dev libxml2-dev libprotobuf-dev protobuf-compiler libutfcpp-dev
  libjsoncpp-dev libpugixml-dev libgdal-dev libavcodec-dev libavformat-dev libavutil-dev
  libswscale-dev libboost-dev libx11-dev libxcursor-dev libgl-dev)

# Without ParaView, on the system's VTK (Testing/Builds/plain_vtk.sh). libvtk9-dev brings VTK's Python
# modules, which are in the way of those of ParaView before Debian 14: a system of its own.
plain_packages=(
  g++ cmake ninja-build libvtk9-dev
  libbz2-dev zlib1g-dev libisal-dev libeigen3-dev libcgal-dev 'libgemmi-dev|gemmi-dev' tao-pegtl-dev
  nlohmann-json3-dev
  tetgen locales libgtest-dev optional:libgudhi-dev)

# What the tests of the window need.
window_packages=(libgtest-dev xdotool imagemagick)

# What the tests compare with and look through.
test_packages=(
  "${window_packages[@]}" libbenchmark-dev python3-scipy python3-gemmi python3-mrcfile pdb2pqr openmpi-bin
  optional:libgudhi-dev optional:python3-gudhi optional:python3-mdanalysis
  debootstrap clang clang-format clang-tidy codespell libclang-rt-CLANG-dev file dpkg-dev locales curl
  optional:chromium optional:libjs-three)

# What the guide is built by (CMake target `guide`): 60 MB.
guide_packages=(
  optional:python3-sphinx optional:python3-myst-parser optional:furo optional:doxygen optional:graphviz
  optional:libjs-mathjax)

# What benchmarks alone compare with: 170 MB.
peer_packages=(libinsighttoolkit5-dev python3-skimage apbs)

say() { printf '\n== %s\n' "$*"; }

# depends_on NAME PATTERN: the part in parentheses of the last dependency of package NAME that matches.
depends_on()
{
  apt-cache depends "$1" 2>/dev/null | sed -nE "s/^ *Depends: $2\$/\\1/p" | tail -n 1
}

# choose_packages NAME...: sets `chosen` to the names that this system's archive has, as explained
# above; ends where it lacks one that is not optional.
choose_packages()
{
  local entry name alternative qt vtk clang archive lacking=() left_out=()
  qt=$(depends_on paraview 'libqt([0-9]+)core.*')
  vtk=$(depends_on paraview 'libvtk([0-9]+).*')
  clang=$(depends_on clang 'clang-([0-9]+)')
  archive=$(for entry in "$@"; do
    printf '%s\n' "${entry#*:}" | tr '|' '\n'
  done | sed "s/CLANG/$clang/" | xargs apt-cache policy 2>/dev/null |
    awk '/^[^ ].*:$/ { name = substr($1, 1, length($1) - 1) }
      /^ +Candidate:/ && $2 != "(none)" { print name }')
  chosen=()
  for entry in "$@"; do
    case $entry in
      qt[0-9]:*) [ "${entry%%:*}" = "qt$qt" ] || continue ;;
      vtk[0-9]:*) [ "${entry%%:*}" = "vtk$vtk" ] || continue ;;
    esac
    name=${entry#*:}
    name=${name/CLANG/$clang}
    for alternative in ${name//|/ }; do
      if grep -qxF -- "$alternative" <<<"$archive"; then
        chosen+=("$alternative")
        continue 2
      fi
    done
    if [ "${entry#optional:}" = "$entry" ]; then
      lacking+=("$name")
    else
      left_out+=("$name")
    fi
  done
  if [ ${#left_out[@]} -gt 0 ]; then
    say "Not in the archive of $(system_name), so tests that compare with them are skipped: ${left_out[*]}"
  fi
  if [ ${#lacking[@]} -gt 0 ]; then
    echo "Not in the archive of $(system_name): ${lacking[*]}. Isthmus is built on Debian 12, 13 and" \
      "testing; elsewhere install what these provide and run again with --no-install." >&2
    exit 1
  fi
}

system_name() { (. /etc/os-release && echo "$PRETTY_NAME") 2>/dev/null || uname -s; }

# install_packages NAME...: installs those that are missing, as root or through sudo.
install_packages()
{
  command -v apt-get >/dev/null || {
    echo "$(system_name) has no apt-get: install what the packages in cmake/setup.sh provide and run" \
      "again with --no-install." >&2
    exit 1
  }
  local as_root=() missing=() name chosen
  if [ "$(id -u)" -ne 0 ]; then
    as_root=(sudo)
  fi
  # A fresh system has no lists of packages, from which the names are chosen.
  if [ -z "$(apt-cache policy paraview 2>/dev/null)" ] && command -v "${as_root[@]:-env}" >/dev/null; then
    "${as_root[@]}" apt-get update -q
  fi
  choose_packages "$@"
  for name in "${chosen[@]}"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed ||
      missing+=("$name")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "All ${#chosen[@]} packages are installed."
    return
  fi
  say "Installing ${#missing[@]} packages on $(system_name): ${missing[*]}"
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    echo "Neither root nor sudo: install the packages above and run again with --no-install." >&2
    exit 1
  fi
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# configure_and_build CMAKE-OPTION... [-- TARGET...]: all targets if none is named; with ccache if it is
# installed.
configure_and_build()
{
  local options=() targets=()
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    options+=("$1")
    shift
  done
  if [ $# -gt 1 ]; then targets=(--target "${@:2}"); fi
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  say "Configuring in $build_dir"
  # ParaView's Python is the system's, whatever else is on PATH.
  mkdir -p "$build_dir"
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 "${options[@]}" \
    >"$build_dir/configure.log" 2>&1 || {
    tail -n 40 "$build_dir/configure.log" >&2
    exit 1
  }
  say "Building with $jobs jobs"
  cmake --build "$build_dir" --parallel "$jobs" "${targets[@]}"
}

# The plugin and the Python module of the build tree, found by ParaView's programs.
use_build_tree()
{
  export PV_PLUGIN_PATH="$build_dir/lib/isthmus/plugins"
  local destination
  destination=$(sed -n 's/^ISTHMUS_PYTHON_DESTINATION:INTERNAL=//p' "$build_dir/CMakeCache.txt")
  export PYTHONPATH="$build_dir/$destination${PYTHONPATH:+:$PYTHONPATH}"
}

# with_display COMMAND...: in the user's display, or in a virtual one where there is none.
with_display()
{
  # Without -noreset, Xvfb starts anew when its first client leaves, and may miss the second.
  if [ -n "${DISPLAY:-}" ]; then "$@"; else xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$@"; fi
}
