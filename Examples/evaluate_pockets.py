"""Where do pockets lie that rank first? Molecular Pockets beside fpocket, both without the ligand.

Usage: pvpython evaluate_pockets.py FOLDER [--fpocket PROGRAM] [--sweep]

FOLDER holds ligands.csv (file, ligand_residue, chain, residue_number) and the complexes it names. The
ligand's lines are taken out of each file before anything runs; fpocket, whose score depends on what
else is in the file, is also shown without any HETATM line, and with the ligand. Success: the pocket's centre (for
fpocket: the mean of its alpha spheres, or of the atoms that line it) within 4 angstrom of an atom of
the ligand. fpocket is no part of Debian: build it with its own qhull and name the program. Prints
Markdown: also what chance would give, a pocket taken at random among those found. With --sweep: 40
settings of inner and outer radius, and of 9 of them with burial radii of 8 to 12 angstrom and powers 0 to
3 of the number of atoms in the score, and each complex judged by the setting that is best on the others.
"""

import argparse
import csv
import gzip
import itertools
import subprocess
import tempfile
from pathlib import Path

import numpy

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus
from vtkmodules.util.numpy_support import vtk_to_numpy

SUCCESS = 4.0  # angstrom
INNER = numpy.linspace(1.5, 1.9, 5)
OUTER = numpy.linspace(2.8, 3.5, 8)
# Of the number of atoms around, these with every third radius: the rest would take half an hour.
BURIAL = (8.0, 10.0, 12.0)
POWERS = (0, 1, 2, 3)
SETTINGS = [(inner, outer, burial)
            for (i, inner), (k, outer), burial in itertools.product(enumerate(INNER), enumerate(OUTER), BURIAL)
            if burial == 10.0 or (i % 2 == 0 and k % 3 == 0)]


def place_of(line):
    return [float(line[start : start + 8]) for start in (30, 38, 46)]


def split(path, row):
    """The file's lines with a mark for those of the ligand, and the ligand's atoms."""
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", errors="replace") as file:
        lines = [line for line in file if not line.startswith("ANISOU")]
    ligand = {
        i
        for i, line in enumerate(lines)
        if line.startswith("HETATM")
        and line[17:20].strip() == row["ligand_residue"]
        and row["chain"] in ("", line[21])
        and row["residue_number"] in ("", line[22:26].strip())
    }
    marked = [(line, i in ligand) for i, line in enumerate(lines)]
    return marked, numpy.array([place_of(lines[i]) for i in sorted(ligand)])


def by_isthmus(path, inner=1.7, outer=3.1):
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    finder = isthmus.vtkMolecularPockets()
    finder.SetInputConnection(reader.GetOutputPort())
    finder.SetInnerRadius(inner)
    finder.SetOuterRadius(outer)
    finder.Update()
    table = finder.GetPocketTable()
    return [
        [table.GetValueByName(row, "Center" + axis).ToDouble() for axis in "XYZ"]
        for row in range(table.GetNumberOfRows())
    ]


