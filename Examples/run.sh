#!/usr/bin/env bash
# The main job: from a map to a denoised one, a surface coloured by its curvature, a surface and
# tetrahedra fit for computing, and its choking loops; pictures and numbers.
# Usage: Examples/run.sh [--no-install] [MAP [LEVEL]]
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

# Without empty lines: this output is short.
say() { printf '%s\n' "$*"; }

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
use_build_tree
# VTK chooses colours by TERM, even when it writes to a file.
[ -t 2 ] || export TERM=dumb
map=$(/usr/bin/python3 "$source_dir/Examples/choose_map.py" "$output" ${1:+"$1"})

# Each script prints a line for each step to standard error, and to standard output its numbers, which
# are kept for the end.
example() { with_display pvpython "$source_dir/Examples/$1" "${@:2}"; }
curvature=$(example map_to_curvature.py "$map" "$output" ${2:+"$2"})
level=$(/usr/bin/python3 -c \
  'import json, sys; print(json.load(open(sys.argv[1]))["level"]["value"])' "$output/report.json")
meshes=$(example map_to_mesh.py "$map" "$output" "$level")
loops=$(example choking_loops.py "$output/surface_delaunay.vtp" "$output/choking_loops.png" | sed '$d') # without the paths

say
say "$curvature"
say "$meshes"
say "$loops"
say
say "Pictures in $output: curvature.png, denoising.png, angles.png, cutaway.png,"
say "choking_loops.png. Numbers: report.txt, report.json, mesh.txt, choking_loops.txt. For ParaView: pipeline.pvsm."
