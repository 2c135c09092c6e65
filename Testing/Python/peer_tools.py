"""What the scripts share that run other readers for corpus.py, in another Python."""

import hashlib
import json
import sys


def checksum(numbers, kind):
    """Of numbers as `kind` (numpy's name), the first index fastest for three axes. Any NaN is like another,
    and -0 is 0."""
    import numpy

    numbers = numpy.array(numbers, dtype=kind) + numpy.zeros(1, dtype=kind)
    if numbers.dtype.kind == "f":
        numbers[numpy.isnan(numbers)] = numpy.nan
    order = "F" if numbers.ndim == 3 else "C"
    return hashlib.sha256(numbers.tobytes(order=order)).hexdigest()[:16]


def answer_paths(readers):
    """For each path on standard input a line '@{"path": ..., "peer": ..., "found": ...}' for each reader (name and
    function; None: not its format), as soon as it is known, since the next one may crash; then '@{"path": ...}'."""
    for line in sys.stdin:
        path = line.rstrip("\n")
        for name, read in readers.items():
            try:
                found = read(path)
            except BaseException as error:  # what a peer refuses is a finding, too; chemfiles' errors are no
                # Exceptions, and meshio ends the program
                if isinstance(error, KeyboardInterrupt):
                    raise
                found = f"{type(error).__name__}: {error}"[:200]
            if found is not None:
                print("\n@" + json.dumps({"path": path, "peer": name, "found": found}), flush=True)
        print("\n@" + json.dumps({"path": path}), flush=True)
