"""table.py on results made here: goals met, missed and not measured; every goal names what exists."""

import json
import re
import tempfile
import unittest
from pathlib import Path

import table

HERE = Path(__file__).parent
KEYS = ("what", "benchmark", "row", "ours", "unit", "against", "against row", "against key", "goal")


def goal(**given):
    return {**dict.fromkeys(KEYS, ""), "what": "w", "benchmark": "Bench", "unit": "s", **given}


def with_headers(source):
    """What a benchmark says, and its headers beside it."""
    text = source.read_text(encoding="utf-8")
    headers = [HERE / name for name in re.findall(r'^#include "([^"]+)"', text, re.MULTILINE)]
    return text + "".join(header.read_text(encoding="utf-8") for header in headers if header.exists())


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        rows = [
            {"name": "Ours/8/real_time", "real_time": 50.0, "time_unit": "ms", "rate": 3e6},
            {"name": "Ours/80", "real_time": 9.0, "time_unit": "s"},
            {"name": "Peer", "real_time": 0.1, "time_unit": "s"},
            {"name": "Broken", "real_time": 1.0, "time_unit": "s", "error_occurred": True},
            {"name": "Gone", "real_time": 0, "time_unit": "s", "error_occurred": True,
             "error_message": "missing: libgone-dev"},
        ]
        Path(folder.name, "Bench.json").write_text(json.dumps({"benchmarks": rows}))
        self.results = table.Results(folder.name)

    def last(self, **given):
        return table.line(goal(**given), self.results)

    def test_ratio_against_a_peer(self):
        peer = {"row": "Ours/8", "ours": "seconds", "against": "p", "against row": "Peer",
                "against key": "seconds"}
        self.assertEqual(self.last(goal="ratio <= 0.5", **peer)[1:4], ["50 ms", "p: 0.1 s", "0.5"])
        self.assertEqual(self.last(goal="ratio <= 0.5", **peer)[-1], "met")
        self.assertEqual(self.last(goal="ratio <= 0.49", **peer)[-1], "**not met**")
        self.assertEqual(self.last(goal="difference <= -0.06", **peer)[-1], "**not met**")

    def test_counter_and_no_goal(self):
        self.assertEqual(self.last(row="Ours/8", ours="rate", unit="n/s", goal="ours >= 4e6")[-1],
                         "**not met**")
        self.assertEqual(self.last(row="Ours/80", ours="seconds")[-1], "")

    def test_what_did_not_run_is_told(self):
        for row, key in (("Absent", "seconds"), ("Ours/8", "absent"), ("Broken", "seconds")):
            self.assertEqual(self.last(row=row, ours=key, goal="ours <= 1")[-1], "not measured")
        other = table.line(goal(benchmark="Absent", row="Ours/8", ours="seconds"), self.results)
        self.assertEqual(other[1], "not measured")

    def test_a_missing_peer_is_named(self):
        line = self.last(row="Ours/8", ours="seconds", against="p", goal="ratio <= 1",
                         **{"against row": "Gone", "against key": "seconds"})
        self.assertEqual(line[1:], ["50 ms", "p: missing: libgone-dev", "", "ratio <= 1", "not measured"])
        self.assertEqual(self.last(row="Gone", ours="seconds")[1], "missing: libgone-dev")

    def test_goals_name_what_exists(self):
        goals = table.read_goals(HERE / "goals.csv", [])
        for one in goals:
            source = HERE / one["benchmark"]
            source = source if source.suffix == ".py" else source.with_suffix(".cxx")
            text = with_headers(source)
            for key in (one["ours"], one["against key"]):
                known = key in ("", "seconds") or key.split()[-1] in text
                self.assertTrue(known, f"{source.name} has no counter {key}")
            if one["goal"]:
                self.assertRegex(one["goal"], r"^(ours|ratio|difference) [<>]= [-0-9.e]+$")

    def test_filters_take_whole_names(self):
        pattern = table.filters([goal(row="A<b>/8")])["Bench"]
        self.assertTrue(re.match(pattern, "A<b>/8/real_time"))
        self.assertFalse(re.match(pattern, "A<b>/80"))


if __name__ == "__main__":
    unittest.main()
