#!/usr/bin/env python3
"""check.sh fails for each thing that it looks for itself, and passes a tidy tree."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECKS = ("check_modules", "check_order", "check_contracts", "check_handles", "check_properties",
          "check_readmes", "check_links", "check_guide", "check_idioms", "check_features",
          "check_defaults")  # check_numbers is run as it is
TESTING = pathlib.Path(__file__).parent


def has_clang_format():
    """Of the version whose format check.sh asks for."""
    if not shutil.which("clang-format"):
        return False
    said = subprocess.run(["clang-format", "--version"], capture_output=True, text=True).stdout
    return "version 14." in said


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("Testing/check.sh", (TESTING / "check.sh").read_text())
        for check in CHECKS:  # they have tests of their own
            self.write(f"Testing/{check}.py", "")
        self.write("Testing/check_numbers.py", (TESTING / "check_numbers.py").read_text())
        self.write("Plugin/Good.xml", "<ServerManagerConfiguration/>\n")
        self.write(".clang-format", "BasedOnStyle: LLVM\n")
        self.write("Filters/Good.h", "int good();\n")
        self.git("init", "-q")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def git(self, *words):
        subprocess.run(["git", "-C", self.root, *words], check=True)

    def run_check(self):
        self.git("add", "-A")
        return subprocess.run(["bash", self.root / "Testing/check.sh"], capture_output=True, text=True)

    def assert_complains(self, heading):
        done = self.run_check()
        self.assertEqual((done.returncode, heading in done.stdout), (1, True), done.stdout)

    def test_tidy_tree(self):
        done = self.run_check()
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stdout + done.stderr)

    def test_python_check_that_fails(self):
        self.write("Testing/check_links.py", "import sys\nprint('A dead link')\nsys.exit(1)\n")
        self.assert_complains("A dead link")

    def test_cgal_version(self):
        self.write("Filters/Bad.h", "#if CGAL_VERSION_NR > 1\n#endif\n")
        self.assert_complains("Version checks outside Filters/Remeshing/CGALVersions.h")

    def test_broken_panel(self):
        self.write("Plugin/Bad.xml", "<ServerManagerConfiguration>\n")
        self.assert_complains("Panels that are no XML")

    @unittest.skipUnless(has_clang_format(), "clang-format 14 is not installed")
    def test_format(self):
        self.write("Filters/Bad.h", "int   bad( );\n")
        self.assert_complains("Places that clang-format would change")

    def test_version_check(self):
        self.write("Filters/Bad.h", "#if VTK_MAJOR_VERSION > 8\n#endif\n")
        self.assert_complains("Version checks outside")

    def test_numbers_of_a_locale(self):
        self.write("Filters/Good.cxx", "// snprintf\nconst char* name = \"strtod\";\n"
                   "void warn() { vtkWarningMacro(<< isthmus::TextOf(\"<< is \", 1.5, \";\")); }\n")
        said = self.run_check().stdout
        self.assertNotIn("Core/NumberText.h", said)
        self.assertNotIn("isthmus::TextOf", said)
        for statement in ('std::snprintf(text, 8, "%g", x);', "y = std::strtod(text, nullptr);",
                          "y = std::stod(text);", "std::ostringstream text;", 'sscanf(text, "%d", &i);',
                          'vtkWarningMacro(<< "The level is "\n << level);',
                          'vtkErrorWithObjectMacro(self, << "The level is " << level);'):
            with self.subTest(statement):
                self.write("Filters/Core/Bad.cxx", "void f()\n{\n  " + statement + "\n}\n")
                self.assert_complains("Filters/Core/Bad.cxx:3: ")

    def test_inner_algorithm(self):
        self.write("Filters/Imaging/vtkBad.cxx", "void f() { smoother->Update(); }\n")
        self.assert_complains("Algorithms inside of others whose errors are lost")

    def test_path_of_one_machine(self):
        self.write("Testing/Bad.py", 'DATA = "' + '/ho' + 'me/me/data"\n')
        self.assert_complains("Paths of one machine")

    def test_large_file(self):
        self.write("Testing/large.bin", "0" * 200_001)
        self.assert_complains("Files over 200 KB")


if __name__ == "__main__":
    if not shutil.which("git"):
        print("git is not installed")
        sys.exit(77)
    unittest.main()
