#!/usr/bin/env bash
# One module and its quick unit tests on Debian 13, in the root that `release.sh trixie` has left in
# $ISTHMUS_ROOTS; another module at each turn. Takes the committed state. Exit status 77: skipped.
# Usage: Testing/Builds/module_in_root.sh [MODULE]
source "$(dirname "${BASH_SOURCE[0]}")/roots.sh"

if [ ! -d "${ISTHMUS_ROOTS:-}/trixie/isthmus/.git" ]; then
  echo "skipped: no root (ISTHMUS_ROOTS=FOLDER Testing/Builds/release.sh trixie makes one in FOLDER)"
  exit 77
fi
if [ "$(id -u)" -ne 0 ]; then
  echo "skipped: needs root to enter $ISTHMUS_ROOTS/trixie"
  exit 77
fi
isolate "$@"
cd "$source_dir"
modules=([FR]*/*/vtk.module)
# This test has every fifth turn (turns.tsv).
module=$(basename "$(dirname "${modules[${ISTHMUS_TURN:-0} / 5 % ${#modules[@]}]}")")
module=${1:-$module}
make_root trixie trixie
clone_into_root /isthmus-module
say "$module on Debian 13"
# Its build folder stays, so that only changes are compiled; without it ccache, as in release.sh.
inside "cd /isthmus-module && nice ./Testing/run.sh --no-install --quick --module $module --output-on-failure"
times
