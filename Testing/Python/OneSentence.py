"""What a user reads when something fails: one sentence, once, and nothing of VTK's own.

Files are opened and filters run as the window does it (open, information, data, show, and again); all
that reaches stderr is counted. What is well is silent: compressed maps, too.
"""

import gzip
import os
import tempfile
from pathlib import Path

from paraview import simple
from shared_data import shared_data


class Quiet:
    """Keeps what is written to stderr meanwhile, by Python and by C++."""

    def __enter__(self):
        self.file = tempfile.TemporaryFile()
        self.kept = os.dup(2)
        os.dup2(self.file.fileno(), 2)
        return self

    def __exit__(self, *_):
        os.dup2(self.kept, 2)
        os.close(self.kept)
        self.file.seek(0)
        self.text = self.file.read().decode("utf-8", "replace")
        self.file.close()


def look_at(make):
    """What is said while the source that make() gives is made, updated and shown, twice."""
    with Quiet() as said:
        source = make()
        for _ in range(2):
            source.UpdatePipelineInformation()
            source.UpdatePipeline()
            simple.Show(source)
            simple.Render()
        simple.Delete(source)
    return said.text


def demand_one(text, words, what):
    messages = [line for line in text.splitlines() if "ERR|" in line or "WARN|" in line]
    assert len(messages) == 1, f"{what}: {len(messages)} messages:\n{text}"
    assert words in text, f"{what}: no '{words}' in:\n{text}"
    for noise in ("returned failure", "Request", "GDAL", "Traceback"):
        assert noise not in text, f"{what}: {noise} in:\n{text}"
    print(f"{what}: {text.splitlines()[-1] if text.splitlines()[-1].strip() else text.strip()}")


def damaged(folder):
    """(name, file, words of its sentence)"""
    cut = folder / "cut.map"
    cut.write_bytes(shared_data("maps/emd_1832.map").read_bytes()[:-1])
    yield "a map short by one byte", cut, "cut.map"
    packed = folder / "cut.map.gz"
    packed.write_bytes(gzip.compress(cut.read_bytes(), 1))
    yield "the same, compressed", packed, "cut.map.gz"
    atoms = folder / "none.pqr"
    atoms.write_text("REMARK nothing\n")
    yield "a molecule without atoms", atoms, "none.pqr"
    potential = folder / "cut.dx"
    text = sorted(shared_data("maps/dx").glob("*.dx"))[0].read_text()
    potential.write_text(text[:len(text) // 2])
    yield "a potential cut in half", potential, "cut.dx"


def failures():
    """(name, what makes the source, words of its sentence)"""
    plane = simple.Plane()
    sphere = simple.Sphere(ThetaResolution=24, PhiResolution=24)
    wavelet = simple.Wavelet()
    yield "loops of an open surface", lambda: simple.ChokingLoops(Input=plane), "closed"
    yield "curvature of nothing measurable", (
        lambda: simple.PolarizedCurvature(Input=sphere, PotentialImage=wavelet)), "urvature"
    yield "sites without polarized curvature", (
        lambda: simple.BindingSites(Input=sphere)), "Polarized Curvature"
    yield "a level that is not there", (
        lambda: simple.DelaunayIsosurface(Input=wavelet, Level=1e9)), "evel"


with tempfile.TemporaryDirectory() as place:
    folder = Path(place)
    for name, path, words in damaged(folder):
        demand_one(look_at(lambda: simple.OpenDataFile(str(path))), words, name)
    good = folder / "good.map.gz"
    good.write_bytes(gzip.compress(shared_data("maps/emd_1832.map").read_bytes(), 1))
    for path in (good, shared_data("maps/emd_3197.map.gz"), shared_data("maps/EMD-3001.map.bz2")):
        said = look_at(lambda: simple.OpenDataFile(str(path)))
        assert "ERR" not in said, f"{path.name}: {said}"
        assert said.count("\n") == 0 or "WARN|" in said, f"{path.name}: {said}"
for name, make, words in failures():
    demand_one(look_at(make), words, name)
