#!/usr/bin/env python3
"""report_tests.py finds the cause in what GoogleTest, Python, CMake and sanitizers print."""
import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import report_tests


class ReportTests(unittest.TestCase):
    def test_causes(self):
        python = subprocess.run([sys.executable, "-c", "assert 1 + 1 == 3, 'one and one'"],
                                capture_output=True, text=True).stderr
        for output, expected in (
                ("[ RUN ] A.B\n/src/TestA.cxx:12: Failure\nExpected equality of these values:\n  n\n"
                 "    Which is: 3\n  4\n[  FAILED  ] A.B (0 ms)\n",
                 "TestA.cxx:12: Expected equality of these values: | n | Which is: 3 | 4"),
                (python, "<string>:1: AssertionError: one and one"),
                ("x\nCMake Error at A.cmake:3 (message):\n  no such file\n", "CMake Error at A.cmake:3 (message): no such file"),
                ("a.cxx:3:4: error: expected ';'\nmake: stopped\n", "a.cxx:3:4: error: expected ';'"),
                ("==1==ERROR\nSUMMARY: AddressSanitizer: heap-use-after-free\n", "SUMMARY: AddressSanitizer: heap-use-after-free"),
                ("a\nlast words\n\n", "last words"), ("", "no output")):
            self.assertEqual(report_tests.cause_of(output), expected)
        self.assertEqual(report_tests.cause_of("half way", "Timeout"), "Timeout: half way")

    def test_ctest(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "CTestTestfile.cmake").write_text(
                'add_test(Good true)\nadd_test(Bad/one sh -c "echo some words; exit 3")\n'
                'add_test(Data sh -c "echo ISTHMUS_DATA_DIR is not set; exit 77")\n'
                'add_test(Root sh -c "echo skipped: no root; exit 77")\n'
                'set_tests_properties(Data Root PROPERTIES SKIP_RETURN_CODE 77)\n')
            subprocess.run(["ctest", "--output-junit", folder / "tests.xml"], cwd=folder, capture_output=True)
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                report_tests.main(folder / "tests.xml", folder / "failed")
            self.assertIn("FAILED Bad/one\n  some words\n", said.getvalue())
            self.assertIn("Skipped tests: 2, 1 of them because shared data are missing", said.getvalue())
            self.assertIn("Root skipped: no root\n", said.getvalue())
            self.assertNotIn("Good", said.getvalue())
            self.assertEqual([path.read_text() for path in (folder / "failed").iterdir()], ["some words\n"])


if __name__ == "__main__":
    unittest.main()
