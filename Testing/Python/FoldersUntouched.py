"""No button, filter or example writes into a folder of the user's unless it is told to: a folder of inputs,
in which ParaView was started, is the same afterwards byte by byte. Protein buttons take PDB files, packed
ones and mmCIF alike; charges come from the atoms in memory.
"""

import gzip
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import ring_models
from good_data import filters, made
from paraview import servermanager, simple
from shared_data import shared_data
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

if shutil.which("pdb2pqr") is None and shutil.which("pdb2pqr30") is None:
    print("needs pdb2pqr")
    sys.exit(1 if os.environ.get("ISTHMUS_REQUIRE_DATA") == "1" else 77)

work = Path(tempfile.mkdtemp())
home, scratch = work / "home", work / "temporary"
home.mkdir()
scratch.mkdir()
os.environ["TMPDIR"] = tempfile.tempdir = str(scratch)


def take(name, source):
    (home / name).write_bytes(shared_data(source).read_bytes())
    return home / name


protein = take("protein.pdb", "molecules/1ubq.pdb")
packed = home / "packed.pdb.gz"
packed.write_bytes(gzip.compress(shared_data("molecules/4pti.pdb").read_bytes()))
with_ligand = take("with_ligand.pdb", "molecules/1hew.pdb")
cif = take("protein.cif", "molecules/1FAS.cif")
charged = take("charged.pqr", "molecules/1crn_apbs.pqr")
# not `volume`: ParaView's Programmable Filter puts a function of that name into the user's names
density = take("volume.map", "maps/emd_1832.map")
surface = take("surface.obj", "surfaces/torus.obj")
trajectory = home / "trajectory.pdb"
ring_models.write(trajectory, 3)
# What the charges were once written to, and pdb2pqr's log.
for name in ("protein.pqr", "protein.log", "packed.pqr", "with_ligand.pqr"):
    (home / name).write_text("the user's own\n")
os.chdir(home)


def state():
    return {path.relative_to(home): path.read_bytes() if path.is_file() else None
            for path in sorted(home.rglob("*"))}


def check(what):
    now = state()
    changed = [str(path) for path in {**before, **now} if before.get(path, 0) != now.get(path, 0)]
    assert not changed, f"{what} changed {changed}"


before = state()
errors = []
window = vtkOutputWindow.GetInstance()


def keep(_, __, text):
    errors.append(text)


keep.CallDataType = VTK_STRING
window.AddObserver("ErrorEvent", keep)


def press(button, path):
    """The result of a button on a file, which ends without an error."""
    errors.clear()
    source = simple.OpenDataFile(str(path))
    simple.SetActiveSource(source)
    pipelines.run(button)
    assert not errors, f"{button} on {path.name}: {errors}"
    last = simple.GetActiveSource()
    assert last is not source, f"{button} on {path.name} made nothing"
    check(f"{button} on {path.name}")
    print(button, path.name, last.SMProxy.GetXMLName(), flush=True)
    return last


def named(name):
    return [proxy for proxy in simple.GetSources().values() if proxy.SMProxy.GetXMLName() == name]


def clear():
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)


for path in (protein, packed, cif, with_ligand, charged):
    sites = press("protein_to_sites", path)
    (atoms,) = named("ForceFieldCharges")
    low, high = atoms.PointData["Charge"].GetRange(0)
    assert low < 0.0 < high, (path.name, low, high)
    values = sites.PointData["Potential"].GetRange(0)
    assert values[0] < 0.0 < values[1], (path.name, values)
    clear()

# 1HEW: 1,001 atoms of the chain, 43 of three sugars, 103 waters (its ATOM and HETATM records).
press("protein_to_surface", with_ligand)
counts = {bool(part.IncludeChains): part.GetDataInformation().GetNumberOfPoints() for part in named("AtomSelection")}
assert counts == {True: 1001, False: 43}, counts
view = simple.GetActiveView()
shown = sorted(display.Input.SMProxy.GetXMLName() for display in view.Representations
               if getattr(display, "Input", None) is not None and display.Visibility)
assert shown == ["AtomSelection", "MapSurface"], shown
clear()
press("protein_to_surface", protein)
assert len(named("AtomSelection")) == 1  # no ligands: nothing to show
clear()
for button, path in (("protein_to_pockets", packed), ("map_to_surface", density), ("map_to_curvature", density),
                     ("map_to_loops", density), ("surface_to_loops", surface), ("trajectory_to_loops", trajectory)):
    press(button, path)
    clear()

for name in filters():
    made(name).UpdatePipeline()
    check(name)
print(len(filters()), "filters")

examples = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
for script, *arguments in (
        ("choking_loops.py", surface), ("electrostatics.py", charged), ("map_handles.py", density),
        ("binding_sites.py", with_ligand), ("surface_regions.py", protein)):
    done = subprocess.run(["pvpython", str(examples / script), *map(str, arguments)], capture_output=True,
                          text=True, timeout=300, check=False)
    assert done.returncode == 0, f"{script}: {done.stderr[-2000:]}"
    assert str(scratch) in done.stdout, f"{script} says where its pictures are: {done.stdout[-500:]}"
    check(script)
    print(script, flush=True)
servermanager.Disconnect()
os.chdir("/")
shutil.rmtree(work)
