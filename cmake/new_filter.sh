#!/usr/bin/env bash
# A new filter with everything that belongs to it, from cmake/new_filter: algorithm, VTK class with its
# table of output arrays, panel, the guide's page, tests, benchmark, its names in the module's
# CMakeLists.txt and README. It compiles; its tests fail with
# "write me" until somebody does.
# Usage: cmake/new_filter.sh NAME MODULE     (NAME as in vtkNAME; MODULE: a folder of Filters)
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
templates=$root/cmake/new_filter
name=${1:-} module=${2:-}

refuse() { echo "$*" >&2; exit 1; }
[ $# -eq 2 ] || refuse "Usage: cmake/new_filter.sh NAME MODULE"
[[ $name =~ ^[A-Z][A-Za-z0-9]+$ ]] || refuse "$name: a name has letters and digits and begins with a capital, without vtk."
[ -f "$root/Filters/$module/vtk.module" ] ||
  refuse "$module is not a module of Filters. Modules: $(cd "$root/Filters" && dirname -- */vtk.module | tr '\n' ' ')"
if find "$root/Filters" "$root/Readers" "$root/Plugin" \( -name "$name.*" -o -name "vtk$name.*" \) | grep .; then
  refuse "$name is there already: take another name."
fi

# HighOrderDiffusion -> High Order Diffusion, for the menu.
title=$(sed -E 's/([a-z0-9])([A-Z])/\1 \2/g; s/([A-Z]+)([A-Z][a-z])/\1 \2/g' <<<"$name")

# fill TEMPLATE FILE
fill()
{
  mkdir -p "$(dirname "$root/$2")"
  sed -e "s/@NAME@/$name/g" -e "s/@TITLE@/$title/g" -e "s/@FOLDER@/$module/g" \
    -e "s/@FOLDER_UPPER@/${module^^}/g" "$templates/$1" >"$root/$2"
  echo "$2"
}
fill algorithm.h.in "Filters/$module/$name.h"
fill algorithm.cxx.in "Filters/$module/$name.cxx"
fill filter.h.in "Filters/$module/vtk$name.h"
fill filter.cxx.in "Filters/$module/vtk$name.cxx"
fill panel.xml.in "Plugin/$name.xml"
fill page.md.in "Documentation/filters/$name.md"
fill unit.cxx.in "Testing/Unit/$module/Test$name.cxx"
fill python.py.in "Testing/Python/$name.py"
fill benchmark.cxx.in "Testing/Benchmarks/Bench$name.cxx"

# Lines break where the name's length makes them.
if command -v clang-format >/dev/null; then
  (cd "$root" && clang-format -i "Filters/$module/"{,vtk}"$name".{h,cxx} \
    "Testing/Unit/$module/Test$name.cxx" "Testing/Benchmarks/Bench$name.cxx")
fi

# list_in KIND WORD: as the first of its kind in the module's CMakeLists.txt.
sources=$root/Filters/$module/CMakeLists.txt
list_in()
{
  if grep -q "^  $1\$" "$sources"; then
    sed -i "s/^  $1\$/&\n    $2/" "$sources"
  else
    sed -i "0,/^isthmus_add_module(.*/s//&\n  $1\n    $2/" "$sources"
  fi
}
list_in SOURCES "$name"
list_in HEADERS "$name" # vtk$name.h includes it
list_in CLASSES "vtk$name"
echo "Filters/$module/CMakeLists.txt: vtk$name, $name"

# The first table of the README says what each file of the module is.
sed -i "0,/^|---|---|\$/s//&\n| \`vtk$name\`, \`$name\` | write me |/" "$root/Filters/$module/README.md"
echo "Filters/$module/README.md: a line for both"
