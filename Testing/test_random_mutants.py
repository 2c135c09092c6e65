#!/usr/bin/env python3
"""random_mutants.py and mutants.py put the sources back and leave no process, whenever they are terminated."""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

TESTING = pathlib.Path(__file__).resolve().parent
SOURCE = "int x;\nnamespace isthmus\n{\nint Next(int i)\n{\n  return i + 1;\n}\n}\n"
# Stands for git, ninja, cmake and ctest. That of the name in the file `stop` says that it has begun, and what the
# source is then, and waits for `go`: git then does its work, the others wait to be terminated.
PROGRAM = """#!/bin/sh
if [ "$1" != status ] && [ "${0##*/}" = "$(cat "$FOLDER/stop")" ]; then
  [ "${0##*/}" = git ] || sleep 1000 &
  cp "$FOLDER/tree/Filters/Core/Next.cxx" "$FOLDER/seen"
  echo $! >"$FOLDER/new" && mv "$FOLDER/new" "$FOLDER/begun"
  while [ -d "$FOLDER" ] && [ ! -e "$FOLDER/go" ]; do sleep 0.05; done
fi
[ "${0##*/}" != git ] || PATH=$USUAL_PATH exec git "$@"
"""
MUTANTS = '{"one": ("Filters/Core/Next.cxx", "i + 1", "i + 2", ("TestNext", "*"))}'


def runs(process):
    try:
        return (pathlib.Path("/proc") / str(process) / "stat").read_text().split()[2] != "Z"
    except OSError:
        return False


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Terminated(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name).resolve()
        self.tree = self.folder / "tree"
        self.source = self.tree / "Filters/Core/Next.cxx"
        for name in ("Filters/Core", "Readers", "Testing/Unit/Core", "build/lib/python3/site-packages"):
            (self.tree / name).mkdir(parents=True)
        for name in ("random_mutants.py", "mutants.py", "put_back.py"):
            if (TESTING / name).exists():
                shutil.copy(TESTING / name, self.tree / "Testing")
        (self.tree / "Testing/mutants_equivalent.tsv").write_text("")
        (self.tree / "Testing/Unit/Core/TestNext.cxx").write_text("TEST(Next, Is)\n")
        (self.tree / "Testing/select_tests.py").write_text(
            "import pathlib, sys\npathlib.Path(sys.argv[sys.argv.index('--write') + 1]).write_text('0,0,0,1')\n")
        (self.tree / "Readers/vtk.module").write_text("")
        self.source.write_text(SOURCE)
        (self.folder / "programs").mkdir()
        for name in ("git", "ninja", "cmake", "ctest"):
            program = self.folder / "programs" / name
            program.write_text(PROGRAM)
            program.chmod(0o755)
        subprocess.run("git init -q && git add . && git -c user.name=a -c user.email=a@b commit -q -m start",
                       cwd=self.tree, shell=True, check=True)

    def wait_for(self, what, process):
        end = time.monotonic() + 60.0
        while not what():
            self.assertIsNone(process.poll(), "the script ended before it was terminated")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def stop_at(self, program):
        for name in ("begun", "go", "seen"):
            (self.folder / name).unlink(missing_ok=True)
        (self.folder / "stop").write_text(program)

    def begun(self):
        return (self.folder / "begun").exists()

    def start(self, program, command):
        """Starts a script, and waits for its step that `program` does."""
        self.source.write_text(SOURCE)
        self.stop_at(program)
        process = subprocess.Popen(
            [sys.executable, "-B", *command], cwd=self.tree, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
            env={**os.environ, "PATH": f"{self.folder}/programs:{os.environ['PATH']}", "FOLDER": str(self.folder),
                 "USUAL_PATH": os.environ["PATH"]})
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        self.wait_for(self.begun, process)
        self.child = int((self.folder / "begun").read_text())
        self.addCleanup(lambda one=self.child: runs(one) and os.kill(one, signal.SIGKILL))
        self.assertNotEqual((self.folder / "seen").read_text(), SOURCE, "no mistake was written")
        return process

    def assert_put_back(self, process, number):
        said = process.communicate(timeout=60)[1]
        self.assertEqual(self.source.read_text(), SOURCE)
        self.assertEqual(process.returncode, 128 + number, said)

    def test_in_each_step(self):
        scripts = (("random_mutants.py", "build", "--module", "Core"), ("mutants.py", "build"))
        path = self.tree / "Testing/mutants.py"
        text = path.read_text()
        first, last = text.index("MUTANTS = {"), text.index("\n}\n")
        path.write_text(text[:first] + f"MUTANTS = {MUTANTS}\n" + text[last + 3:])
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-aqm", "x"], cwd=self.tree, check=True)
        for script, program, number in (
                (scripts[0], "ninja", signal.SIGTERM), (scripts[0], "ninja", signal.SIGHUP),
                (scripts[0], "ninja", signal.SIGINT), (scripts[0], "ctest", signal.SIGTERM),
                (scripts[1], "cmake", signal.SIGTERM)):
            with self.subTest(script=script[0], program=program, signal=number.name):
                process = self.start(program, (f"Testing/{script[0]}", *script[1:]))
                process.send_signal(number)
                self.assert_put_back(process, number)
                end = time.monotonic() + 60.0
                while runs(self.child) and time.monotonic() < end:
                    time.sleep(0.01)
                self.assertFalse(runs(self.child), f"what {program} had started still runs")

    def test_while_it_puts_them_back(self):
        process = self.start("git", ("Testing/random_mutants.py", "build", "--module", "Core"))
        process.terminate()
        (self.folder / "go").touch()
        self.assert_put_back(process, signal.SIGTERM)

    def test_a_second_time(self):
        process = self.start("ninja", ("Testing/random_mutants.py", "build", "--module", "Core"))
        self.stop_at("git")
        process.terminate()
        self.wait_for(self.begun, process)
        process.terminate()
        (self.folder / "go").touch()
        self.assert_put_back(process, signal.SIGTERM)


if __name__ == "__main__":
    unittest.main()
