#!/usr/bin/env bash
# Gets the data that the tests compare with, from the public repositories they come from:
#   Testing/fetch_data.sh [FOLDER]        (../shared/data beside the clone, if no folder is named)
# Then ISTHMUS_DATA_DIR=FOLDER for the tests. 75 MB. What is there already and right is kept, what
# was cut off goes on where it ended, and nothing is put in place before its SHA-256 is that of
# Data/files.tsv. Ends with 1, and the names, if something is missing.
# ISTHMUS_DATA_SOURCE: another server with the same paths instead of GitHub's.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
into=${1:-$here/../../shared/data}
server=${ISTHMUS_DATA_SOURCE:-https://raw.githubusercontent.com}
command -v curl >/dev/null || {
  echo "fetch_data.sh needs curl: apt install curl" >&2
  exit 1
}
mkdir -p "$into" || exit 1
declare -A commit
while IFS=$'\t' read -r repository full _; do
  commit[$repository/${full:0:8}]=$full
done < <(grep -v '^#' "$here/Data/sources.tsv")

# sum FILE: its SHA-256, of what is packed in it if it is asked for as packed.
sum()
{
  if [ "$2" = packed ]; then gzip -dc "$1" 2>/dev/null; else cat "$1"; fi | sha256sum | cut -d' ' -f1
}

# url WHERE: with the whole commit instead of its first eight digits.
url()
{
  local owner=${1%%/*} rest=${1#*/}
  local name=${rest%%/*}
  rest=${rest#*/}
  local short=${rest%%/*}
  local path=${rest#*/}
  path=${path// /%20}
  echo "$server/$owner/$name/${commit[$owner/$name/$short]:-$short}/${path//#/%23}"
}

# get WHERE PART: all of it, going on with what PART has.
get()
{
  curl -sSfL --retry 3 --retry-delay 1 --connect-timeout 20 -C - -o "$2" "$(url "$1")"
}

missing=()
kept=0 new=0 unpublished=0
while IFS=$'\t' read -r file how where sha; do
  target=$into/$file part=$into/$file.part
  if [ -f "$target" ] && [ "$(sum "$target" "$how")" = "$sha" ]; then
    kept=$((kept + 1))
    continue
  fi
  if [ "$how" = shared ]; then
    unpublished=$((unpublished + 1))
    continue
  fi
  mkdir -p "$(dirname "$target")"
  if [ "$how" = here ]; then
    case $where in
      *.gz) gzip -dc "$here/Data/made/$where" >"$part" ;;
      *) cp "$here/Data/made/$where" "$part" ;;
    esac
  else
    resumed=$([ -s "$part" ] && echo yes)
    said=$(get "$where" "$part" 2>&1)
    result=$?
    # A part that is whole already or of another file: once more, from its beginning.
    if [ -n "$resumed" ] && [ "$(sum "$part" plain)" != "$sha" ]; then
      rm -f "$part"
      said=$(get "$where" "$part" 2>&1)
      result=$?
    fi
    if [ ! -f "$part" ] || { [ $result -ne 0 ] && [ "$(sum "$part" plain)" != "$sha" ]; }; then
      echo "$file: not fetched from $(url "$where"): ${said##*$'\n'}" >&2
      missing+=("$file")
      continue
    fi
  fi
  if [ "$(sum "$part" plain)" != "$sha" ]; then
    echo "$file: what came has another SHA-256 than the table, and is not used." >&2
    rm -f "$part"
    missing+=("$file")
    continue
  fi
  [ "$how" = packed ] && { gzip -9n <"$part" >"$part.gz" && mv "$part.gz" "$part"; }
  mv "$part" "$target" && new=$((new + 1))
done < <(grep -v '^#' "${ISTHMUS_DATA_TABLE:-$here/Data/files.tsv}")

echo "$new fetched, $kept there already, ${#missing[@]} missing, in $into"
[ $unpublished -eq 0 ] || echo "$unpublished files are not public: tests that read them are skipped."
[ -f "$into/molecules/1hew/1hew_potential.dx.gz" ] ||
  echo "molecules/1hew/1hew_potential.dx.gz is made, not fetched: run apbs on in.apbs in that folder, gzip the potential."
[ ${#missing[@]} -eq 0 ]
