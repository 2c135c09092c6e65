#!/usr/bin/env bash
# Isthmus as a plain VTK module on another version of VTK: builds the modules that it needs from a
# source tree of VTK, then Isthmus with warnings and deprecations as errors, and runs the unit tests.
# Usage: Testing/Builds/newer_vtk.sh SOURCE [FOLDER] [ctest arguments]
#
# SOURCE    a source tree of VTK (git clone https://gitlab.kitware.com/vtk/vtk.git)
# FOLDER    where it builds, default build/newer_vtk; what is there already is not built again
# ISTHMUS_REFERENCE_BUILD   a build with tests, on the VTK of Debian's ParaView: what both make of
#                           the shared data is then compared bit by bit (ResultDigests.cxx)
# CMAKE_CXX_COMPILER_LAUNCHER and the like are taken from the environment, as CMake does.
set -euo pipefail

vtk=$(cd "${1:?usage: Testing/Builds/newer_vtk.sh SOURCE [FOLDER] [ctest arguments]}" && pwd)
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${2:-$source_dir/build/newer_vtk}
shift $(($# < 2 ? $# : 2))
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
jobs=$(nproc)

# Its modules are those of our vtk.module files: no rendering but where those bring it along, no wrapping.
modules=()
while IFS= read -r module; do
  modules+=("-DVTK_MODULE_ENABLE_VTK_$module=YES")
done < <(sed -n 's/^ *VTK:://p' "$source_dir"/{Filters,Readers}/*/vtk.module | sort -u)

echo "== VTK $(git -C "$vtk" rev-parse HEAD 2>/dev/null || echo 'of no known commit') from $vtk"
cmake -S "$vtk" -B "$folder/vtk" -G Ninja -DCMAKE_BUILD_TYPE=Release -DVTK_BUILD_ALL_MODULES=OFF \
  -DVTK_GROUP_ENABLE_Rendering=DONT_WANT -DVTK_GROUP_ENABLE_StandAlone=DONT_WANT \
  -DVTK_ENABLE_WRAPPING=OFF -DVTK_BUILD_TESTING=OFF -DVTK_SMP_IMPLEMENTATION_TYPE=STDThread \
  "${modules[@]}" >"$folder/vtk.log"
cmake --build "$folder/vtk" --parallel "$jobs" >>"$folder/vtk.log" ||
  { tail -n 40 "$folder/vtk.log"; exit 1; }

echo "== Isthmus on it"
cmake -S "$source_dir" -B "$folder/isthmus" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DISTHMUS_PARAVIEW=OFF -DISTHMUS_TESTING=ON -DISTHMUS_WERROR=ON \
  "-DISTHMUS_DEFAULT_DATA_DIR=${ISTHMUS_DATA_DIR:-$source_dir/../shared/data}" \
  "-DVTK_DIR=$folder/vtk" >"$folder/isthmus.log"
cmake --build "$folder/isthmus" --parallel "$jobs" -- -k 0 >>"$folder/isthmus.log" ||
  { grep -E 'error:|FAILED' "$folder/isthmus.log"; exit 1; }

failed=0
if [ -n "${ISTHMUS_REFERENCE_BUILD:-}" ]; then
  echo "== The same bits?"
  "$ISTHMUS_REFERENCE_BUILD/Testing/ResultDigests" >"$folder/reference.digests"
  "$folder/isthmus/Testing/ResultDigests" >"$folder/newer.digests"
  if diff "$folder/reference.digests" "$folder/newer.digests"; then
    echo "$(wc -l <"$folder/newer.digests") results, the same bits"
  else
    failed=1
  fi
fi

echo "== Unit tests"
ctest --test-dir "$folder/isthmus" --output-on-failure --parallel "$jobs" "$@" || failed=1
exit $failed
