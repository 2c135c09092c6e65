# Shared by Examples/run.sh and Testing/run.sh: installs what is missing, configures, builds.
# Sourced, not run. Every function says what it does before it does it.

set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${ISTHMUS_BUILD_DIR:-$source_dir/build}
jobs=$(nproc)

# What Isthmus itself is built from and runs with.
build_packages=(
  g++ cmake ninja-build
  paraview paraview-dev python3-paraview
  libbz2-dev zlib1g-dev libisal-dev libeigen3-dev libcgal-dev gemmi-dev tao-pegtl-dev tetgen xvfb xauth)

# What find_package(ParaView) of Debian's paraview-dev asks for without depending on it.
paraview_packages=(
  qtbase5-dev libqt5svg5-dev libqt5opengl5-dev qttools5-dev libqt5x11extras5-dev
  libqt5xmlpatterns5-dev qtxmlpatterns5-dev-tools libopenmpi-dev python3-dev
  libdouble-conversion-dev libexpat1-dev libfreetype-dev libgl2ps-dev libglew-dev
  libhdf5-openmpi-dev libjpeg-dev libpng-dev libtiff-dev liblz4-dev liblzma-dev libnetcdf-dev
  libogg-dev libtheora-dev libxml2-dev libprotobuf-dev protobuf-compiler libutfcpp-dev
  libjsoncpp-dev libpugixml-dev libgdal-dev libavcodec-dev libavformat-dev libavutil-dev
  libswscale-dev libboost-dev libx11-dev libxcursor-dev libgl-dev)

# What the tests compare with and look through.
test_packages=(
  libgtest-dev libbenchmark-dev libgudhi-dev python3-gudhi python3-gemmi python3-mrcfile
  python3-scipy python3-mdanalysis pdb2pqr openmpi-bin imagemagick xdotool clang clang-format clang-tidy
  libclang-rt-14-dev)

# What benchmarks alone compare with: 170 MB.
peer_packages=(libinsighttoolkit5-dev python3-skimage)

say() { printf '\n== %s\n' "$*"; }

# install_packages NAME...: installs those that are missing, as root or through sudo.
install_packages()
{
  local missing=() name
  for name in "$@"; do
    dpkg-query -W -f '${db:Status-Status}\n' "$name" 2>/dev/null | grep -qx installed ||
      missing+=("$name")
  done
  if [ ${#missing[@]} -eq 0 ]; then
    say "All ${#} packages are installed."
    return
  fi
  say "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "Neither root nor sudo: install the packages above and run again with --no-install." >&2
      exit 1
    }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# configure_and_build CMAKE-OPTION...
configure_and_build()
{
  say "Configuring in $build_dir"
  # ParaView's Python is the system's, whatever else is on PATH.
  mkdir -p "$build_dir"
  cmake -S "$source_dir" -B "$build_dir" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 "$@" \
    >"$build_dir/configure.log" 2>&1 || {
    tail -n 40 "$build_dir/configure.log" >&2
    exit 1
  }
  say "Building with $jobs jobs"
  cmake --build "$build_dir" --parallel "$jobs"
}

# The plugin and the Python module of the build tree, found by ParaView's programs.
use_build_tree()
{
  export PV_PLUGIN_PATH="$build_dir/lib/isthmus/plugins"
  export PYTHONPATH="$build_dir/lib/python3.11/site-packages${PYTHONPATH:+:$PYTHONPATH}"
}

# with_display COMMAND...: in the user's display, or in a virtual one where there is none.
with_display()
{
  # Without -noreset, Xvfb starts anew when its first client leaves, and may miss the second.
  if [ -n "${DISPLAY:-}" ]; then "$@"; else xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "$@"; fi
}
