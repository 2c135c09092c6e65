#!/usr/bin/env bash
# The VTK modules of Isthmus without ParaView, on the system's own VTK 9.3 or newer (or another:
# ISTHMUS_VTK_DIR), with warnings as errors; then all unit tests. Debian 13 and newer: that of Debian
# 12 is older than the modules need.
# Usage: Testing/Builds/plain_vtk.sh [--no-install] [ctest arguments]
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/setup.sh"

install=yes
if [ "${1:-}" = --no-install ]; then
  install=no
  shift
fi
if [ $install = yes ]; then
  install_packages "${plain_packages[@]}"
fi
configure_and_build -DISTHMUS_PARAVIEW=OFF -DISTHMUS_TESTING=ON -DISTHMUS_WERROR=ON \
  ${ISTHMUS_VTK_DIR:+"-DVTK_DIR=$ISTHMUS_VTK_DIR"}
cd "$build_dir"
say "Unit tests on VTK $(sed -n 's/^VTK_DIR:[A-Z]*=//p' CMakeCache.txt)"
exec ctest --output-on-failure --parallel "$jobs" --label-regex '^unit$' --no-tests=error "$@"
