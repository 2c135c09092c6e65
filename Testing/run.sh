#!/usr/bin/env bash
# All tests: installs what is missing, builds everything with warnings as errors, runs ctest.
# Usage: Testing/run.sh [--no-install] [--quick | --window] [--module NAME]... [--changed [REVISION]] [ctest arguments]
#
#   --module NAME         build and test one module (Imaging), its long tests as well
#   --changed [REVISION]  the modules with changes since REVISION (default: origin/main), and those that
#                         depend on them
#   --quick               only unit tests that take less than a second, and some of two: under three minutes
#   --window              all tests of ParaView's window, and of the build only what they need
#   --all                 every test, whatever its turn; of long cases within a test still a share
#   --no-install          leave Debian's packages alone
#
# Of the long tests, each run does another share (select_tests.py); ISTHMUS_LONG_TESTS=1: all.
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

install=yes
choice=()
quick=
all=
window=
while [ $# -gt 0 ]; do
  case $1 in
    --no-install) install=no ;;
    --quick) quick=--quick ;;
    --all) all=--all ;;
    --window) window=--window ;;
    --module)
      choice+=(--module "${2:?--module needs the name of a module}")
      shift
      ;;
    --changed)
      case ${2:-} in
        '' | -*) choice+=(--changed origin/main) ;;
        *)
          choice+=(--changed "$2")
          shift
          ;;
      esac
      ;;
    -h | --help)
      sed -n '2,/^[^#]/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit
      ;;
    *) break ;;
  esac
  shift
done
select_tests() { python3 -B "$source_dir/Testing/select_tests.py" "$@"; }

packages=("${build_packages[@]}" "${paraview_packages[@]}")
options=(-DISTHMUS_TESTING=ON)
if [ -n "$window" ]; then
  packages+=("${window_packages[@]}")
  set -- -L window "$@"
else
  packages+=("${test_packages[@]}" "${guide_packages[@]}")
  options+=(-DISTHMUS_WERROR=ON) # compiles anew what ./Examples/run.sh has built
fi
if [ $install = yes ]; then
  install_packages "${packages[@]}"
fi
# The targets that the chosen modules' tests need; without a choice everything is built.
targets=()
if [ -n "$window" ]; then
  targets=(python_tests)
elif [ ${#choice[@]} -gt 0 ] || [ -n "$quick" ]; then
  modules=$(select_tests --modules $quick "${choice[@]}")
  if [ -z "$modules" ]; then
    say "No module has changes."
    exit
  fi
  say "Modules: $modules"
  for module in $modules; do
    targets+=("unit_tests_$module")
    [ -n "$quick" ] || [ "$module" = Integration ] || targets+=("python_tests_$module")
  done
fi
configure_and_build "${options[@]}" -- "${targets[@]}"

# Long cases within a test take turns as well (Unit/Core/LongTests.h).
export ISTHMUS_TURN=${ISTHMUS_TURN:-$(git -C "$source_dir" rev-list --count --first-parent HEAD 2>/dev/null || echo 0)}

say "Testing"
use_build_tree
cd "$build_dir"
select_tests "$build_dir" "${choice[@]}" $quick $all --write "$build_dir/chosen_tests.txt"
# With -R or -L the user chooses: ctest would apply the numbers of -I to what is left.
chosen=(-I "$build_dir/chosen_tests.txt")
for argument in "$@"; do
  case $argument in -R* | -L*) chosen=() ;; esac
done
# ctest's summary comes last, after the causes of failures.
status=0
ctest "${chosen[@]}" --no-tests=error --parallel "$jobs" --output-junit "$build_dir/tests.xml" "$@" |
  tee "$build_dir/ctest.txt" | sed -u '/% tests passed/,$d' || status=$?
python3 -B "$source_dir/Testing/report_tests.py" "$build_dir/tests.xml" "$build_dir/failed"
sed -n '/% tests passed/,$p' "$build_dir/ctest.txt"
exit $status
