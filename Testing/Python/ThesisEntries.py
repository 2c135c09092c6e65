"""thesis.py --fetch: entries of PDB and EMDB by id, from a folder and from a server of this machine in place of the
archives; what is wrong with a download is said."""

import contextlib
import gzip
import http.server
import io
import os
import shutil
import socket
import sys
import threading
from pathlib import Path

import mrcfile
import numpy

sys.path.insert(0, os.environ["ISTHMUS_STUDIES_DIR"])
import thesis  # noqa: E402
import thesis_entries  # noqa: E402

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "ThesisEntries"
ATOM = "ATOM  {:5d}  CA  GLY A{:4d}    {:8.3f}{:8.3f}{:8.3f}  1.00  0.00           C\n"


def write_mirror(folder):
    """A file for each entry: a chain of atoms, a blob as a packed map."""
    folder.mkdir(parents=True)
    place = numpy.indices((24, 24, 24)) - 11.5
    for number, (entry, (name, _)) in enumerate(thesis_entries.ENTRIES.items()):
        if name.endswith(".pdb"):
            atoms = "".join(ATOM.format(i + 1, i + 1, 3.8 * i, number, 0.0) for i in range(9))
            (folder / name).write_text(f"HEADER    {entry}\n{atoms}END\n")
            continue
        blob = numpy.exp(-(place ** 2).sum(0) / (60.0 + number)) * (1 + 0.2 * numpy.sin(place[0]))
        with mrcfile.new(folder / "blob.map", blob.astype("f4"), overwrite=True) as file:
            file.voxel_size = 2.0
        (folder / name).write_bytes(gzip.compress((folder / "blob.map").read_bytes(), mtime=0))


def fetched(*words, program=thesis_entries.main):
    """(exit status, what was printed)"""
    said = io.StringIO()
    status = 0
    with contextlib.redirect_stdout(said):
        try:
            status = program(list(words)) or 0
        except SystemExit as ended:
            status = ended.code
    return status, said.getvalue()


def check_folder(mirror, folder):
    base = mirror.as_uri()
    status, said = fetched("--fetch", str(folder), "--from", base, program=thesis.main)
    assert status == 0 and said.count("\n") == len(thesis_entries.ENTRIES) == 16, said
    assert said.count("another revision") == 2, said  # of 1HEW and 2KIX, whose checksums are recorded
    lock = (folder / "checksums.tsv").read_text()
    assert thesis_entries.checksum(mirror / "1MAG.pdb") in lock and lock.count("\n") == 17, lock
    shutil.move(mirror / "1MAG.pdb", mirror / "away")  # what is there is not downloaded again
    assert fetched(str(folder), "--from", base)[0] == 0
    assert thesis.fetched("1MAG") == str(folder / "1MAG.pdb") and thesis.fetched("EMD-5273")
    (folder / "1ADS.pdb").write_text("HEADER    something else\n")
    status, said = fetched(str(folder), "--from", base, "1ads", "1MAG")
    assert status == 1 and "but checksums.tsv has" in said and said.count("\n") == 2, said
    (folder / "1MAG.pdb").unlink()
    status, said = fetched(str(folder), "--from", base, "1MAG")
    assert status == 1 and "not fetched" in said and not list(folder.glob("*.part")), said
    shutil.move(mirror / "away", mirror / "1MAG.pdb")
    assert fetched(str(folder), "--from", base, "1MAG")[0] == 0
    assert fetched(str(folder), "9XYZ") == (1, f"There is no 9XYZ; there are: {', '.join(thesis_entries.ENTRIES)}.\n")


def check_server(mirror, folder):
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def __init__(self, *arguments):
            super().__init__(*arguments, directory=str(mirror))

        def log_message(self, *_):
            pass
    (mirror / "1PPL.pdb").write_text("<html>Moved, see elsewhere</html>\n")
    (mirror / "emd_1590.map.gz").write_bytes(b"no gzip")
    (mirror / "1EJN.pdb").unlink()
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Quiet)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    status, said = fetched(str(folder), "--from", f"http://127.0.0.1:{server.server_port}/")
    server.shutdown()
    server.server_close()
    lines = {line.split()[0]: line for line in said.splitlines()}
    assert status == 1 and "the download is not a PDB file" in lines["1PPL"], said
    assert "the download is not a packed map" in lines["EMD-1590"] and "404" in lines["1EJN"], said
    assert "no way to" not in said and said.count("not fetched") == 3, said
    assert sorted(path.name for path in folder.iterdir()) == sorted(
        [name for name, _ in thesis_entries.ENTRIES.values()
         if name not in ("1PPL.pdb", "emd_1590.map.gz", "1EJN.pdb")] + ["checksums.tsv"])


def check_no_network(folder):
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    status, said = fetched(str(folder), "--from", f"http://127.0.0.1:{port}")
    assert status == 1 and "There is no way to http://127.0.0.1" in said and "stand-ins" in said, said


def check_picture(folder):
    """A map's six descriptors and its surface, as thesis.py draws those that were fetched."""
    from paraview import simple
    volume = simple.OpenDataFile(thesis.fetched("EMD-5273"))
    surface = simple.MapSurface(Input=volume)
    thesis.draw_curvature(surface, folder / "5.7.png", Volume=volume)
    thesis.draw_surface(surface, folder / "4.7.png")
    assert (folder / "5.7.png").stat().st_size > 50000 and (folder / "4.7.png").stat().st_size > 5000


shutil.rmtree(OUTPUT, ignore_errors=True)
write_mirror(OUTPUT / "mirror")
check_folder(OUTPUT / "mirror", OUTPUT / "from_folder")
check_picture(OUTPUT)
check_server(OUTPUT / "mirror", OUTPUT / "from_server")
check_no_network(OUTPUT / "nowhere")
