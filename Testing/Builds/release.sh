#!/usr/bin/env bash
# Checks a release on one version of Debian: a clean root, both commands of README in it, a summary.
# Usage: Testing/Builds/release.sh SUITE [example | window | plain] [ctest arguments]
#
# The commands are ./Examples/run.sh and ./Testing/run.sh, the latter with --all: every test, whatever its
# turn. The shared data are required.
#
# SUITE     bookworm, trixie, testing: a name that debootstrap knows
# example   ./Examples/run.sh alone, and its numbers beside those of Debian 12
# window    example, then ./Testing/run.sh --window: the tests of this ParaView's window
# plain     Isthmus without ParaView on the suite's own VTK (libvtk9-dev): all unit tests
#
# Testing/Builds/tested_versions.py then writes the table of the guide from what is left in the logs.
#
# Needs root, debootstrap and the shared data; takes the committed state, not the working tree.
# ISTHMUS_ROOTS          where roots are kept and used again, as SUITE or SUITE-plain; without it
#                        the root is made in a temporary folder and removed at the end
# ISTHMUS_DATA_DIR       the shared data, by default ../shared/data beside the clone
# ISTHMUS_RELEASE_DIR    where logs and the summary are left, by default build/release
# ISTHMUS_MIRROR         the archive of Debian's packages, by default that of this machine's apt configuration
# CMAKE_CXX_COMPILER_LAUNCHER=ccache: installed in the root, with its cache in $ISTHMUS_ROOTS/ccache
source "$(dirname "${BASH_SOURCE[0]}")/roots.sh"

[ $# -ge 1 ] || usage
case $1 in *[!a-z]*) usage ;; esac
isolate "$@"
suite=$1
shift
name=$suite
kind=paraview
if [ "${1:-}" = plain ]; then
  kind=plain
  name=$suite-plain
  shift
elif [ "${1:-}" = example ] || [ "${1:-}" = window ]; then
  kind=$1
  shift
fi
make_root "$suite" "$name"
clone_into_root
git -C "$root/isthmus" clean -q -x -d -f -f
if [ ${#launcher[@]} -gt 0 ]; then
  inside "apt-get update -q && apt-get install -q -y --no-install-recommends ccache" >"$logs/$name-ccache.log"
fi

failed=0
# Without arguments, all but the tests that look at other systems from Debian 12.
if [ $# -eq 0 ]; then
  set -- -E '^Build\.(OtherSystem|Headers|HeadersTesting)'
fi
arguments=$(printf '%q ' "$@")
if [ $kind != plain ]; then
  say "./Examples/run.sh"
  inside ./Examples/run.sh >"$logs/$name-example.log" 2>&1 || {
    failed=1
    grep -E -A 12 'error:|FAILED' "$logs/$name-example.log" | head -n 60 || true
  }
  tail -n 25 "$logs/$name-example.log"
  # The library and the plugin are those of ./Examples/run.sh.
  say "The main job's numbers beside those of Debian 12"
  inside "source cmake/setup.sh && use_build_tree && with_display pvpython Testing/Builds/main_job_numbers.py \
    build/example build/numbers.json" 2>&1 | tee "$logs/$name-numbers.txt" || failed=1
fi
if [ $kind = window ]; then
  say "./Testing/run.sh --window"
  inside "./Testing/run.sh --window $arguments" >"$logs/$name-window.log" 2>&1 || failed=1
  tail -n 40 "$logs/$name-window.log"
fi
if [ $kind = example ] || [ $kind = window ]; then
  exit $failed
fi
if [ $kind = paraview ]; then
  say "./Testing/run.sh --all"
  inside "./Testing/run.sh --all $arguments" >"$logs/$name-tests.log" 2>&1 || failed=1
else
  say "Isthmus on the VTK of $suite"
  inside "./Testing/Builds/plain_vtk.sh --output-junit /isthmus/build/tests.xml $arguments" \
    >"$logs/$name-tests.log" 2>&1 || failed=1
fi
tail -n 25 "$logs/$name-tests.log"

say "Summary"
rm -f "$logs/$name.xml" "$logs/$name.json"
if [ -e "$root/isthmus/build/tests.xml" ]; then
  cp "$root/isthmus/build/tests.xml" "$logs/$name.xml"
  inside "python3 Testing/Builds/release_summary.py build/tests.xml build/summary.json" | tee "$logs/$name.txt"
  cp "$root/isthmus/build/summary.json" "$logs/$name.json"
else
  echo "No test ran: see $logs/$name-*.log"
  failed=1
fi
exit $failed
