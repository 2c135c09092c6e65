"""Every filter again and again: as good as new, stopped at random, on any number of threads.

- random properties, then back: the output is that of a fresh filter, bit for bit;
- memory after many executions is what it was after a few;
- stopped at random moments: within a second, empty output, right again afterwards;
- Sequential and STDThread at 1, 2 and 4 threads: bitwise equal.

ISTHMUS_SEED and the number of re-executions (argument, default 6) are for the soak.
"""

import os
import resource
import sys
import time

import numpy
from vtkmodules.vtkCommonCore import vtkSMPTools

import robustness_trials
from good_data import filters, kinds, made

ROUNDS = int(sys.argv[1]) if len(sys.argv) > 1 else 6
SEED = int(os.environ.get("ISTHMUS_SEED", "1"))


def prints(algorithm):
    return [robustness_trials.print_of(algorithm.GetOutputDataObject(i))
            for i in range(algorithm.GetNumberOfOutputPorts())]


def size(algorithm):
    return robustness_trials.size_of(algorithm.GetOutputDataObject(0))


def switches(proxy):
    """Properties of whole numbers with a small range: what a user clicks through."""
    found = []
    for name in proxy.ListProperties():
        vector = proxy.SMProxy.GetProperty(name)
        if vector and vector.GetClassName() == "vtkSMIntVectorProperty" and vector.GetCommand() \
                and not vector.GetInformationOnly() and vector.GetNumberOfElements() == 1:
            domains = vector.NewDomainIterator()
            domains.Begin()
            while not domains.IsAtEnd():
                domain = domains.GetDomain()
                if domain.IsA("vtkSMBooleanDomain"):
                    found.append((name, [0, 1]))
                elif domain.IsA("vtkSMEnumerationDomain"):
                    found.append((name, [domain.GetEntryValue(i)
                                         for i in range(domain.GetNumberOfEntries())]))
                domains.Next()
    return found


def again(name, kind):
    """Other settings in between leave no trace."""
    random = numpy.random.default_rng(SEED)
    fresh = made(name, kind)
    fresh.SMProxy.UpdatePipeline()
    wanted = prints(fresh.GetClientSideObject())
    proxy = made(name, kind)
    robustness_trials.Listener(proxy.GetClientSideObject())
    choices = switches(proxy)
    for _ in range(ROUNDS):
        before = []
        for property_name, values in choices:
            vector = proxy.SMProxy.GetProperty(property_name)
            before.append((vector, vector.GetElement(0)))
            if random.random() < 0.3:
                vector.SetElement(0, int(random.choice(values)))
        proxy.SMProxy.UpdateVTKObjects()
        proxy.SMProxy.UpdatePipeline()
        for vector, value in before:
            vector.SetElement(0, value)
        proxy.SMProxy.UpdateVTKObjects()
        proxy.SMProxy.UpdatePipeline()
        if prints(proxy.GetClientSideObject()) != wanted:
            return "not as a fresh one"
    return "ok"


def memory(name, kind):
    algorithm = made(name, kind).GetClientSideObject()

    def resident():
        with open("/proc/self/statm", encoding="ascii") as pages:
            return int(pages.read().split()[1]) * resource.getpagesize() / 2**20

    for _ in range(5):
        algorithm.Modified()
        algorithm.Update()
    before = resident()
    began = time.monotonic()
    count = 0
    while count < 4 * ROUNDS and time.monotonic() - began < 5:
        algorithm.Modified()
        algorithm.Update()
        count += 1
    grown = resident() - before
    return "ok" if grown < 30 + 0.02 * before else f"{grown:.0f} MB more after {count} executions"


def stopped(name, kind):
    random = numpy.random.default_rng(SEED)
    algorithm = made(name, kind).GetClientSideObject()
    reports = [0]
    algorithm.AddObserver("ProgressEvent", lambda *_: reports.__setitem__(0, reports[0] + 1))
    algorithm.Update()
    wanted, most = prints(algorithm), max(1, reports[0])
    for _ in range(min(10, ROUNDS)):
        at = [int(random.integers(1, most + 1)), None]

        def stop(who, _):
            at[0] -= 1
            if at[0] == 0:
                who.SetAbortExecute(1)
                at[1] = time.monotonic()

        tag = algorithm.AddObserver("ProgressEvent", stop)
        algorithm.Modified()
        algorithm.Update()
        algorithm.RemoveObserver(tag)
        if at[1] and time.monotonic() - at[1] > 1.0:
            return f"{time.monotonic() - at[1]:.1f} s until a stop was heard"
        # The last report may come when all is done.
        if at[1] and size(algorithm) and prints(algorithm) != wanted:
            return "part of a result after a stop"
        algorithm.SetAbortExecute(0)
        algorithm.Modified()
        algorithm.Update()
        if prints(algorithm) != wanted:
            return "another result after a stop"
    return "ok"


def threads(name, kind):
    found = {}
    for backend, count in (("Sequential", 1), ("STDThread", 1), ("STDThread", 2), ("STDThread", 4)):
        os.environ["VTK_SMP_BACKEND_IN_USE"] = backend  # the user's choice is respected
        vtkSMPTools.SetBackend(backend)
        vtkSMPTools.Initialize(count)
        algorithm = made(name, kind).GetClientSideObject()
        algorithm.Update()
        found[backend, count] = prints(algorithm)
    return "ok" if len(set(map(str, found.values()))) == 1 else f"differs: {list(found)}"


runs, wrong = 0, []
for filter_name in filters():
    for input_kind in kinds(filter_name):
        for body in (again, memory, stopped, threads):
            runs += 1
            word, said, took = robustness_trials.run(
                lambda: body(filter_name, input_kind), seconds=60 + 2 * ROUNDS)
            if word != "done" or said != "ok":
                wrong.append(f"seed {SEED}, {filter_name}({input_kind}), {body.__name__}: {word}, "
                             f"{took:.1f} s: {said[-400:]}")
                print(wrong[-1], flush=True)
print(f"soak: surfaces 0 volumes 0 runs {runs * ROUNDS}")
assert not wrong, f"{len(wrong)} of {runs} trials went wrong"
