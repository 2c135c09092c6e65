"""Which of the long cases of a test run now; the twin of Testing/Unit/Core/LongTests.h.

All of them with ISTHMUS_LONG_TESTS=1; else those whose turn it is by ISTHMUS_TURN, which
Testing/run.sh sets to the commit's date; without it none.
"""

import os

ALL = os.environ.get("ISTHMUS_LONG_TESTS") == "1"
TURN = os.environ.get("ISTHMUS_TURN")


def share(cases, hands):
    """Those of `cases` that run now, where `hands` landings run all of them; says which."""
    cases = list(cases)
    if ALL:
        chosen, why = cases, "ISTHMUS_LONG_TESTS=1: all"
    elif TURN:
        turn = int(TURN) % hands
        chosen = [case for i, case in enumerate(cases) if i % hands == turn]
        why = f"turn {turn + 1} of {hands}"
    else:
        chosen, why = [], "ISTHMUS_TURN is not set"
    print(f"long cases: {len(chosen)} of {len(cases)} ({why}): {chosen}", flush=True)
    return chosen
