#!/usr/bin/env python3
"""other_systems.py finds what does not compile on another system, and says so when it cannot look.

    test_other_systems.py BUILD
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "Builds"))
import other_systems  # noqa: E402

ROOT = other_systems.ROOT
SCRIPT = ROOT / "Testing/Builds/other_systems.py"
BUILD = pathlib.Path(sys.argv.pop()).resolve()


class OtherSystems(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.system = other_systems.System("trixie")
        cls.flags = dict(other_systems.sources_of(BUILD))

    @classmethod
    def tearDownClass(cls):
        cls.system.lock.close()

    def test_a_call_that_one_version_of_cgal_lacks(self):
        """property_map() of CGAL returns a pair in CGAL 5 and an optional in CGAL 6."""
        checker = other_systems.Checker(self.system, BUILD)
        source = ROOT / "Filters/Remeshing/SurfaceBoolean.cxx"
        text = source.read_text()
        undone = text.replace("GetOrigins(joined)", 'joined.property_map<Face, Origin>("f:origin").first')
        self.assertNotEqual(undone, text)
        line = undone[:undone.index("joined.property_map")].count("\n") + 1
        messages, _ = checker.check(source, self.flags[source], undone)
        self.assertIn(f"Debian 13: Filters/Remeshing/SurfaceBoolean.cxx:{line}:",
                      other_systems.errors_of(self.system, source, messages))

    def test_results_are_used_again_until_a_header_changes(self):
        checker = other_systems.Checker(self.system, BUILD)
        source = ROOT / "Filters/Core/UnitScale.cxx"
        text = source.read_text() + f"// {os.getpid()}\n"
        self.assertEqual(checker.check(source, self.flags[source], text), ("", True))
        self.assertEqual(checker.check(source, self.flags[source], text), ("", False))
        checker.hashes = {name: value + "0" for name, value in checker.hashes.items()}
        self.assertEqual(checker.check(source, self.flags[source], text)[1], True)

    def test_an_archive_that_does_not_answer_is_a_failure(self):
        with tempfile.TemporaryDirectory() as cache:
            environment = {**os.environ, "ISTHMUS_MIRROR": "http://127.0.0.1:9/debian", "ISTHMUS_CACHE_DIR": cache}
            done = subprocess.run([sys.executable, "-B", str(SCRIPT), "testing", str(BUILD)], capture_output=True,
                                  text=True, env=environment)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Debian testing: the headers cannot be fetched. apt-get update failed for http://127.0.0.1:9/debian", done.stderr)


if __name__ == "__main__":
    unittest.main()
