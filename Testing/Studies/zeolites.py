"""Compares the largest balls that fit into zeolites, and get through them, with the Database of Zeolite Structures.

Usage: pvpython zeolites.py [FOLDER] [--database FILE] [--pyzeo PYTHON] [--each]

--database: the file frameworks.db of the PyPI package zefram 0.1.3 (MIT), which has the data of the Database of Zeolite
Structures of the International Zeolite Association; to get it:

    pip download zefram==0.1.3 --no-deps --python-version 3.10 --only-binary=:all:
    python3 -m zipfile -e zefram-0.1.3-py3-none-any.whl zefram

The symmetry is applied. It also says which frameworks are disordered or interrupted. FOLDER: frameworks as files
CODE.cif with all atoms of their cells, and iza.csv (the shared data zeolites, made from the same database); they replace
those of the database, and without --database all count as ordered. Oxygen has the radius 1.32 angstrom, silicon is
dropped, as in the database.

Pore Profile, mode Cell Vectors: the diameter of the largest included sphere, and of the largest free sphere along
a, b and c. Right: within 0.03 angstrom of the database. --pyzeo: a Python interpreter that has the PyPI package
pyzeo (Zeo++), which computes the largest included sphere and the largest free sphere along any direction. Each
framework is a process of its own there, since Zeo++ may crash. --each prints the frameworks that differ.
Intervals are 95 % intervals from resampling the frameworks. Prints Markdown.
"""

import argparse
import csv
import re
import sqlite3
import subprocess
import tempfile
import time
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import study_paths  # noqa: F401 (before isthmus)
import isthmus

OXYGEN = 1.32  # angstrom
RIGHT = 0.03 + 1e-4  # the database has two decimals
SIDES = ("a", "b", "c")
ZEO = """
import sys
from pyzeo.netstorage import AtomNetwork
network = AtomNetwork.read_from_CIF(sys.argv[1], rad_file=sys.argv[2])
network.calculate_free_sphere_parameters(sys.argv[3])
"""


def operators(cif):
    """Its symmetry operators as matrices and vectors."""
    found = []
    for line in cif.splitlines():
        text = re.sub(r"^\d+\s+", "", line.strip()).strip("'\"").replace(" ", "").lower()
        parts = text.split(",")
        if len(parts) != 3 or not all(re.fullmatch(r"[-+xyz0-9/.]*[xyz][-+xyz0-9/.]*", part) for part in parts):
            continue
        rows = [[sum(-1 if sign == "-" else 1 for sign, axis in re.findall(r"([-+]?)([xyz])", part) if axis == name)
                 for name in "xyz"] for part in parts]
        shifts = [sum(float(sign + a) / float(b or 1) for sign, a, b in
                      re.findall(r"([-+]?)(\d+\.?\d*)(?:/(\d+))?", re.sub("[-+]?[xyz]", "", part))) for part in parts]
        found.append((numpy.array(rows), numpy.array(shifts)))
    return found or [(numpy.eye(3), numpy.zeros(3))]


def with_symmetry(cif):
    """The same crystal as a file with all oxygen atoms of the cell."""
    cell = {name: float(value) for name, value in re.findall(r"_cell_(\w+)\s+([\d.]+)", cif)}
    places = []
    for fields in map(str.split, cif.splitlines()):
        if len(fields) >= 5 and fields[1] == "O":
            place = numpy.array([float(value.split("(")[0]) for value in fields[2:5]])
            for turn, shift in operators(cif):
                image = (turn @ place + shift) % 1.0
                apart = [(image - other + 0.5) % 1.0 - 0.5 for other in places]
                if not apart or numpy.abs(apart).max(axis=1).min() > 0.005:
                    places.append(image)
    names = ("length_a", "length_b", "length_c", "angle_alpha", "angle_beta", "angle_gamma")
    lines = ["data_x", *(f"_cell_{name} {cell[name]}" for name in names),
             "_symmetry_space_group_name_H-M 'P 1'", "loop_", "_symmetry_equiv_pos_as_xyz", "x,y,z", "loop_",
             *(f"_atom_site_{name}" for name in ("label", "type_symbol", "fract_x", "fract_y", "fract_z")),
             *(f"O{i} O {x:.5f} {y:.5f} {z:.5f}" for i, (x, y, z) in enumerate(places, 1))]
    return "\n".join(lines) + "\n"


def without_silicon(cif):
    return "".join(line + "\n" for line in cif.splitlines() if line.split()[1:2] not in (["Si"], ["T"]))


