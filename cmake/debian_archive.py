"""Packages of one version of Debian, fetched and unpacked without installing them."""
import os
import pathlib
import re
import subprocess
import tempfile

ARCHIVE_SCRIPT = pathlib.Path(__file__).resolve().parent / "archive.sh"


class Unreachable(Exception):
    """The archive of packages cannot be reached or lacks a package."""


def archive_address():
    found = subprocess.run(["bash", "-c", 'source "$1" && archive_address', "bash", str(ARCHIVE_SCRIPT)],
                           capture_output=True, text=True)
    if found.returncode:
        raise Unreachable(found.stderr.strip())
    return found.stdout.strip()


class Archive:
    """apt with lists, cache and state of its own, for one suite."""

    def __init__(self, suite, folder):
        self.folder = folder
        self.address = archive_address()
        (folder / "lists/partial").mkdir(parents=True, exist_ok=True)
        (folder / "archives/partial").mkdir(parents=True, exist_ok=True)
        (folder / "status").touch()
        keys = pathlib.Path("/usr/share/keyrings/debian-archive-keyring.gpg")
        signed = f"[signed-by={keys}] " if keys.exists() else ""
        (folder / "sources.list").write_text(f"deb {signed}{self.address} {suite} main\n")
        # Of the machine's configuration, proxies and certificates apply, but neither sources nor preferences.
        (folder / "apt.conf").write_text(f"""
            APT::Default-Release ""; Dir::Etc::preferences "/dev/null"; Dir::Etc::preferencesparts "/dev/null";
            Dir::State "{folder}"; Dir::State::lists "{folder}/lists"; Dir::State::status "{folder}/status";
            Dir::Cache "{folder}"; Dir::Cache::archives "{folder}/archives";
            Dir::Etc::sourcelist "{folder}/sources.list"; Dir::Etc::sourceparts "/dev/null";
            Acquire::Check-Valid-Until "false"; Acquire::Languages "none"; Acquire::Retries "3";
            APT::Sandbox::User "root"; APT::Get::List-Cleanup "true";
            """)

    def apt(self, program, *arguments, cwd=None):
        # By -c, since the machine's files take precedence over APT_CONFIG.
        return subprocess.run([program, "-c", str(self.folder / "apt.conf"), *arguments],
                              env={**os.environ, "LC_ALL": "C"}, capture_output=True, text=True, cwd=cwd)

    def update(self):
        done = self.apt("apt-get", "update", "-q", "--error-on=any")
        if done.returncode:
            raise Unreachable(f"apt-get update failed for {self.address}:\n{done.stderr.strip()}")

    def versions(self, names):
        """{name: version} of those of the packages that the archive has."""
        policy = self.apt("apt-cache", "policy", *names).stdout
        return {name: version for name, version in re.findall(r"^(\S+):\n(?:  .*\n)*?  Candidate: (.*)$", policy, re.M)
                if version != "(none)"}

    def unpack(self, names, folder):
        with tempfile.TemporaryDirectory(dir=folder.parent) as work:
            done = self.apt("apt-get", "download", "-q", *names, cwd=work)
            if done.returncode:
                raise Unreachable(f"apt-get download failed for {self.address}:\n{done.stderr.strip()}")
            for package in pathlib.Path(work).glob("*.deb"):
                subprocess.run(["dpkg-deb", "--extract", str(package), str(folder)], check=True)
