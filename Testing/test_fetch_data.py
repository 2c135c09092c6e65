#!/usr/bin/env python3
"""fetch_data.sh against a server on this machine: good, missing, truncated and altered files."""

import gzip
import hashlib
import http.server
import os
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
WHERE = "owner/name/HEAD/"
GOOD = bytes(range(256)) * 400


class Handler(http.server.SimpleHTTPRequestHandler):
    """Serves a folder, with ranges, as GitHub does; files named cut* end too early."""

    def do_GET(self):
        path = Path(self.directory) / self.path.lstrip("/")
        if not path.is_file():
            self.send_error(404)
            return
        data = path.read_bytes()
        first = int(self.headers["Range"][6:-1]) if "Range" in self.headers else 0
        if first >= len(data) > 0:
            self.send_error(416)
            return
        self.send_response(206 if first else 200)
        if first:
            self.send_header("Content-Range", f"bytes {first}-{len(data) - 1}/{len(data)}")
            self.server.resumed.append(path.name)
        self.send_header("Content-Length", str(len(data) - first))
        self.end_headers()
        cut = path.name.startswith("cut")
        self.wfile.write(data[first:len(data) // 2] if cut else data[first:])

    def log_message(self, *_):
        pass


class FetchData(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.into = Path(scratch.name) / "data"
        self.table = Path(scratch.name) / "files.tsv"
        self.site = Path(scratch.name) / "site"
        (self.site / WHERE).mkdir(parents=True)
        self.server = http.server.ThreadingHTTPServer(
            ("127.0.0.1", 0), lambda *a: Handler(*a, directory=str(self.site)))
        self.server.resumed = []
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)
        self.rows = []

    def offer(self, name, served, expected=GOOD, how="plain"):
        if served is not None:
            (self.site / WHERE / name).write_bytes(served)
        self.rows.append(
            f"maps/{name}\t{how}\t{WHERE}{name}\t{hashlib.sha256(expected).hexdigest()}\n")

    def fetch(self):
        self.table.write_text("# a table\n" + "".join(self.rows))
        return subprocess.run(
            [HERE / "fetch_data.sh", self.into], capture_output=True, text=True, timeout=120,
            env={**os.environ, "ISTHMUS_DATA_TABLE": str(self.table),
                 "ISTHMUS_DATA_SOURCE": f"http://127.0.0.1:{self.server.server_port}"})

    def names(self):
        return sorted(p.name for p in (self.into / "maps").iterdir())

    def test_good_files_come_and_stay(self):
        self.offer("good.map", GOOD)
        self.offer("packed.gz", GOOD, how="packed")
        run = self.fetch()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.into / "maps/good.map").read_bytes(), GOOD)
        self.assertEqual(gzip.decompress((self.into / "maps/packed.gz").read_bytes()), GOOD)
        self.assertIn("0 fetched, 2 there already, 0 missing", self.fetch().stdout)

    def test_missing_and_altered_files_are_named_and_not_used(self):
        self.offer("gone.map", None)
        self.offer("altered.map", GOOD[:-1] + b"x")
        self.offer("good.map", GOOD)
        run = self.fetch()
        self.assertEqual(run.returncode, 1)
        self.assertIn("maps/gone.map: not fetched", run.stderr)
        self.assertIn("maps/altered.map: what came has another SHA-256", run.stderr)
        self.assertEqual(self.names(), ["good.map"])
        self.assertIn("1 fetched, 0 there already, 2 missing", run.stdout)

    def test_truncated_files_are_not_used_and_go_on_later(self):
        self.offer("cut.map", GOOD)
        run = self.fetch()
        self.assertEqual(run.returncode, 1)
        self.assertIn("maps/cut.map: not fetched", run.stderr)
        self.assertNotIn("cut.map", self.names())
        # The same file from a server that sends all of it, after a part has come.
        self.rows.clear()
        self.offer("late.map", GOOD)
        (self.into / "maps/late.map.part").write_bytes(GOOD[:1000])
        run = self.fetch()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("late.map", self.server.resumed)
        self.assertEqual((self.into / "maps/late.map").read_bytes(), GOOD)

    def test_a_part_of_another_file_is_begun_anew(self):
        self.offer("good.map", GOOD)
        (self.into / "maps").mkdir(parents=True)
        (self.into / "maps/good.map.part").write_bytes(b"something else")
        run = self.fetch()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual((self.into / "maps/good.map").read_bytes(), GOOD)

    def test_what_was_made_for_the_project_is_in_the_tree(self):
        rows = [r for r in (HERE / "Data/files.tsv").read_text().splitlines() if "\there\t" in r]
        self.assertGreaterEqual(len(rows), 5)
        self.rows = [row + "\n" for row in rows]
        run = self.fetch()
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertTrue((self.into / "fullerenes/gfn2_xtb_energies.csv").is_file())


if __name__ == "__main__":
    unittest.main()
