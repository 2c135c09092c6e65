"""Every filter while memory fails it: the first, second, third ... of its allocations of some kilobytes, one
in each trial. Each trial ends in one error message and an empty output, or in a result where a filter can do
without; never in a signal, which VTK's arrays raise where they can't grow (Core/ArrayMemory.h).

    pvpython FailingAllocations.py [NAME OF A PROXY]...

ISTHMUS_TRIALS (default 25) bounds the trials of a filter, spread over all of its allocations.
"""

import collections
import ctypes
import os
import sys

LIBRARY = os.environ["ISTHMUS_FAILING_MALLOC"]
if LIBRARY not in os.environ.get("LD_PRELOAD", ""):
    os.environ["LD_PRELOAD"] = LIBRARY
    os.execvp("pvpython", ["pvpython", *sys.argv])

import good_data  # noqa: E402
import robustness_trials  # noqa: E402

MOST = int(os.environ.get("ISTHMUS_TRIALS", "25"))
BYTES = 2048  # nothing smaller fails, as no real machine is out of it alone
ALLOCATOR = ctypes.CDLL(LIBRARY)
ALLOCATOR.failing_malloc_arm.argtypes = [ctypes.c_size_t, ctypes.c_long]
ALLOCATOR.failing_malloc_disarm.restype = ctypes.c_long


def trial(name, number):
    """In a child: how many allocations there were, the output's size, the errors."""
    proxy = good_data.made(name)
    algorithm = proxy.GetClientSideObject()
    heard = robustness_trials.Listener(algorithm)
    algorithm.Modified()
    ALLOCATOR.failing_malloc_arm(BYTES, number)
    algorithm.Update()
    seen = ALLOCATOR.failing_malloc_disarm()
    size = robustness_trials.size_of(algorithm.GetOutputDataObject(0))
    return f"{seen} {size} {len(heard.errors)} {' | '.join(heard.errors)}"


def outcome(name, number):
    word, said, _ = robustness_trials.run(lambda: trial(name, number), 30)
    if word != "done":
        return f"{word} {said[-200:]}", 0
    seen, size, errors, _ = said.split(" ", 3)
    if (errors == "0" and size != "0") or number == 0:
        return "result", int(seen)
    if errors == "1" and size == "0":
        return "message", int(seen)
    return f"{errors} errors, output of {size}", int(seen)


def main(names):
    wrong, counts = [], collections.Counter()
    for name in names or good_data.filters():
        _, allocations = outcome(name, 0)
        trials = min(allocations, MOST)
        for i in range(trials):
            number = 1 + i * allocations // trials
            found, _ = outcome(name, number)
            counts[found.split()[0]] += 1
            if found not in ("result", "message"):
                wrong.append(f"{name}, allocation {number} of {allocations}: {found}")
        print(name, allocations, flush=True)
    print(dict(counts))
    assert not wrong, "\n".join(wrong)
    assert counts["message"] > 100 or names


main(sys.argv[1:])
