"""Trials that may crash, hang or eat memory: each in a forked child, under a clock and a bound.

The parent makes the data and loads the plugin once; a trial costs a fork, some milliseconds.
"""

import hashlib
import math
import os
import resource
import signal
import sys
import time
import traceback

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_STRING, vtkSMPTools

import numpy

SECONDS, MEGABYTES = 10.0, 1024

# From VTK 9.3 on, STDThread keeps its threads from one call to the next. A child has none of its parent's threads and
# would wait for them for ever: the parent works on one thread, and each child with what was asked for.
BACKEND, VARIABLE = vtkSMPTools.GetBackend(), "VTK_SMP_BACKEND_IN_USE"
ASKED = os.environ.get(VARIABLE)
vtkSMPTools.SetBackend("Sequential")
os.environ[VARIABLE] = "Sequential"


def run(body, seconds=SECONDS, megabytes=MEGABYTES):
    """What becomes of body() in a child: (word, sentence, seconds).

    The word is 'done' with what body returned, or 'signal', 'time', 'memory', 'failed'. `seconds`
    are of the processors, so that a busy machine judges as an idle one does; what only waits is
    ended after ten times as many by the clock. The bound on memory is on what goes beyond what the
    parent has, by the address space of the child.
    """
    read, write = os.pipe()
    began = time.monotonic()
    child = os.fork()
    if child == 0:
        os.close(read)
        result, code = "", 0
        try:
            with open("/proc/self/statm", encoding="ascii") as pages:
                used = int(pages.read().split()[0]) * resource.getpagesize()
            # Threads' stacks and allocator arenas reserve address space that nothing is ever kept
            # in: room for them beside the bound; the resident set is judged by the parent.
            room = used + (megabytes << 20) + (4 << 30)
            resource.setrlimit(resource.RLIMIT_AS, (room, room))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            null = os.open(os.devnull, os.O_WRONLY)
            os.dup2(null, 1)
            os.dup2(null, 2)
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
            signal.alarm(10 * int(seconds) + 1)
            vtkSMPTools.SetBackend(BACKEND)
            del os.environ[VARIABLE]
            if ASKED is not None:
                os.environ[VARIABLE] = ASKED
            result = str(body())
        except BaseException:  # whatever it is, the parent has to hear of it
            result, code = traceback.format_exc(), 7
        os.write(write, result.encode("utf-8", "replace")[:30000])
        os._exit(code)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        said = pipe.read().decode("utf-8", "replace")
    _, status, usage = os.wait4(child, 0)
    took = time.monotonic() - began
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        late = number in (signal.SIGALRM, signal.SIGXCPU)
        return ("time" if late else "signal"), signal.Signals(number).name, took
    if os.WEXITSTATUS(status) != 0:
        return "failed", said, took
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    if usage.ru_maxrss > own + megabytes * 1024:
        return "memory", f"{usage.ru_maxrss // 1024} MB", took
    return "done", said, took


class Listener:
    """Keeps the sentences of errors and warnings of an algorithm."""

    def __init__(self, algorithm):
        self.errors, self.warnings = [], []
        self._listen(algorithm, "ErrorEvent", self.errors)
        self._listen(algorithm, "WarningEvent", self.warnings)
        if hasattr(algorithm, "GetExecutive"):
            self._listen(algorithm.GetExecutive(), "ErrorEvent", [])

    @staticmethod
    def _listen(who, event, sentences):
        def keep(_, __, sentence):
            sentences.append(sentence)

        keep.CallDataType = VTK_STRING
        who.AddObserver(event, keep)


def leaves(data):
    """The data sets of `data`, which may be of blocks."""
    if data is None:
        return
    if data.IsA("vtkCompositeDataSet"):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            yield iterator.GetCurrentDataObject()
            iterator.GoToNextItem()
    else:
        yield data


def size_of(data):
    return sum(leaf.GetNumberOfElements(kind) for leaf in leaves(data) for kind in range(7))


def print_of(data):
    """A digest of all numbers of a data object."""
    digest = hashlib.sha256()
    for leaf in leaves(data):
        digest.update(leaf.GetClassName().encode())
        if hasattr(leaf, "GetPoints") and leaf.GetPoints() and hasattr(leaf.GetPoints(), "GetData"):
            digest.update(vtk_to_numpy(leaf.GetPoints().GetData()).tobytes())
        if leaf.IsA("vtkPolyData"):
            for cells in (leaf.GetVerts(), leaf.GetLines(), leaf.GetPolys()):
                digest.update(vtk_to_numpy(cells.GetConnectivityArray()).tobytes())
        for kind in ("GetPointData", "GetCellData", "GetRowData", "GetFieldData"):
            fields = getattr(leaf, kind)() if hasattr(leaf, kind) else None
            for i in range(fields.GetNumberOfArrays() if fields else 0):
                array = fields.GetArray(i)
                if array:
                    digest.update((array.GetName() or "").encode())
                    digest.update(vtk_to_numpy(array).tobytes())
    return digest.hexdigest()


def not_finite(data, infinite=()):
    """Names of arrays (and 'points') of `data` with numbers that are none.

    Those in `infinite` may be infinite: of these only NaN counts.
    """
    names = set()
    for leaf in leaves(data):
        points = leaf.GetPoints() if leaf.IsA("vtkPointSet") else None  # from VTK 9.3 on images can make some
        if points and points.GetNumberOfPoints() and not numpy.isfinite(vtk_to_numpy(points.GetData())).all():
            names.add("points")
        for attributes in (getattr(leaf, "GetPointData", None), getattr(leaf, "GetCellData", None)):
            for i in range(attributes().GetNumberOfArrays() if attributes else 0):
                array = attributes().GetArray(i)
                if not array or not array.GetNumberOfValues():
                    continue
                values = vtk_to_numpy(array).astype(float)
                bad = numpy.isnan(values) if array.GetName() in infinite else ~numpy.isfinite(values)
                if bad.any():
                    names.add(array.GetName() or "(unnamed)")
    return names