def by_scores(path, inner, outer, burial):
    """Centres of the pockets by rank, for each power of the number of atoms around in the score."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    finder = isthmus.vtkMolecularPockets()
    finder.SetInputConnection(reader.GetOutputPort())
    finder.SetInnerRadius(inner)
    finder.SetOuterRadius(outer)
    finder.SetBurialRadius(burial)
    finder.Update()
    cells = finder.GetOutput().GetCellData()
    owner, volume, atoms = (vtk_to_numpy(cells.GetArray(name)) for name in ("PocketId", "EmptyVolume", "Burial"))
    centres = vtk_to_numpy(finder.GetAlphaBalls().GetPoints().GetData())
    found = {}
    for power in POWERS:
        weights = volume * (atoms / 100.0) ** power
        scores = numpy.bincount(owner, weights)
        sums = numpy.stack([numpy.bincount(owner, weights * centres[:, k]) for k in range(3)], axis=1)
        ranks = [i for i in numpy.argsort(-scores, kind="stable") if i > 0 and scores[i] > 0.0]
        found[power] = [sums[i] / scores[i] for i in ranks]
    return found


def by_fpocket(program, path, by_atoms):
    folder = path.parent / (path.stem + "_out")
    if not folder.exists():
        subprocess.run([program, "-f", str(path)], check=True, stdout=subprocess.DEVNULL)
    if by_atoms:
        files = sorted((folder / "pockets").glob("pocket*_atm.pdb"),
                       key=lambda file: int(file.name[len("pocket"):-len("_atm.pdb")]))
        return [numpy.mean([place_of(line) for line in open(file) if line.startswith("ATOM")], axis=0)
                for file in files]
    spheres = {}
    for line in open(folder / (path.stem + "_out.pdb")):
        if line.startswith("HETATM") and line[17:20] == "STP":
            spheres.setdefault(int(line[22:26]), []).append(place_of(line))
    return [numpy.mean(spheres[rank], axis=0) for rank in sorted(spheres)]


def chance(hits):
    """Expected successes, at first and among three, of pockets taken in random order."""
    first = sum(h.mean() for h in hits if len(h))
    three = 0.0
    for h in hits:
        good, count = int(h.sum()), len(h)
        misses = 1.0
        for k in range(min(3, count)):
            misses *= max(0, count - good - k) / (count - k)
        three += 1.0 - misses
    return first, three


def print_table(names, found):
    print("| | " + " | ".join(names) + " | first | among three | by chance |")
    print("|---|" + "---|" * (len(names) + 3))
    for name, distances in found.items():
        cells = [f"{d[0]:.1f} ({min(d[:3]):.1f})" for d in distances]
        first = sum(d[0] <= SUCCESS for d in distances)
        three = sum(min(d[:3]) <= SUCCESS for d in distances)
        by_chance = "{:.1f}, {:.1f}".format(*chance([numpy.array(d) <= SUCCESS for d in distances]))
        print(f"| {name} | " + " | ".join(cells) + f" | {first} | {three} | {by_chance} |")


def print_sweep(table):
    """`table`: for each setting whether it succeeds (first, among three) on each complex."""
    settings = sorted(table)
    success = numpy.array([table[setting] for setting in settings])  # setting, complex, rank
    sums = success.sum(axis=1)
    print(f"{len(settings)} settings: first {sums[:, 0].min()} to {sums[:, 0].max()}, "
          f"median {numpy.median(sums[:, 0]):g}; among three {sums[:, 1].min()} to {sums[:, 1].max()}")
    for burial, power in itertools.product(BURIAL, POWERS):
        chosen = [setting[2:] == (burial, power) for setting in settings]
        if not any(chosen):
            continue
        some = sums[chosen]
        print(f"  burial radius {burial:g}, power {power}: first {some[:, 0].min()} to {some[:, 0].max()}, "
              f"median {numpy.median(some[:, 0]):g}; among three {some[:, 1].min()} to {some[:, 1].max()}")
    left_out = numpy.zeros(2)
    for i in range(success.shape[1]):
        others = numpy.delete(success, i, axis=1).sum(axis=1)
        best = others[numpy.lexsort((others[:, 1], others[:, 0]))[-1]]
        ties = (others == best).all(axis=1)
        left_out += success[ties, i].mean(axis=0)
    print("leave one out, mean over the settings that are best on the others: first {:.2f}, among "
          "three {:.2f}".format(*left_out))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--fpocket")
    parser.add_argument("--sweep", action="store_true")
    options = parser.parse_args()
    # name: (method, which lines of the file it gets: a function of the line and whether it is the ligand's)
    without_ligand = lambda line, is_ligand: not is_ligand
    methods = {"pockets": (by_isthmus, without_ligand)}
    if options.fpocket:
        for name, takes in (
            ("the ligand's lines removed", without_ligand),
            ("all HETATM lines removed", lambda line, is_ligand: not line.startswith("HETATM")),
            ("the ligand kept", lambda line, is_ligand: True),
        ):
            for centre, by_atoms in (("spheres", False), ("lining atoms", True)):
                methods[f"fpocket, {name}, mean of its {centre}"] = (
                    lambda path, by_atoms=by_atoms: by_fpocket(options.fpocket, path, by_atoms), takes)
    found = {name: [] for name in methods}
    sweep = {}
    names = []
    for row in csv.DictReader(open(options.folder / "ligands.csv")):
        path = (options.folder / row["file"]).resolve()
        lines, ligand = split(path, row)
        names.append(path.name.split(".")[0])

        def distances(centres):
            return [numpy.linalg.norm(ligand - c, axis=1).min() for c in centres] or [numpy.inf]

        with tempfile.TemporaryDirectory() as folder:
            files = {}
            for name, (method, takes) in methods.items():
                if takes not in files:
                    files[takes] = Path(folder) / f"{names[-1]}{len(files)}.pdb"
                    files[takes].write_text("".join(line for line, mark in lines if takes(line, mark)))
                found[name].append(distances(method(files[takes])))
            for setting in SETTINGS if options.sweep else ():
                for power, centres in by_scores(files[without_ligand], *setting).items():
                    d = distances(centres)
                    sweep.setdefault((*setting, power), []).append((d[0] <= SUCCESS, min(d[:3]) <= SUCCESS))
    print_table(names, found)
    if sweep:
        print("Radii only, burial radius 10 and power 2:")
        print_sweep({setting: rows for setting, rows in sweep.items() if setting[2:] == (10.0, 2)})
        print("All four:")
        wide = {setting[:2] for setting in sweep if setting[2] != 10.0}
        print_sweep({setting: rows for setting, rows in sweep.items() if setting[:2] in wide})


if __name__ == "__main__":
    main()
