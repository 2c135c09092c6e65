#!/usr/bin/env bash
# All benchmarks of goals.csv in one table: what, ours, peer or limit, ratio, goal, met or not.
# Usage: Testing/Benchmarks/run.sh [--anyway] [--no-build] [NAME...]
#
# NAME         only the benchmarks whose name contains one of these (BenchChokingLoops, start_up)
# --anyway     also on a machine that is busy, where times say little
# --no-build   measures what is built already in ISTHMUS_BUILD_DIR (default build)
# ISTHMUS_PEERS  folder of the programs of others that PeerPrograms.h lists
# OpenVolumeMesh is a peer where cmake was given -DOpenVolumeMesh_DIR=FOLDER once (see CMakeLists.txt).
# The table goes to the terminal and to benchmarks/table.md in the build folder, with what each
# benchmark said beside it.
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/setup.sh"
here=$source_dir/Testing/Benchmarks

anyway=no build=yes
while [[ ${1:-} == --* ]]; do
  case $1 in
    --anyway) anyway=yes ;;
    --no-build) build=no ;;
    *) echo "Unknown option $1: --anyway and --no-build are known." >&2; exit 2 ;;
  esac
  shift
done

# Hundredths of all processors' time that went to anything in the next three seconds.
busy_per_cent()
{
  local before after
  before=($(head -n 1 /proc/stat)); sleep 3; after=($(head -n 1 /proc/stat))
  local idle=$((after[4] + after[5] - before[4] - before[5])) all=0 i
  for i in {1..8}; do all=$((all + after[i] - before[i])); done
  echo $((100 - 100 * idle / all))
}

if [ $build = yes ]; then
  install_packages "${build_packages[@]}" "${paraview_packages[@]}" "${test_packages[@]}" \
    "${peer_packages[@]}"
  configure_and_build -DISTHMUS_BENCHMARKS=ON -DCMAKE_BUILD_TYPE=Release
fi
use_build_tree

busy=$(busy_per_cent)
if [ "$busy" -gt 5 ] && [ $anyway = no ]; then
  echo "This machine is busy ($busy % of its processors' time): its times would say little." \
    "End what runs, or add --anyway." >&2
  exit 1
fi

results=$build_dir/benchmarks
mkdir -p "$results"
export ISTHMUS_DATA_DIR=${ISTHMUS_DATA_DIR:-$source_dir/../shared/data}
python=/usr/bin/python3
"$python" -B "$here/table.py" --list "$here/goals.csv" "$@" | while IFS=$'\t' read -r name rows; do
  say "$name" >&2
  result=$results/$name.json
  rm -f "$result"
  if [[ $name == *.py ]]; then
    "$python" -B "$here/$name" "$result"
  else
    "$build_dir/Testing/Benchmarks/$name" "--benchmark_filter=$rows" \
      "--benchmark_out=$result" --benchmark_out_format=json
  fi >"$results/$name.log" 2>&1 || echo "$name failed: $results/$name.log" >&2
done

{
  echo "$(date -u +%F), $(git -C "$source_dir" rev-parse --short HEAD 2>/dev/null || echo 'no commit')," \
    "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $jobs processors, $busy % busy before"
  echo
  "$python" -B "$here/table.py" "$here/goals.csv" "$results" "$@"
} | tee "$results/table.md"
