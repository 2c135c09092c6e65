#!/usr/bin/env bash
# Renews Testing/Data/fuzz-corpus.tar.xz, what the fuzz targets begin from: of the inputs that a soak
# kept, as few as reach the same code (libFuzzer's merge); of these the smallest, which a target goes
# through in some seconds, and 200 KB packed in all.
# Usage: Testing/Fuzz/corpus.sh SANITIZED_BUILD SOAK_FOLDER
set -euo pipefail

sanitized=$(cd "$1" && pwd)
corpora=$(cd "$2/corpus" && pwd)
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
archive=$source_dir/Testing/Data/fuzz-corpus.tar.xz
most=200000
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/all"
declare -A keep

for corpus in "$corpora"/*; do
  name=$(basename "$corpus")
  mkdir "$folder/all/$name"
  "$sanitized/Testing/Fuzz/$name" -merge=1 -timeout=10 -rss_limit_mb=2048 \
    "$folder/all/$name" "$corpus" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; exit 1; }
  began=$SECONDS
  "$sanitized/Testing/Fuzz/$name" -runs=0 "$folder/all/$name" >"$folder/log" 2>&1
  inputs=$(find "$folder/all/$name" -type f | wc -l)
  keep[$name]=$((5 * inputs / (SECONDS - began + 1)))
done

# pack COUNT: so many of the smallest of each, under short names, which would take more room packed
# than most inputs.
pack() {
  rm -rf "$folder/some"
  local name file number
  for name in "${!keep[@]}"; do
    number=0
    mkdir -p "$folder/some/$name"
    while IFS= read -r file; do
      number=$((number + 1))
      [ $number -le "$1" ] && [ $number -le "${keep[$name]}" ] || break
      cp "$folder/all/$name/$file" "$folder/some/$name/$number"
    done < <(ls -rS "$folder/all/$name")
  done
  (cd "$folder/some" && cmake -E tar cJf "$folder/packed" --mtime="2026-01-01 00:00:00" ./*)
}

count=8192
pack $count
while [ "$(stat -c %s "$folder/packed")" -gt $most ]; do
  count=$((count * 7 / 8))
  pack $count
done
cp "$folder/packed" "$archive"
for corpus in "$folder"/some/*; do
  echo "$(basename "$corpus"): $(find "$corpus" -type f | wc -l) inputs" \
    "of $(find "$corpora/$(basename "$corpus")" -type f | wc -l)"
done
echo "$archive: $(stat -c %s "$archive") bytes"
