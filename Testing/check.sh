#!/usr/bin/env bash
# Checks that need no build and take seconds: run it before each commit, or as a hook:
#   ln -s ../../Testing/check.sh .git/hooks/pre-commit
# Programs check what no tool knows: modules, links, the guide, initial values of buttons and menus, the thesis' features.
# Below: format, spelling, phrases, calls that must not be used, absolute paths, sizes.
set -uo pipefail
shopt -s lastpipe # variables set by complain after a pipe must persist
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." || exit 1
# Git lists the files of a clone; a source tarball has none, nor needs it.
if [ ! -e .git ] || ! command -v git >/dev/null; then
  echo "Not a clone, or git is not installed: conventions are not checked."
  exit 77
fi

failed=0
# complain HEADING: prints its standard input, if any, and marks the check as failed.
complain()
{
  local found
  found=$(cat)
  [ -z "$found" ] && return
  printf '%s\n%s\n' "$1:" "$found"
  failed=1
}

for check in check_modules check_links check_guide check_defaults check_features; do
  said=$(python3 -B "Testing/$check.py") || { echo "$said"; failed=1; }
done

for panel in Plugin/*.xml; do
  python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' "$panel" 2>&1 | tail -n 1
done | complain "Panels that are no XML"

# Versions differ in what they make of the same .clang-format.
if clang-format --version 2>/dev/null | grep -q 'version 14\.'; then
  git ls-files '*.h' '*.cxx' | xargs -P "$(nproc)" -n 24 clang-format -n --Werror 2>&1 |
    grep error | cut -d: -f1 | sort | uniq -c | complain "Places that clang-format would change"
else
  echo "clang-format 14 (Debian 12) is not installed: format not checked." >&2
fi

# Names that codespell takes for misspelled words are in words.txt.
if command -v codespell >/dev/null; then
  git ls-files -z '*.h' '*.cxx' '*.py' '*.md' '*.xml' '*.sh' '*.cmake' '*.txt' '*.in' '*.cff' '*.toml' |
    xargs -0 codespell --ignore-words=Testing/words.txt 2>&1 | complain "Misspelled words"
else
  echo "codespell is not installed: spelling not checked." >&2
fi
# Phrases for which the field has a plainer term: in pages, panels, comments, messages.
phrases=$(sed '/^#/d; s/\t.*//' Testing/phrases.tsv | paste -sd'|')
{
  git grep -niP "(?<!\w)(?:$phrases)(?!\w)" -- '*.md' 'Plugin/*.xml' ':!CHANGELOG.md'
  git grep -niP "(//|/\*|^ *\*).*(?<!\w)(?:$phrases)(?!\w)" -- 'Filters/*.h' 'Readers/*.h' 'Plugin/*.h' 'Filters/*.cxx' 'Readers/*.cxx' 'Plugin/*.cxx'
  git grep -niP "\"[^\"]*(?<!\w)(?:$phrases)(?!\w)[^\"]*\"" -- 'Filters/*.cxx' 'Readers/*.cxx' 'Plugin/*.cxx'
} | complain "Phrases to avoid (Testing/phrases.tsv says what to write)"

# Hosts may set a locale with decimal commas: functions of C and streams follow it.
library=('Filters/*.h' 'Filters/*.cxx' 'Readers/*.h' 'Readers/*.cxx' 'Plugin/*.h' 'Plugin/*.cxx')
locale='v?[sfd]?n?printf|v?[sf]?scanf|(str|wcs)to(d|f|ld)|ato[fil]|atoll|std::sto(d|f|ld|i|l|ll|ul|ull)|w?[io]?stringstream|[io]strstream'
{
  git grep -nP "^(?!\s*(//|\*)).*\b($locale|vtkV?LogF|setprecision)\s*[(<]" -- "${library[@]}"
  git grep -nE 'vtk[A-Za-z]*(Error|Warning|Debug)(WithObject)?Macro\(.*<<.*<<' -- "${library[@]}"
} | complain "Numbers as text by the locale: Filters/Core/NumberText.h; one JoinText() for each message"
{
  git grep -n vtkTypeBool -- 'Filters/*.h' 'Readers/*.h' | grep -v ProcessRequest
  git grep -nE 'IsoValue|Isovalue|ContourValue' -- 'Filters/vtk*.h' 'Readers/vtk*.h' 'Plugin/*.xml'
} | complain "Properties: a switch is a bool, an isovalue is Level"

# Differences between VTK versions are handled by calls that all have, or else in one header.
git grep -nIE '(VTK|PARAVIEW)_(VERSION_CHECK|VERSION_NUMBER|MAJOR_VERSION|MINOR_VERSION)' \
  -- '*.h' '*.cxx' ':!Filters/Core/VTKVersions.h' |
  complain "Version checks outside Filters/Core/VTKVersions.h"
git grep -nIE '(CGAL|GEMMI)_VERSION' -- '*.h' '*.cxx' ':!Filters/Remeshing/CGALVersions.h' |
  complain "Version checks outside Filters/Remeshing/CGALVersions.h"
git grep -nE '(->|[.])Update(WholeExtent|Piece|TimeStep)?[(][)]' -- 'Filters/*.cxx' 'Readers/*.cxx' \
  ':!Filters/Core/InnerAlgorithm.cxx' | grep -v 'Advance->Update' |
  complain "Algorithms inside of others whose errors are lost: UpdateInner (Filters/Core/InnerAlgorithm.h)"
git grep -nIE '"/(work|tmp|home|root)/' -- '*.cxx' '*.h' '*.py' '*.md' '*.txt' '*.cmake' '*.xml' |
  complain "Paths of one machine"
git ls-files -z | xargs -0 -r stat -c '%s %n' 2>/dev/null | awk '$1 > 200000' |
  complain "Files over 200 KB"
exit $failed
