#!/usr/bin/env python3
"""other_targets.py finds what does not compile for another system, and covers what it should.

    test_other_targets.py BUILD
"""
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "Builds"))
import other_systems  # noqa: E402
import other_targets  # noqa: E402

ROOT = other_systems.ROOT
BUILD = pathlib.Path(sys.argv.pop()).resolve()


class OtherTargets(unittest.TestCase):
    def check(self, target, source, old, new):
        """The messages for a source in which one text is replaced."""
        found = other_targets.Target(target)
        flags = dict(other_targets.sources_for(found, BUILD))
        text = source.read_text()
        self.assertIn(old, text)
        messages, _ = other_systems.Checker(found, BUILD).check(source, flags[source], text.replace(old, new, 1))
        found.lock.close()  # the next one waits for it
        return other_systems.errors_of(found, source, messages)

    def test_a_call_of_posix(self):
        source = ROOT / "Readers/Files/FileReplacement.cxx"
        include = '#include "Files/FileCalls.h"\n'
        waiting = include + "#include <sys/wait.h>\nint Wait(int pid) { int state = 0; return waitpid(pid, &state, 0); }\n"
        self.assertIn("Windows: Readers/Files/FileReplacement.cxx:4:", self.check("x86_64-windows-gnu", source, include, waiting))
        self.assertEqual("", self.check("aarch64-macos", source, include, waiting))

    def test_a_call_of_linux(self):
        source = ROOT / "Filters/Core/StartedProgramPosix.cxx"
        self.assertIn("macOS: Filters/Core/StartedProgramPosix.cxx:",
                      self.check("aarch64-macos", source, "pipe(ends)", "memfd_create(\"\", 0)"))

    def test_sources(self):
        names = {}
        for target in other_targets.TARGETS:
            found = other_targets.Target(target)
            names[target] = {source.name for source, _ in other_targets.sources_for(found, BUILD)}
            found.lock.close()
        windows, mac = names["x86_64-windows-gnu"], names["aarch64-macos"]
        self.assertEqual(windows - mac, {"FileCallsWindows.cxx", "PlainFileWindows.cxx", "StartedProgramWindows.cxx",
                                         "SystemMemoryWindows.cxx"})
        self.assertEqual(mac - windows, {"FileCallsPosix.cxx", "PlainFilePosix.cxx", "StartedProgramPosix.cxx",
                                         "SystemMemoryMac.cxx"})
        self.assertGreater(len(windows), 130)


if __name__ == "__main__":
    unittest.main()
