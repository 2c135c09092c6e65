#!/usr/bin/env bash
# All tests: installs what is missing, builds everything with warnings as errors, runs ctest.
# Usage: Testing/run.sh [--no-install] [ctest arguments]
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

install=yes
if [ "${1:-}" = --no-install ]; then
  install=no
  shift
fi
if [ $install = yes ]; then
  install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${test_packages[@]}"
fi
configure_and_build -DISTHMUS_TESTING=ON -DISTHMUS_WERROR=ON

# Long tests take turns (Unit/Core/LongTests.h): each commit runs another share, always the same.
export ISTHMUS_TURN=${ISTHMUS_TURN:-$(git -C "$source_dir" log -1 --format=%ct 2>/dev/null || true)}

say "Testing"
use_build_tree
cd "$build_dir"
exec ctest --output-on-failure --parallel "$jobs" "$@"
