"""Which of the long cases of a test run now; the twin of Testing/Unit/Core/LongTests.h.

All of them with ISTHMUS_LONG_TESTS=1; else those whose turn it is by ISTHMUS_TURN, which
Testing/run.sh sets to the number of merges; without it none.
"""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from select_tests import stable_hash  # noqa: E402

ALL = os.environ.get("ISTHMUS_LONG_TESTS") == "1"
TURN = os.environ.get("ISTHMUS_TURN")


def share(cases, hands):
    """Those of `cases` that run now, where `hands` merges run all of them; says which."""
    cases = list(cases)
    if ALL:
        chosen, why = cases, "ISTHMUS_LONG_TESTS=1: all"
    elif TURN:
        turn = (int(TURN) + stable_hash(pathlib.Path(sys.argv[0]).stem)) % hands
        chosen = [case for i, case in enumerate(cases) if i % hands == turn]
        why = f"turn {turn + 1} of {hands}"
    else:
        chosen, why = [], "ISTHMUS_TURN is not set"
    print(f"long cases: {len(chosen)} of {len(cases)} ({why}): {chosen}", flush=True)
    return chosen
