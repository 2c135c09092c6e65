#!/usr/bin/env bash
# Builds the peers of BenchScalarPersistence that Debian does not package, from their sources:
#   Testing/Benchmarks/Peers/build.sh FOLDER [--ttk SOURCE] [--cubical-ripser SOURCE]
# SOURCE is a clone of github.com/topology-tool-kit/ttk (1.2 or newer; its base layer without VTK,
# needs libboost-dev) or of github.com/shizuo-kaji/CubicalRipser_3dim. A few minutes for TTK, half a
# minute for the other. Then
#   ISTHMUS_PEERS=FOLDER build/Testing/Benchmarks/BenchScalarPersistence --benchmark_filter=Peers
# Both on one thread and for this machine's processor; ours is built for any.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
usage="usage: build.sh FOLDER [--ttk SOURCE] [--cubical-ripser SOURCE]"
into=${1:?$usage}
shift
mkdir -p "$into"
into=$(cd "$into" && pwd)
compile=(${CXX:-c++} -O3 -DNDEBUG -march=native -w)

build_ttk()
{
  local base=$1/core/base work=$into/ttk.build
  [ -f "$base/discreteMorseSandwich/DiscreteMorseSandwich.h" ] ||
    { echo "$1 is no source tree of TTK with its Discrete Morse Sandwich (1.2 or newer)." >&2; exit 1; }
  mkdir -p "$work"
  cp "$base/skeleton/CellArray_new.h" "$work/CellArray.h"
  local options=(-std=c++17 -DTTK_ENABLE_KAMIKAZE -DTTK_CELL_ARRAY_NEW -I"$work" -I"$here")
  local folder
  for folder in "$base"/*/; do
    options+=("-I$folder")
  done
  local source objects=()
  for source in common/{BaseClass,Debug,Os} geometry/Geometry \
    abstractTriangulation/AbstractTriangulation regularGridTriangulation/RegularGridTriangulation \
    implicitTriangulation/{ImplicitTriangulation,ImplicitPreconditions} \
    discreteGradient/DiscreteGradient discreteMorseSandwich/DiscreteMorseSandwich; do
    objects+=("$work/${source##*/}.o")
    "${compile[@]}" "${options[@]}" -c "$base/$source.cpp" -o "$work/${source##*/}.o"
  done
  "${compile[@]}" "${options[@]}" "$here/ttk_grid_persistence.cxx" "${objects[@]}" \
    -o "$into/ttk_grid_persistence"
}

build_cubical_ripser()
{
  [ -f "$1/src/cubicalripser.cpp" ] ||
    { echo "$1 is no source tree of Cubical Ripser." >&2; exit 1; }
  "${compile[@]}" -std=c++20 "$1"/src/{cubicalripser,dense_cubical_grids,coboundary_enumerator,joint_pairs,compute_pairs}.cpp \
    -o "$into/cubicalripser"
}

while [ $# -gt 0 ]; do
  source=${2:?$usage}
  case $1 in
    --ttk) build_ttk "$source" ;;
    --cubical-ripser) build_cubical_ripser "$source" ;;
    *) echo "$usage" >&2; exit 1 ;;
  esac
  shift 2
done
ls -l "$into"
