"""How long ParaView's Python and window take to start with and without the plugin, and isthmus to import.

Usage: start_up.py RESULT.json, with PV_PLUGIN_PATH and PYTHONPATH set as for any script. The median
of seven starts each, in turn, after one that is not counted. For the window, which runs under xvfb-run, it is the CPU time
until it is idle for the first time; it is then closed.
"""

import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TURNS = 7


def seconds(words, plugin):
    environment = dict(os.environ)
    if not plugin:
        environment.pop("PV_PLUGIN_PATH", None)
    start = time.monotonic()
    subprocess.run(words, env=environment, check=True, capture_output=True)
    return time.monotonic() - start


def window_seconds(plugin):
    with tempfile.TemporaryDirectory() as folder:
        events = Path(folder) / "events.xml"
        events.write_text('<?xml version="1.0" ?>\n<pqevents>\n  <pqevent object="pqClientMainWindow" command="pause" '
                          'arguments="1"/>\n</pqevents>\n')
        environment = dict(os.environ, HOME=folder, XDG_RUNTIME_DIR=folder)
        if not plugin:
            environment.pop("PV_PLUGIN_PATH", None)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(["xvfb-run", "-a", "paraview", "--dr", f"--test-script={events}", f"--test-directory={folder}", "--exit"],
                       env=environment, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def python_says(text):
    """What a program of Python measures itself: the start of the interpreter is not in it."""
    words = ["/usr/bin/python3", "-c", f"import time; t = time.monotonic(); {text}; "
             "print(time.monotonic() - t)"]
    return float(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def main(path):
    pvpython = ["pvpython", "--force-offscreen-rendering", "-c", "import paraview.simple"]
    trials = {
        "pvpython": lambda: seconds(pvpython, plugin=False),
        "pvpython with the plugin": lambda: seconds(pvpython, plugin=True),
        "paraview": lambda: window_seconds(plugin=False),
        "paraview with the plugin": lambda: window_seconds(plugin=True),
        "import vtkCommonCore": lambda: python_says("import vtkmodules.vtkCommonCore"),
        "import isthmus": lambda: python_says("import isthmus"),
    }
    times = {name: [] for name in trials}
    for turn in range(TURNS + 1):
        for name, trial in trials.items():
            took = trial()
            if turn > 0:
                times[name].append(took)
    rows = [{"name": name, "real_time": statistics.median(took), "time_unit": "s"}
            for name, took in times.items()]
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"benchmarks": rows}, file)


if __name__ == "__main__":
    main(sys.argv[1])
