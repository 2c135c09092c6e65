"""Complexes of the shared data, their ligands, and pockets of any text of a PDB file."""

import csv
import gzip
import os
import tempfile

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import isthmus
from shared_data import shared_data


def lines_of(path):
    with (gzip.open if path.suffix == ".gz" else open)(path, "rt", errors="replace") as file:
        # Displacements would stay without the atoms that a test takes out.
        return [line for line in file if not line.startswith("ANISOU")]


def place_of(line):
    return [float(line[start : start + 8]) for start in (30, 38, 46)]


def complexes():
    """(name, lines, one copy of the ligand as a mask over the lines) of each shared complex."""
    folder = shared_data("molecules/complexes")
    for row in csv.DictReader(open(folder / "ligands.csv")):
        path = (folder / row["file"]).resolve()
        lines = lines_of(path)
        mask = [
            line.startswith("HETATM")
            and line[17:20].strip() == row["ligand_residue"]
            and row["chain"] in ("", line[21])
            and row["residue_number"] in ("", line[22:26].strip())
            for line in lines
        ]
        yield path.name.split(".")[0], lines, mask


def read(lines):
    """The reader's atoms of a PDB file's lines."""
    handle, name = tempfile.mkstemp(suffix=".pdb")
    with os.fdopen(handle, "w") as file:
        file.writelines(lines)
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(name)
    reader.Update()
    os.remove(name)
    return reader.GetOutput()


def pockets(atoms, arrays=(), **settings):
    finder = isthmus.vtkMolecularPockets()
    for name in arrays:
        finder.GetOutputArraySelection().EnableArray(name)
    finder.SetInputData(atoms)
    for name, value in settings.items():
        getattr(finder, "Set" + name)(value)
    finder.Update()
    return finder


def columns(table):
    return {
        table.GetColumnName(c): vtk_to_numpy(table.GetColumn(c))
        for c in range(table.GetNumberOfColumns())
        if table.GetColumn(c).IsA("vtkDataArray")
    }


def centers(finder):
    values = columns(finder.GetPocketTable())
    return numpy.stack([values["Center" + axis] for axis in "XYZ"], axis=1)


def distances(finder, ligand, count=3):
    """Of the first centers from the nearest of the ligand's atoms."""
    ligand = numpy.asarray(ligand)
    return [numpy.linalg.norm(ligand - c, axis=1).min() for c in centers(finder)[:count]]