def by_isthmus(path):
    """Diameters: included, and free along a, b and c; seconds."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    reader.Update()
    read = reader.GetOutput()
    oxygen = vtkPolyData()
    oxygen.GetFieldData().ShallowCopy(read.GetFieldData())
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(read.GetPoints().GetData()), deep=True))
    oxygen.SetPoints(points)
    radii = numpy_to_vtk(numpy.full(read.GetNumberOfPoints(), OXYGEN), deep=True)
    radii.SetName("Radius")
    oxygen.GetPointData().AddArray(radii)
    pores = isthmus.vtkPoreProfile()
    pores.SetInputData(oxygen)
    pores.SetMode(pores.CellVectors)
    start = time.process_time()
    pores.Update()
    seconds = time.process_time() - start
    table = pores.GetPoreTable()
    free = {table.GetValueByName(row, "Direction").ToString(): 2.0 * table.GetValueByName(row, "Radius").ToDouble()
            for row in range(table.GetNumberOfRows())}
    included = 2.0 * table.GetFieldData().GetArray("LargestIncludedRadius").GetComponent(0, 0)
    return [included, *(free.get(side, numpy.nan) for side in SIDES)], seconds


def by_zeo(python, path):
    """Diameters: included, and free along any direction. None where it fails."""
    with tempfile.TemporaryDirectory() as folder:
        radii, result = Path(folder) / "radii", Path(folder) / "result"
        radii.write_text(f"O {OXYGEN}\n")
        try:
            subprocess.run([python, "-c", ZEO, str(path), str(radii), str(result)], capture_output=True, check=True,
                           timeout=600)
            return [float(value) for value in result.read_text().split()[-3:-1]]
        except (subprocess.SubprocessError, OSError, ValueError):
            return None


def read_frameworks(folder, database):
    """Code, diameters of the database, text of the file, whether it is ordered, whether it is shared."""
    entries = {}
    if database:
        columns = "code, isdisordered, isinterrupted, maxdsi, maxdsd_a, maxdsd_b, maxdsd_c, cif"
        entries = {row[0]: row[1:] for row in
                   sqlite3.connect(database).execute(f"select {columns} from frameworks") if row[3] is not None}
    frameworks = []
    rows = []
    if folder:
        with open(folder / "iza.csv", newline="") as file:
            rows = list(csv.DictReader(file))
    for row in rows:
        entry = entries.pop(row["code"], (False, False))
        known = [float(row["largest_included_sphere_diameter"]),
                 *(float(row[f"largest_free_sphere_diameter_{side}"]) for side in SIDES)]
        text = without_silicon((folder / f"{row['code']}.cif").read_text())
        frameworks.append((row["code"], known, text, not (entry[0] or entry[1]), True))
    for code, entry in sorted(entries.items()):
        frameworks.append((code, list(entry[2:6]), with_symmetry(entry[6]), not (entry[0] or entry[1]), False))
    return frameworks


def share(name, flags):
    """A row: how many are right, of how many, with an interval over the frameworks."""
    groups = [numpy.atleast_1d(flag) for flag in flags]
    if not groups:
        return
    random = numpy.random.default_rng(0)
    means = [numpy.concatenate([groups[i] for i in random.integers(len(groups), size=len(groups))]).mean()
             for _ in range(2000)]
    low, high = numpy.percentile(means, (2.5, 97.5))
    every = numpy.concatenate(groups)
    print(f"| {name} | {every.sum()} of {len(every)} | {100 * every.mean():.1f} [{100 * low:.0f}, {100 * high:.0f}] |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("--database", type=Path)
    parser.add_argument("--pyzeo")
    parser.add_argument("--each", action="store_true")
    options = parser.parse_args()
    rows = []
    for code, known, text, ordered, shared in read_frameworks(options.folder, options.database):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{code}.cif"
            path.write_text(text)
            found, seconds = by_isthmus(path)
            zeo = by_zeo(options.pyzeo, path) if options.pyzeo else None
        right = numpy.abs(numpy.array(found) - known) <= RIGHT
        rows.append((ordered, shared, right, numpy.array(found), known, zeo, seconds))
        if options.each and (not right.all() or (options.pyzeo and zeo is None)):
            listed = [" ".join(f"{value:.2f}" for value in values) for values in (known, found, zeo or [])]
            print(f"{code}{'' if ordered else ' (not ordered)'}: database {listed[0]}, Isthmus {listed[1]}, Zeo++ "
                  f"{listed[2] or '-'}", flush=True)
    print("| within 0.03 angstrom | number | % [95 %] |")
    print("|---|---|---|")
    for name, chosen in (("shared, ordered", [r for r in rows if r[0] and r[1]]),
                         ("not shared, ordered", [r for r in rows if r[0] and not r[1]]),
                         ("all ordered", [r for r in rows if r[0]]), ("not ordered", [r for r in rows if not r[0]])):
        share(f"{name}: largest included sphere", [r[2][0] for r in chosen])
        share(f"{name}: largest free sphere along a, b, c", [r[2][1:] for r in chosen])
        share(f"{name}: the widest direction", [abs(max(r[3][1:]) - max(r[4][1:])) <= RIGHT for r in chosen])
        if options.pyzeo:
            have = [r for r in chosen if r[5]]
            share(f"{name}: Zeo++, largest included sphere", [r[5] is not None and abs(r[5][0] - r[4][0]) <= RIGHT
                                                              for r in chosen])
            share(f"{name}: Zeo++, the widest direction", [r[5] is not None and abs(r[5][1] - max(r[4][1:])) <= RIGHT
                                                           for r in chosen])
            share(f"{name}: Isthmus and Zeo++ agree to 0.005 on both",
                  [abs(r[5][0] - r[3][0]) < 0.005 and abs(r[5][1] - max(r[3][1:])) < 0.005 for r in have])
            print(f"| {name}: Zeo++ fails | {len(chosen) - len(have)} of {len(chosen)} | |")
    seconds = [r[6] for r in rows]
    print(f"\nCPU time of Pore Profile: median {numpy.median(seconds):.2f} s, at most {max(seconds):.1f} s.")


if __name__ == "__main__":
    main()
