"""Electrostatics of molecules from PQR files: energies beside APBS' published ones, and a picture.

Usage: pvpython electrostatics.py [--table FOLDER] [--molecule FILE.pqr] [--output FOLDER]

--table FOLDER   APBS' examples (born, ionize, solv in it): their solvation energies on the same van
                 der Waals surface (srad 0) as APBS' published results use, and on this filter's own
                 Gaussian surface. kJ/mol.
--molecule FILE  a PQR file: its surface coloured from -5 (red) to 5 (blue) kT/e with the isopotential
                 surfaces at -1 and 1 kT/e, saved as electrostatics.png.
--output FOLDER  where the picture goes; default: the current folder.
"""

import argparse
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus

# Name, file, dielectric constants of solute, solvent and reference, K, APBS' published kJ/mol.
CASES = (
    ("Born ion, 3 angstrom", "born/ion.pqr", 1.0, 78.54, 1.0, 298.15, -229.774),
    ("methanol", "solv/methanol.pqr", 2.0, 78.0, 1.0, 300.0, -36.2486),
    ("methoxide", "solv/methoxide.pqr", 2.0, 78.0, 1.0, 300.0, -390.4122),
    ("acetic acid", "ionize/acetic-acid.pqr", 2.0, 78.0, 2.0, 293.0, -22.6788),
    ("acetate", "ionize/acetate.pqr", 2.0, 78.0, 2.0, 293.0, -199.746),
    ("proton", "ionize/proton.pqr", 2.0, 78.0, 2.0, 293.0, -297.46),
)
SPACING = 0.2


def atoms_of(path):
    reader = simple.OpenDataFile(str(path))
    reader.UpdatePipeline()
    return reader.GetClientSideObject().GetOutputDataObject(0)


def union_of_balls(atoms):
    """An image that is above 0 in the balls and below outside: R - distance, the largest of all."""
    points = vtk_to_numpy(atoms.GetPoints().GetData()).astype(float)
    radii = vtk_to_numpy(atoms.GetPointData().GetArray("Radius")).astype(float)
    low = (points - radii[:, None]).min(axis=0) - 2.0
    counts = numpy.ceil(((points + radii[:, None]).max(axis=0) + 2.0 - low) / SPACING).astype(int) + 1
    axes = [low[a] + SPACING * numpy.arange(counts[a]) for a in range(3)]
    z, y, x = numpy.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    best = numpy.full(x.shape, -numpy.inf)
    for point, radius in zip(points, radii):
        if radius > 0.0:
            distance = numpy.sqrt((x - point[0]) ** 2 + (y - point[1]) ** 2 + (z - point[2]) ** 2)
            best = numpy.maximum(best, radius - distance)
    image = vtkImageData()
    image.SetDimensions(*(int(c) for c in counts))
    image.SetOrigin(*low)
    image.SetSpacing(SPACING, SPACING, SPACING)
    array = numpy_to_vtk(best.ravel(), deep=True)
    array.SetName("Depth")
    image.GetPointData().SetScalars(array)
    return image


def energy(atoms, surface, solute, solvent, kelvin):
    solver = isthmus.vtkPoissonBoltzmann()
    solver.SetInputDataObject(0, atoms)
    if surface is not None:
        solver.SetInputDataObject(1, surface)
        solver.SetIsoValue(0.0)
    solver.SetSoluteDielectric(solute)
    solver.SetSolventDielectric(solvent)
    solver.SetTemperature(kelvin)
    solver.SetSpacing(SPACING)
    solver.Update()
    return solver.GetOutput().GetFieldData().GetArray("SolvationEnergyKilojoule").GetValue(0)


def table(folder):
    print(f"{'kJ/mol':24}{'APBS, vdW surface':>20}{'ours, vdW':>12}{'ours, Gaussian':>16}")
    for name, path, solute, solvent, reference, kelvin, published in CASES:
        atoms = atoms_of(folder / path)
        balls = union_of_balls(atoms)
        values = []
        for surface in (balls, None):
            value = energy(atoms, surface, solute, solvent, kelvin)
            if reference != solute:
                value -= energy(atoms, surface, solute, reference, kelvin)
            values.append(value)
        print(f"{name:24}{published:20.2f}{values[0]:12.2f}{values[1]:16.2f}")


def picture(path, output):
    atoms = simple.OpenDataFile(str(path))
    solver = simple.PoissonBoltzmann(Input=atoms, IonicStrength=0.15)
    solver.UpdatePipeline()
    view = simple.CreateView("RenderView")
    view.ViewSize = [1000, 800]
    surface = simple.Show(simple.OutputPort(solver, 1), view)
    simple.ColorBy(surface, ("POINTS", "Potential"))
    colours = simple.GetColorTransferFunction("Potential")
    colours.RGBPoints = [-5.0, 0.8, 0.1, 0.1, 0.0, 1.0, 1.0, 1.0, 5.0, 0.1, 0.2, 0.8]
    surface.SetScalarBarVisibility(view, True)
    for value, colour in ((-1.0, [0.9, 0.3, 0.3]), (1.0, [0.3, 0.4, 0.9])):
        level = simple.Contour(Input=simple.OutputPort(solver, 0),
                               ContourBy=["POINTS", "Potential"], Isosurfaces=[value])
        shown = simple.Show(level, view)
        simple.ColorBy(shown, None)
        shown.DiffuseColor = colour
        shown.Opacity = 0.2
    simple.ResetCamera(view)
    output.mkdir(parents=True, exist_ok=True)
    simple.SaveScreenshot(str(output / "electrostatics.png"), view)
    print(output / "electrostatics.png")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--table", type=Path)
    parser.add_argument("--molecule", type=Path)
    parser.add_argument("--output", type=Path, default=Path("."))
    chosen = parser.parse_args()
    if not chosen.table and not chosen.molecule:
        parser.error("give --table, --molecule or both")
    if chosen.table:
        table(chosen.table)
    if chosen.molecule:
        picture(chosen.molecule, chosen.output)


main()
