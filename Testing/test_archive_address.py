#!/usr/bin/env python3
"""archive_address (cmake/archive.sh) with apt configurations of several forms, before and after apt-get update."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ARCHIVE = Path(__file__).resolve().parents[1] / "cmake" / "archive.sh"
SECURITY = "deb http://mirror.example/debian-security bookworm-security main\n"
VENDOR = "deb https://packages.example/tool/debian bookworm main\n"
DEB822 = "Types: deb deb-src\nURIs: {}\nSuites: trixie trixie-updates\nComponents: main contrib\n"


@unittest.skipUnless(shutil.which("apt-get"), "apt-get is not installed")
class ArchiveAddress(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        for folder in ("etc/apt/apt.conf.d", "etc/apt/sources.list.d", "lists"):
            (self.root / folder).mkdir(parents=True)
        self.write("apt.conf", f'Dir "{self.root}";\nDir::State::lists "{self.root}/lists";\n'
                               'APT::Architecture "amd64";\nAPT::Architectures "amd64";\n')

    def write(self, name, text):
        (self.root / name).write_text(text)

    def one_line(self, text):
        self.write("etc/apt/sources.list", text)

    def deb822(self, address):
        self.write("etc/apt/sources.list.d/debian.sources", DEB822.format(address))

    def updated(self, place, suite, origin, label):
        """The lists of one repository, as apt-get update leaves them."""
        name = f"{place.replace('/', '_')}_dists_{suite}_"
        self.write(f"lists/{name}Release", f"Origin: {origin}\nLabel: {label}\nCodename: {suite}\n"
                   f"Date: Sat, 06 Sep 2025 10:00:00 UTC\nSHA256:\n {'0' * 64} 0 main/binary-amd64/Packages\n")
        self.write(f"lists/{name}main_binary-amd64_Packages", "Package: a\n")

    def ask(self, **variables):
        environment = {"PATH": os.environ["PATH"], "APT_CONFIG": str(self.root / "apt.conf"), **variables}
        return subprocess.run(["bash", "-c", 'set -euo pipefail; source "$0"; archive_address', str(ARCHIVE)],
                              env=environment, capture_output=True, text=True)

    def expect(self, address, **variables):
        answer = self.ask(**variables)
        self.assertEqual((answer.stdout, answer.returncode), (f"{address}\n", 0), answer.stderr)

    def test_one_line_sources(self):
        self.one_line("# a comment\n" + SECURITY + VENDOR + "deb [arch=amd64] http://mirror.example/debian/ bookworm main\n")
        self.expect("http://mirror.example/debian")

    def test_deb822_sources(self):
        self.deb822("https://mirror.example/debian")
        self.expect("https://mirror.example/debian")

    def test_file_of_mirrors(self):
        self.write("etc/apt/debian.list", "# nearest first\nhttps://near.example/debian/\tpriority:1\nhttps://far.example/debian\n")
        for form in "mirror+file:{}", "mirror+file://{}":
            self.deb822(form.format(self.root / "etc/apt/debian.list"))
            self.expect("https://near.example/debian")

    def test_lists_decide(self):
        """With lists, what Debian publishes is found at any address, and others' repositories are not."""
        self.one_line("deb https://packages.example/debian bookworm main\n" + SECURITY +
                      "deb http://proxy.example/cache/stable bookworm main\n")
        self.updated("packages.example/debian", "bookworm", "Vendor", "Vendor")
        self.updated("mirror.example/debian-security", "bookworm-security", "Debian", "Debian-Security")
        self.updated("proxy.example/cache/stable", "bookworm", "Debian", "Debian")
        self.expect("http://proxy.example/cache/stable")
        self.one_line("deb https://packages.example/debian bookworm main\n")
        self.assertEqual(self.ask().returncode, 1)

    def test_variable_comes_first(self):
        self.deb822("https://mirror.example/debian")
        self.expect("file:///srv/debian", ISTHMUS_MIRROR="file:///srv/debian/")

    def test_none(self):
        ubuntu = "deb http://mirror.example/ubuntu noble main\n"
        component = "deb https://packages.example/debian bookworm stable\n"
        for sources in "", SECURITY, VENDOR, component, ubuntu:
            self.one_line(sources)
            answer = self.ask()
            self.assertEqual((answer.stdout, answer.returncode), ("", 1))
            self.assertIn("ISTHMUS_MIRROR=ADDRESS", answer.stderr)
            self.expect("http://other.example/debian", ISTHMUS_MIRROR="http://other.example/debian")


if __name__ == "__main__":
    unittest.main()
