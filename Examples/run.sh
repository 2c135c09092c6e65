#!/usr/bin/env bash
# The main job: from a map to a surface coloured by its curvature, pictures and numbers.
# Usage: Examples/run.sh [--no-install] [MAP [LEVEL]]
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

install=yes
if [ "${1:-}" = --no-install ]; then
  install=no
  shift
fi
if [ $install = yes ]; then
  install_packages "${build_packages[@]}" "${paraview_packages[@]}"
fi
configure_and_build

output=${ISTHMUS_OUTPUT_DIR:-$build_dir/example}
say "From a map to its curvature"
use_build_tree
map=$(/usr/bin/python3 "$source_dir/Examples/ChooseMap.py" "$output" ${1:+"$1"})
with_display pvpython "$source_dir/Examples/MapToCurvature.py" "$map" "$output" ${2:+"$2"}

say "Done. Pictures, numbers, surface and ParaView state are in $output:"
ls "$output"
