#!/usr/bin/env python3
"""select_tests.py: every test of a group has its turn, amending changes nothing, dependants are found."""
import collections
import math
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import check_modules
import select_tests

TESTING = pathlib.Path(__file__).resolve().parent
MODULES = check_modules.modules_of(TESTING.parent)


class SelectTests(unittest.TestCase):
    def test_all_of_a_group_run_in_as_many_turns_as_it_says(self):
        tests = [(f"Python.{name}", ["python"]) for name in "ABCDEFGHIJ"] + [("Short", ["unit"])]
        group = select_tests.Group("python", 3)
        group.patterns = ["Python.*"]
        ran = collections.Counter()
        for turn in range(100, 103):
            numbers, later = select_tests.chosen_tests(tests, [group], turn, None, False, False)
            self.assertEqual(len(numbers) + len(later), len(tests))
            self.assertIn(len(numbers), (1 + 3, 1 + 4))
            ran.update(numbers)
        self.assertEqual(ran, {**dict.fromkeys(range(1, 11), 1), 11: 3})

    def test_merges_since_a_test_ran(self):
        group = select_tests.Group("python", 4)
        group.patterns = ["*"]
        tests = [(name, []) for name in "ABCDEFG"]
        where = select_tests.places("ABCDEFG", [group])
        for name in "ABCDEFG":
            since = select_tests.merges_since(*where[name], 50)
            number = "ABCDEFG".index(name) + 1
            ran = [turn for turn in range(40, 51)
                   if number in select_tests.chosen_tests(tests, [group], turn, None, False, False)[0]]
            self.assertEqual(since, 50 - ran[-1])

    def test_modules_subset_and_all_turns(self):
        tests = [("A.Quick", ["unit", "Maps"]), ("A.Long", ["unit", "Maps", "long"]),
                 ("Python.A", ["python", "Maps"]), ("B.Quick", ["unit", "Files"])]
        group = select_tests.Group("long", 7)
        group.patterns = ["A.Long"]
        chosen = lambda *given: select_tests.chosen_tests(tests, [group], *given)[0]  # noqa: E731
        self.assertEqual(chosen(0, ["Maps"], False, True), [1, 2, 3])
        self.assertEqual(chosen(1, ["Maps"], False, False), [1, 3])
        self.assertEqual(chosen(0, ["Maps"], True, True), [1])
        self.assertEqual(chosen(0, None, True, False), [1, 4])
        tests.append(("C.Quick", ["integration", "Integration", "Maps", "Files"]))
        self.assertEqual(chosen(0, ["Files"], False, True), [4, 5])
        self.assertEqual(chosen(0, ["Files"], True, True), [4])  # the other needs all modules
        self.assertEqual(chosen(0, ["Integration"], True, True), [5])
        self.assertEqual(chosen(0, None, True, False), [1, 4, 5])
        tests.pop()
        group.quick = {"A.Long"}
        for turn in range(7):
            self.assertEqual(chosen(turn, ["Maps"], True, False), [1, 2])
        self.assertEqual(chosen(1, None, False, False), [1, 3, 4])

    def test_shares_within_tests_and_turns_of_tests_have_no_common_factor(self):
        hands = set()
        for path in [*(TESTING / "Unit").rglob("Test*.cxx"), *(TESTING / "Integration").glob("Test*.cxx")]:
            hands.update(map(int, re.findall(r'LongCases\w*[ \w]*\("\w*", (\d+)\)', path.read_text())))
        for path in (TESTING / "Python").glob("[A-Z]*.py"):
            hands.update(map(int, re.findall(r"\bshare\([^\n]*, (\d+)\)", path.read_text())))
        self.assertGreater(len(hands), 5)
        for group in select_tests.groups_of(TESTING / "turns.tsv"):
            for number in hands if group.name not in ("builds", "targets") else ():
                self.assertEqual(math.gcd(group.turns, number), 1, f"{group.name} and {number} shares")

    def test_hash(self):
        # Published values of FNV-1a, 32 bits: http://www.isthe.com/chongo/tech/comp/fnv/
        self.assertEqual(select_tests.stable_hash(""), 0x811C9DC5)
        self.assertEqual(select_tests.stable_hash("a"), 0xE40C292C)
        self.assertEqual(select_tests.stable_hash("foobar"), 0xBF9CF968)

    @unittest.skipUnless(shutil.which("git"), "git is not installed")
    def test_turn_of_head_counts_merges(self):
        with tempfile.TemporaryDirectory() as folder:
            def git(*words):
                subprocess.run(["git", "-C", folder, "-c", "user.name=a", "-c", "user.email=a@b", *words],
                               check=True, capture_output=True)

            set_before = os.environ.pop("ISTHMUS_TURN", None)
            try:
                self.assertEqual(select_tests.turn_of_head(folder), 0)
                git("init", "-q")
                git("commit", "-q", "--allow-empty", "-m", "1")
                git("commit", "-q", "--allow-empty", "-m", "2")
                self.assertEqual(select_tests.turn_of_head(folder), 2)
                git("commit", "-q", "--amend", "--allow-empty", "-m", "3", "--date", "2001-01-01T00:00:00")
                self.assertEqual(select_tests.turn_of_head(folder), 2)
                os.environ["ISTHMUS_TURN"] = "41"
                self.assertEqual(select_tests.turn_of_head(folder), 41)
            finally:
                os.environ.pop("ISTHMUS_TURN", None)
                if set_before:
                    os.environ["ISTHMUS_TURN"] = set_before

    @unittest.skipUnless(shutil.which("git"), "git is not installed")
    def test_changed_modules_and_those_that_depend_on_them(self):
        with tempfile.TemporaryDirectory() as folder:
            def git(*words):
                subprocess.run(["git", "-C", folder, "-c", "user.name=a", "-c", "user.email=a@b", *words],
                               check=True, capture_output=True)

            git("init", "-q")
            git("commit", "-q", "--allow-empty", "-m", "1")
            self.assertEqual(select_tests.changed_modules(MODULES, "HEAD", folder), [])
            for name, expected in (("Filters/Solvation/New.cxx", ["Solvation"]),
                                   ("Testing/Unit/Readers/Potentials/TestNew.cxx", {"Potentials"}),
                                   ("Testing/Integration/TestNew.cxx", {"Integration"}),
                                   ("Testing/Python/PoreProfile.py", {"Pockets"})):
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True)
                path.write_text("")
                found = select_tests.changed_modules(MODULES, "HEAD", folder)
                self.assertLessEqual(set(expected), set(found), name)
                path.unlink()
            pathlib.Path(folder, "Filters/Core").mkdir(parents=True)
            pathlib.Path(folder, "Filters/Core/New.h").write_text("")
            self.assertGreaterEqual(len(select_tests.changed_modules(MODULES, "HEAD", folder)), 18)


if __name__ == "__main__":
    unittest.main()
