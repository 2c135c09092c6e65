#!/usr/bin/env bash
# Everything random, with new seeds, for HOURS on two cores. One of them: fuzz targets under address
# and undefined-behaviour checks; the other: damaged surfaces and volumes through every filter. In
# the last eighth the first takes damaged data as well, and the other re-executes filters and runs
# them on inputs with known answers.
# Usage: Testing/soak.sh HOURS [FOLDER]      (FOLDER, default build/soak, keeps seeds and failures)
#
# ISTHMUS_SOAK_SEED=N   the seed to begin from (default: the time)
# ISTHMUS_SOAK_TIDY=1   clang-tidy over all sources of the library, besides: an hour or more
#
# FOLDER/corpus/X   Testing/Data/fuzz-corpus.tar.xz and what each fuzz target found worth keeping,
#                   taken up again by the next run; Testing/Fuzz/corpus.sh makes the archive of it
# FOLDER/failed/X   inputs that crash, hang or leak: each becomes a unit test
# FOLDER/log/X      what each part said; the last lines of this script's output count
set -uo pipefail

hours=${1:?usage: Testing/soak.sh HOURS [FOLDER]}
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${ISTHMUS_BUILD_DIR:-$source_dir/build}
folder=${2:-$build_dir/soak}
sanitized=${ISTHMUS_SANITIZED_DIR:-$build_dir/Testing/Builds/sanitized}
seconds=$(awk "BEGIN { printf \"%d\", 3600 * $hours }")
seed=${ISTHMUS_SOAK_SEED:-$(date +%s)}
mkdir -p "$folder"/{corpus,failed,log}
failures=0

targets=()
while IFS= read -r target; do targets+=("$target"); done < <(
  find "$sanitized/Testing/Fuzz" -maxdepth 1 -type f -perm -u+x -name 'Fuzz*' 2>/dev/null | sort)
if [ ${#targets[@]} -eq 0 ]; then
  echo "no fuzz targets in $sanitized/Testing/Fuzz: build them with 'ctest -R Build.Sanitized', or" \
    "name a sanitized build in ISTHMUS_SANITIZED_DIR" >&2
  exit 2
fi

share=$((seconds * 7 / 8 / ${#targets[@]}))
[ "$share" -gt 0 ] || share=1
damage_seconds=$((seconds * 7 / 8))
# Keeping longer stacks of each allocation takes a seventh of the time.
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:allocator_may_return_null=1:malloc_context_size=4}

fuzz() {
  local name
  name=$(basename "$1")
  mkdir -p "$folder/corpus/$name" "$folder/failed/$name"
  # A crash ends a process, not the soak: it starts again with the next seed until its time is up.
  local end=$((SECONDS + share)) round=0 patience=10
  # CGAL's remeshing takes some 70 times as long under sanitizers: 0.2 s are 14.
  [ "$name" = FuzzSurfaceFilters ] && patience=60
  while [ $SECONDS -lt $end ]; do
    "$1" "$folder/corpus/$name" -seed=$((seed + round)) -max_total_time=$((end - SECONDS)) \
      -rss_limit_mb=2048 -timeout=$patience -print_final_stats=1 \
      -artifact_prefix="$folder/failed/$name/" >>"$folder/log/$name" 2>&1
    round=$((round + 1))
  done
}

# part SCRIPT SEED ARGUMENT...: one run of a script of Testing/Python, written down when it fails.
part() {
  ISTHMUS_SEED=$2 xvfb-run -a pvpython "$source_dir/Testing/Python/$1.py" "${@:3}" \
    >>"$folder/log/$1" 2>&1 && return
  echo "$1 ${*:3}, ISTHMUS_SEED=$2: see $folder/log/$1" | tee -a "$folder/log/failures"
}

# damage FIRST END: damaged surfaces and volumes, ten at a time from number FIRST on, until END.
damage() {
  local first=$1
  while [ $SECONDS -lt "$2" ]; do
    part RandomDamage "$seed" 10 "$first"
    first=$((first + 10))
  done
}

export PV_PLUGIN_PATH=${PV_PLUGIN_PATH:-$build_dir/lib/isthmus/plugins}
export PYTHONPATH=${PYTHONPATH:-$(echo "$build_dir"/lib/python3*/site-packages)}
export ISTHMUS_PANELS_DIR=$build_dir/panels
for name in RandomDamage Reexecution OracleSurfaces OracleVolumes OracleMolecules failures "${targets[@]##*/}"; do : >"$folder/log/$name"; done
echo "$seed" >>"$folder/log/seeds"
echo "seed $seed, $hours h, ${#targets[@]} fuzz targets, $share s each, damage $damage_seconds s"
(cd "$folder/corpus" && cmake -E tar xf "$source_dir/Testing/Data/fuzz-corpus.tar.xz")
began=$SECONDS
{
  damage 0 $((began + damage_seconds))
  part Reexecution "$seed" 50
  for kind in Surfaces Volumes Molecules; do part "Oracle$kind" "$seed" 200; done
} &
for target in "${targets[@]}"; do
  fuzz "$target"
done
damage 1000000 $((began + seconds))
wait

total=0
for target in "${targets[@]}"; do
  name=$(basename "$target")
  runs=$(awk '/stat::number_of_executed_units/ { n += $2 } END { printf "%d", n }' "$folder/log/$name")
  bad=$(find "$folder/failed/$name" -type f | wc -l)
  total=$((total + runs)) failures=$((failures + bad))
  echo "$name: $runs inputs, $bad kept in $folder/failed/$name"
done
echo "all readers and filters: $total inputs"
grep -h "^soak:" "$folder/log/RandomDamage" "$folder/log/Reexecution" |
  awk '{ surfaces += $3; volumes += $5; runs += $7 } END {
    print surfaces + 0 " damaged surfaces, " volumes + 0 " damaged volumes, " runs + 0 " runs of filters" }'
grep -h "inputs with known answers" "$folder"/log/Oracle*
failures=$((failures + $(wc -l <"$folder/log/failures")))
if [ "${ISTHMUS_SOAK_TIDY:-}" = 1 ] &&
  ! python3 -B "$source_dir/Testing/check_tidy.py" --build "$build_dir" --jobs 2 | tee "$folder/log/tidy"; then
  failures=$((failures + 1))
fi
echo "$failures failures"
[ $failures -eq 0 ]
