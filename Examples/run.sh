#!/usr/bin/env bash
# The main job: from a map to a denoised one, a surface coloured by its curvature, a surface and
# tetrahedra fit for computing, and its choking loops; pictures and numbers.
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
level=$(/usr/bin/python3 -c \
  'import json, sys; print(json.load(open(sys.argv[1]))["level"]["value"])' "$output/report.json")

say "From the map to a Delaunay surface and its tetrahedra"
with_display pvpython "$source_dir/Examples/MapToMesh.py" "$map" "$output" "$level"

say "Choking loops of the surface"
with_display pvpython "$source_dir/Examples/choking_loops.py" "$output/surface_delaunay.vtp" \
  "$output/choking_loops.png"

say "Done. Pictures, numbers, surface and ParaView state are in $output:"
ls "$output"
