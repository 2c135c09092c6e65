"""Every Python block of the guide runs, page after page, without an error message; each C++ block is part of
Examples/Consumer, which Build.Install compiles and runs.

A block that another test runs, or that needs what no test has, is marked with a comment above it:
`<!-- not run: reason -->`. Usage of its own: pvpython Guide.py [PAGE...].
"""

import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

import numpy
from paraview import simple
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

EXAMPLES = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
ROOT = EXAMPLES.parent
GUIDE = ROOT / "Documentation"
sys.path.insert(0, str(EXAMPLES))
import gramicidin  # noqa: E402
import isthmus  # noqa: E402
# Names of files in the guide, and the shared data that they stand for.
FILES = {
    "emd_1832.map": "maps/emd_1832.map", "emd_5043.map": "maps/emd_5043.map",
    "1hew.pdb": "molecules/1hew.pdb", "1hew.pqr": "molecules/1hew/1hew.pqr",
    "1crn.pqr": "molecules/1crn_apbs.pqr", "1grm.pdb": "molecules/channels/1grm_hole_example.pdb",
    "3holes.off": "surfaces/3holes.off", "C60-Ih.xyz": "fullerenes/C60-Ih.xyz",
    "lysozyme.vert": "surfaces/lysozyme_msms/Lys1.vert", "lysozyme.face": "surfaces/lysozyme_msms/Lys1.face"}
BLOCK = re.compile(r"(<!-- not run: [^>]+-->\n)?^```(python|cpp)\n(.*?)^```", re.DOTALL | re.MULTILINE)


def blocks_of(page, language):
    """(line, text) of the blocks of a page that are to run."""
    text = page.read_text()
    for found in BLOCK.finditer(text):
        if found.group(2) == language and not found.group(1):
            yield text.count("\n", 0, found.start(3)) + 1, found.group(3)


PAGES = ([Path(name).resolve() for name in sys.argv[1:]] or
         sorted([*GUIDE.rglob("*.md"), ROOT / "README.md"]))


def check_cpp():
    """Lines of C++ blocks that are in no file of Examples/Consumer."""
    known = {line.strip() for path in (EXAMPLES / "Consumer").glob("*.cxx")
             for line in path.read_text().split("\n")}
    number = 0
    for page in PAGES:
        for line, text in blocks_of(page, "cpp"):
            number += 1
            for row in filter(None, map(str.strip, text.split("\n"))):
                if row not in known:
                    yield f"{page.name}:{line}: not in Examples/Consumer: {row}"
    if number == 0 and not sys.argv[1:]:
        yield "no C++ block was found"


for problem in (problems := list(check_cpp())):
    print(problem)
assert not problems

paths = {name: shared_data(relative) for name, relative in FILES.items()}
said = []


def listen(_window, event):
    said.append(event)


window = vtkOutputWindow.GetInstance()
window.AddObserver("ErrorEvent", listen)


def write_half_maps():
    """emd_1832.map with noise of its own twice, as half1.mrc and half2.mrc."""
    content = Path("emd_1832.map").read_bytes()
    header, values = content[:1024], numpy.frombuffer(content[1024:], dtype="<f4")
    assert int.from_bytes(header[12:16], "little") == 2 and int.from_bytes(header[92:96], "little") == 0
    random = numpy.random.default_rng(1)
    for half in ("half1.mrc", "half2.mrc"):
        noisy = values + random.normal(0.0, 0.2 * values.std(), values.size)
        Path(half).write_bytes(header + noisy.astype("<f4").tobytes())


def write_models():
    """Three models of lysozyme, 0.2 angstrom of noise apart."""
    lines = [line for line in Path("1hew.pdb").read_text().split("\n")
             if line.startswith("ATOM") and line[16] in " A"]
    places = numpy.array([[float(line[i:i + 8]) for i in (30, 38, 46)] for line in lines])
    random = numpy.random.default_rng(1)
    text = []
    for model in range(1, 4):
        moved = places + random.normal(0.0, 0.2, places.shape)
        text.append(f"MODEL     {model:4d}")
        text += [line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:]
                 for line, place in zip(lines, moved)]
        text.append("ENDMDL")
    Path("models.pdb").write_text("\n".join([*text, "END", ""]))


def write_channel():
    """Gramicidin with charges, its axis along z through the origin, as channel.pqr."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName("1grm.pdb")
    reader.Update()
    charged = gramicidin.with_charges(reader.GetOutput())
    places = vtk_to_numpy(charged.GetPoints().GetData())[:, [2, 0, 1]]
    places = places - places.mean(axis=0)
    charge, radius = (vtk_to_numpy(charged.GetPointData().GetArray(name)) for name in ("Charge", "Radius"))
    symbols = {number: symbol for symbol, number in gramicidin.ELEMENTS.items()}
    elements = vtk_to_numpy(charged.GetPointData().GetArray("Element"))
    Path("channel.pqr").write_text("".join(
        f"ATOM  {i + 1:5d}  {symbols[int(elements[i])]:<3s} GRA A{1 + i // 20:4d}    "
        f"{x:8.3f}{y:8.3f}{z:8.3f} {charge[i]:7.4f} {radius[i]:6.4f}\n"
        for i, (x, y, z) in enumerate(places)) + "END\n")


def write_further_files():
    """What users have and the shared data lack: half maps, models, a channel, a potential."""
    write_half_maps()
    write_models()
    write_channel()
    volume = simple.OpenDataFile("emd_1832.map")
    simple.SaveData("potential.dx", volume)
    simple.Delete(volume)


def run_page(page):
    """Runs the blocks of one page in one namespace; returns what went wrong."""
    namespace = {"__name__": "__main__"}
    for line, text in blocks_of(page, "python"):
        said.clear()
        try:
            exec(compile(text, f"{page.name}:{line}", "exec"), namespace)  # noqa: S102
        except Exception as error:  # noqa: BLE001 (any failure is reported with its place)
            return f"{page.name}:{line}: {type(error).__name__}: {error}"
        if said:
            return f"{page.name}:{line}: {len(said)} error messages, see above"
    return None


def clear():
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)


folder = Path(tempfile.mkdtemp(prefix="isthmus_guide_"))
failures, number = [], 0
try:
    os.chdir(folder)
    for name, path in paths.items():
        (folder / name).symlink_to(path)
    write_further_files()
    for page in PAGES:
        if next(blocks_of(page, "python"), None) is None:
            continue
        number += 1
        print(page.relative_to(ROOT), flush=True)
        problem = run_page(page)
        if problem:
            failures.append(problem)
            print("  " + problem, flush=True)
        clear()
finally:
    os.chdir("/")
    shutil.rmtree(folder)
assert number, "no page was run"
assert not failures, "\n".join(failures)
print(f"{number} pages ran")
