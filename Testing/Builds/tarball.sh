#!/usr/bin/env bash
# The source tarball, `git archive HEAD`, where there is no git: unpacked, configured as in installation.md with the
# tests, the checks of conventions (those that need git are skipped by name), the module Files and its quick unit tests.
# Takes the committed state.
# Usage: Testing/Builds/tarball.sh [--all] FOLDER
#   --all   the whole library and the quick unit tests of all modules: ten minutes of processor time without ccache
# Exit status 77: skipped, since this is no clone or git is not installed.
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scope=module
if [ "${1:-}" = --all ]; then
  scope=all
  shift
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
python=${ISTHMUS_PYTHON:-/usr/bin/python3}

say() { printf '\n== %s\n' "$*"; }
if [ ! -e "$source_dir/.git" ] || ! command -v git >/dev/null; then
  echo "skipped: no clone, or git is not installed"
  exit 77
fi

say "git archive of $(git -C "$source_dir" rev-parse --short HEAD)"
rm -rf "$folder/isthmus" "$folder/build" "$folder/bin"
git -C "$source_dir" archive --prefix=isthmus/ HEAD | tar -x -C "$folder"
cd "$folder"
module=Files

# All programs but git; nor is the clone around the folder found.
mkdir bin
for place in /bin /usr/bin /usr/local/bin; do ln -sf -t bin "$place"/*; done
rm -f bin/git bin/git-*
export PATH=$folder/bin GIT_CEILING_DIRECTORIES=$folder
if command -v git >/dev/null; then
  echo "git is still found." >&2
  exit 1
fi

say "Configuring without git"
launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake -S isthmus -B build -G Ninja "-DPython3_EXECUTABLE=$python" -DISTHMUS_TESTING=ON -DISTHMUS_WERROR=ON \
  "-DISTHMUS_DEFAULT_DATA_DIR=${ISTHMUS_DEFAULT_DATA_DIR:-$source_dir/../shared/data}" "${launcher[@]}" >configure.log 2>&1 || {
  tail -n 40 configure.log >&2
  exit 1
}
version=$(sed -nE 's/^project\(Isthmus VERSION ([0-9.]+).*/\1/p' isthmus/CMakeLists.txt)
grep -q "set(PACKAGE_VERSION \"$version\")" build/IsthmusConfigVersion.cmake || {
  echo "IsthmusConfigVersion.cmake does not have the version $version." >&2
  exit 1
}

say "Checks of conventions"
ctest --test-dir build -L layout --output-on-failure --no-tests=error | tee checks.log
grep -E 'Layout\.check[ .].*Skipped' checks.log >/dev/null || {
  echo "The tests that need git are not skipped by name." >&2
  exit 1
}
status=0
isthmus/Testing/check.sh || status=$?
[ $status -eq 77 ]

if [ $scope = all ]; then
  say "The library and all quick unit tests"
  nice cmake --build build --parallel "${ISTHMUS_JOBS:-$(nproc)}"
  ctest --test-dir build -L "unit|integration" -LE long --output-on-failure --no-tests=error
else
  say "$module and its quick unit tests"
  nice cmake --build build --parallel "${ISTHMUS_JOBS:-$(nproc)}" --target "unit_tests_$module"
  ctest --test-dir build -L "^$module\$" -L unit -LE long --output-on-failure --no-tests=error
fi
