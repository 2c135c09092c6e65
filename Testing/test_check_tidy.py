#!/usr/bin/env python3
"""check_tidy.py finds planted faults by the checks of .clang-tidy, and nothing in tidy sources."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

TESTING = pathlib.Path(__file__).resolve().parent
BASE = "struct Base\n{\n  virtual ~Base() = default;\n  virtual int Number() const;\n};\n"
TIDY = ('#include "Tidy.h"\n#include <optional>\nstd::optional<int> Known;\n'
        "int Twice(int x)\n{\n  return 2 * x;\n}\n")
HALF = "double Half(int x)\n{\n  return 0.5 + x / 2;\n}\n"


@unittest.skipUnless(shutil.which("clang-tidy"), "clang-tidy is not installed")
class CheckTidy(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        shutil.copy(TESTING.parent / ".clang-tidy", self.root)
        self.write("Tidy.h", "#pragma once\nint Twice(int x);\n" + BASE)
        self.write("Tidy.cxx", TIDY)
        self.git("init", "-q")
        self.commit()

    def write(self, name, text):
        path = self.root / "Filters/Core" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        entries = [{"directory": str(self.root), "file": str(source),
                    "command": f"c++ -Wall -Werror -o x.o -c {source}"}
                   for source in sorted(path.parent.glob("*.cxx"))]
        (self.root / "compile_commands.json").write_text(json.dumps(entries))

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *words],
                       check=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "a landing")

    def run_check(self, *words, **environment):
        return subprocess.run(
            [sys.executable, "-B", TESTING / "check_tidy.py", "--root", self.root, "--build", self.root,
             *words], capture_output=True, text=True, env={**os.environ, **environment})

    def assert_finds(self, *texts):
        done = self.run_check()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for text in texts:
            self.assertIn(text, done.stdout)

    def test_sources_compiled_in_groups(self):
        self.write("Loop.cxx", "int Last(int n)\n{\n  for (short i = 0; i < n; ++i) {}\n  return n;\n}\n")
        group = self.root / "Unity/unity_0_cxx.cxx"
        group.parent.mkdir()
        group.write_text("".join(f'#include "{path}"\n' for path in (self.root / "Filters/Core").glob("*.cxx")))
        (self.root / "compile_commands.json").write_text(json.dumps(
            [{"directory": str(self.root), "file": str(group), "command": f"c++ -o x.o -c {group}"}]))
        self.assert_finds("Filters/Core/Loop.cxx:3", "2 of 2 sources")

    def test_tidy_tree(self): # of C++17, which the commands do not say
        done = self.run_check()
        self.assertEqual((done.returncode, done.stdout),
                         (0, "1 of 1 sources looked at (of 1 in all), 0 complaints\n"), done.stderr)

    def test_use_after_move(self):
        self.write("Moved.cxx", "#include <string>\n#include <utility>\nstd::string Kept;\n"
                   "bool Keep(std::string s)\n{\n  Kept = std::move(s);\n  return s.empty();\n}\n")
        self.assert_finds("Filters/Core/Moved.cxx:7:10: error", "[bugprone-use-after-move")

    def test_division_that_loses_what_it_is_for(self):
        self.write("Half.cxx", HALF)
        self.assert_finds("Half.cxx:3:", "[bugprone-integer-division")

    def test_copy_in_a_loop(self):
        self.write("Copies.cxx", "#include <string>\n#include <vector>\n"
                   "int Sum(const std::vector<std::string>& words)\n{\n  int sum = 0;\n"
                   "  for (const auto word : words)\n  {\n    sum += word.size() > 2 ? 1 : 0;\n  }\n"
                   "  return sum;\n}\n")
        self.assert_finds("Copies.cxx:6:", "[performance-for-range-copy")

    def test_override_that_is_not_said_in_a_header(self):
        self.write("Derived.h", "#pragma once\n#include \"Tidy.h\"\nstruct Derived : Base\n{\n"
                   "  virtual int Number() const;\n};\n")
        self.write("Tidy.cxx", TIDY + '#include "Derived.h"\n')
        self.assert_finds("Derived.h:5:", "[modernize-use-override")

    def test_source_that_does_not_compile(self):
        self.write("Tidy.cxx", TIDY + "int x = y;\n")
        self.assert_finds("Tidy.cxx:8:9: error: use of undeclared identifier 'y'")

    def test_what_changed_last_comes_first_and_the_time_is_kept(self):
        self.write("Second.cxx", HALF)
        self.commit()
        done = self.run_check("--seconds", "1e-9")
        self.assertIn("1 of 2 sources looked at (of 2 in all), 1 complaints", done.stdout)
        self.write("Tidy.h", "int Twice(int x);\n") # its source comes before the one of the last commit
        done = self.run_check("--base", "HEAD")
        self.assertIn("1 of 1 sources looked at (of 2 in all)", done.stdout)
        done = self.run_check("--base", "HEAD~1")
        self.assertEqual(done.returncode, 1)
        self.assertIn("2 of 2 sources looked at (of 2 in all), 1 complaints", done.stdout)

    def test_what_changed_since_the_checks_came(self):
        done = self.run_check("--base", "tidy")
        self.assertIn("0 of 0 sources looked at (of 1 in all), 0 complaints", done.stdout)
        self.write("Second.cxx", HALF)
        self.commit()
        done = self.run_check("--base", "tidy")
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 of 1 sources looked at (of 2 in all), 1 complaints", done.stdout)

    def test_files_that_are_named(self):
        self.write("Second.cxx", HALF)
        done = self.run_check(self.root / "Filters/Core/Tidy.h")
        self.assertIn("1 of 1 sources looked at (of 2 in all), 0 complaints", done.stdout)

    def test_no_clang_tidy(self):
        for strict, status in (("1", 1), ("", 77)):
            done = self.run_check(PATH="", ISTHMUS_REQUIRE_DATA=strict)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)

    def test_no_database(self):
        (self.root / "compile_commands.json").unlink()
        done = self.run_check()
        self.assertEqual(done.returncode, 1)
        self.assertIn("cmake", done.stdout)


if __name__ == "__main__":
    if not shutil.which("git"):
        print("git is not installed")
        sys.exit(77)
    unittest.main()
