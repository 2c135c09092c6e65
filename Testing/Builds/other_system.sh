#!/usr/bin/env bash
# The main job on Debian 13 and on Debian testing, in turn (release.sh SUITE example): linking, wrapping, Qt 6 and the
# other compiler, which the check of the headers (other_systems.py) does not cover. Exit status 77: skipped.
# Usage: Testing/Builds/other_system.sh
folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "skipped: a root of another system needs root and debootstrap"
  exit 77
fi
if ! unshare --mount --pid --fork true 2>/dev/null; then
  echo "skipped: this system does not allow mounts and processes of its own (unshare)"
  exit 77
fi
if [ ! -e "$folder/../../.git" ]; then
  echo "skipped: a root of another system gets a clone, and this is none"
  exit 77
fi
# This test has every fifth turn (turns.tsv).
suites=(trixie testing)
# nice: other tests run beside it, some of which wait for windows.
exec nice "$folder/release.sh" "${suites[${ISTHMUS_TURN:-0} / 5 % ${#suites[@]}]}" example
