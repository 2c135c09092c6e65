#!/usr/bin/env bash
# Each test that takes turns, with the number of merges since it last ran; see select_tests.py.
# Usage: Testing/turns.sh [BUILD]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
exec python3 -B "$here/select_tests.py" "${1:-${ISTHMUS_BUILD_DIR:-$here/../build}}" --turns
