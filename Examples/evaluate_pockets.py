"""Where do pockets lie that rank first? Molecular Pockets beside fpocket, both without the ligand.

Usage: pvpython evaluate_pockets.py FOLDER [--fpocket PROGRAM]

FOLDER holds ligands.csv (file, ligand_residue, chain, residue_number) and the complexes it names. The
ligand's lines are taken out of each file before anything runs. Success: the pocket's centre (for
fpocket: the mean of its alpha spheres) within 4 angstrom of an atom of the ligand. fpocket is no part
of Debian: build it with its own qhull and name the program. Prints Markdown.
"""

import argparse
import csv
import gzip
import subprocess
import tempfile
from pathlib import Path

import numpy

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus

SUCCESS = 4.0  # angstrom


def place_of(line):
    return [float(line[start : start + 8]) for start in (30, 38, 46)]


def split(path, row):
    """The file's lines without the ligand, and the ligand's atoms."""
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
    protein = [line for i, line in enumerate(lines) if i not in ligand]
    return protein, numpy.array([place_of(lines[i]) for i in sorted(ligand)])


def by_isthmus(path):
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    finder = isthmus.vtkMolecularPockets()
    finder.SetInputConnection(reader.GetOutputPort())
    finder.Update()
    table = finder.GetPocketTable()
    return [
        [table.GetValueByName(row, "Center" + axis).ToDouble() for axis in "XYZ"]
        for row in range(min(3, table.GetNumberOfRows()))
    ]


def by_fpocket(program, path):
    subprocess.run([program, "-f", str(path)], check=True, stdout=subprocess.DEVNULL)
    spheres = {}
    for line in open(path.parent / (path.stem + "_out") / (path.stem + "_out.pdb")):
        if line.startswith("HETATM") and line[17:20] == "STP":
            spheres.setdefault(int(line[22:26]), []).append(place_of(line))
    return [numpy.mean(spheres[rank], axis=0) for rank in sorted(spheres)[:3]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--fpocket")
    options = parser.parse_args()
    methods = {"pockets": by_isthmus}
    if options.fpocket:
        methods["fpocket"] = lambda path: by_fpocket(options.fpocket, path)
    found = {name: [] for name in methods}
    names = []
    for row in csv.DictReader(open(options.folder / "ligands.csv")):
        path = (options.folder / row["file"]).resolve()
        protein, ligand = split(path, row)
        names.append(path.name.split(".")[0])
        with tempfile.TemporaryDirectory() as folder:
            bare = Path(folder) / (names[-1] + ".pdb")
            bare.write_text("".join(protein))
            for name, method in methods.items():
                centres = method(bare)
                found[name].append(
                    [numpy.linalg.norm(ligand - c, axis=1).min() for c in centres] or [numpy.inf]
                )
    print("| | " + " | ".join(names) + " | first | among three |")
    print("|---|" + "---|" * (len(names) + 2))
    for name, distances in found.items():
        cells = [f"{d[0]:.1f} ({min(d):.1f})" for d in distances]
        first = sum(d[0] <= SUCCESS for d in distances)
        three = sum(min(d) <= SUCCESS for d in distances)
        print(f"| {name} | " + " | ".join(cells) + f" | {first} | {three} |")


if __name__ == "__main__":
    main()
