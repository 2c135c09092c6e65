"""One table from goals.csv and what Google Benchmark wrote: ours, peer or limit, ratio, goal, met.

table.py --list GOALS [NAME...]      each benchmark with the filter that runs its rows
table.py GOALS RESULTS [NAME...]     the table; RESULTS holds a BENCHMARK.json for each

A key `seconds` is a row's wall time; any other key is one of its counters. A goal compares `ours`,
the `ratio` ours / against or the `difference` ours - against with a number. A row that was not
measured is told as that, never left out.
"""

import csv
import json
import operator
import re
import sys
from pathlib import Path

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
COMPARE = {"<=": operator.le, ">=": operator.ge}


def read_goals(path, names):
    with open(path, newline="", encoding="utf-8") as file:
        goals = list(csv.DictReader(file))
    chosen = [g for g in goals if not names or any(name in g["benchmark"] for name in names)]
    if not chosen:
        raise SystemExit(f"No benchmark of {path} has {' or '.join(names)} in its name.")
    return chosen


def filters(goals):
    """Benchmark -> the regular expression of its rows, in the order of the table."""
    rows = {}
    for goal in goals:
        wanted = rows.setdefault(goal["benchmark"], [])
        for row in (goal["against row"], goal["row"]):
            if row and row not in wanted:
                wanted.append(row)
    return {
        name: "^(" + "|".join(re.escape(row) for row in wanted) + ")(/|$)"
        for name, wanted in rows.items()
    }


class Results:
    """What was measured, by benchmark, row and key."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.runs = {}

    def rows(self, benchmark):
        if benchmark not in self.runs:
            path = self.folder / f"{benchmark}.json"
            try:
                self.runs[benchmark] = json.loads(path.read_text(encoding="utf-8"))["benchmarks"]
            except (OSError, ValueError, KeyError):
                self.runs[benchmark] = []
        return self.runs[benchmark]

    def row(self, benchmark, name):
        for run in self.rows(benchmark):
            if run["name"] == name or run["name"].startswith(name + "/"):
                return run
        return {}

    def value(self, benchmark, row, key):
        """None where the row did not run, failed or lacks the key (a peer that is not there)."""
        run = self.row(benchmark, row)
        if run.get("error_occurred") or not run:
            return None
        if key == "seconds":
            return run["real_time"] * SECONDS[run["time_unit"]]
        return run.get(key)

    def why(self, benchmark, row):
        """What a row that could not be measured says of it: "missing: PACKAGE"."""
        return self.row(benchmark, row).get("error_message", "not measured")


def number(value, unit, without="not measured"):
    if value is None:
        return without
    if unit.endswith("/s"):
        return f"{value / 1e6:.3g} M {unit}"
    return f"{value * 1e3:.3g} ms" if unit == "s" and value < 0.1 else f"{value:.3g} {unit}"


def verdict(goal, ours, against):
    if not goal:
        return ""
    what, sign, bound = goal.split()
    if ours is None or (what != "ours" and against is None):
        return "not measured"
    value = {
        "ours": lambda: ours,
        "ratio": lambda: ours / against,
        "difference": lambda: ours - against,
    }[what]()
    return "met" if COMPARE[sign](value, float(bound)) else "**not met**"


def line(goal, results):
    ours = results.value(goal["benchmark"], goal["row"], goal["ours"])
    against = None
    if goal["against"]:
        against = results.value(goal["benchmark"], goal["against row"], goal["against key"])
    without = results.why(goal["benchmark"], goal["against row"])
    peer = f"{goal['against']}: {number(against, goal['unit'], without)}" if goal["against"] else ""
    ratio = f"{ours / against:.3g}" if ours is not None and against else ""
    return [goal["what"], number(ours, goal["unit"], results.why(goal["benchmark"], goal["row"])),
        peer, ratio, goal["goal"],
        verdict(goal["goal"], ours, against)]


def table(goals, results):
    yield "| what | ours | peer or limit | ours / peer | goal | |"
    yield "|---|---|---|---|---|---|"
    for goal in goals:
        yield "| " + " | ".join(line(goal, results)) + " |"


def main(words):
    if words[:1] == ["--list"]:
        for name, rows in filters(read_goals(words[1], words[2:])).items():
            print(name, rows, sep="\t")
    else:
        print("\n".join(table(read_goals(words[0], words[2:]), Results(words[1]))))


if __name__ == "__main__":
    main(sys.argv[1:])
