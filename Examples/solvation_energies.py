"""Solvation energies of molecules whose surfaces and grids are given, so that differences of them are meaningful."""

import collections

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus

KELVIN = 298.15
COULOMB = 1389.35458  # kJ/mol angstrom: e^2 N_A / (4 pi eps0), CODATA 2018

# dielectrics: of solute, solvent and reference; salt in mol/l; spacing in angstrom.
Settings = collections.namedtuple("Settings", "dielectrics salt kelvin spacing nonlinear")


def read(path):
    """Positions, charges, radii."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    reader.Update()
    atoms = reader.GetOutput()
    data = atoms.GetPointData()
    return (vtk_to_numpy(atoms.GetPoints().GetData()).astype(float),
            vtk_to_numpy(data.GetArray("Charge")).astype(float),
            vtk_to_numpy(data.GetArray("Radius")).astype(float))


def molecule_of(positions, charges, radii):
    atoms, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(positions, deep=True))
    atoms.SetPoints(points)
    for name, values in (("Charge", charges), ("Radius", radii)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        atoms.GetPointData().AddArray(array)
    return atoms


def image_of(values, low, h):
    image = vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetOrigin(*low)
    image.SetSpacing(h, h, h)
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName("Surface")
    image.GetPointData().SetScalars(array)
    return image


def around(points, reaches, low, counts, h):
    """For each point, the part of the grid within its reach, and the distances there."""
    for i, (point, reach) in enumerate(zip(points, reaches)):
        first = numpy.maximum(numpy.floor((point - reach - low) / h).astype(int), 0)
        last = numpy.minimum(numpy.ceil((point + reach - low) / h).astype(int) + 1, counts)
        z, y, x = (low[a] + h * numpy.arange(first[a], last[a]) - point[a] for a in (2, 1, 0))
        away = numpy.sqrt(z[:, None, None] ** 2 + y[None, :, None] ** 2 + x[None, None, :] ** 2)
        yield i, tuple(slice(first[a], last[a]) for a in (2, 1, 0)), away


def union_of_balls(points, radii, low, counts, h):
    """An image that is positive inside the balls and negative outside: the maximum of R - distance over all balls,
    and constant from two angstrom outside them."""
    best = numpy.full(counts[::-1], -2.0)
    for i, part, away in around(points, radii + 2.0, low, counts, h):
        best[part] = numpy.maximum(best[part], radii[i] - away)
    return image_of(best, low, h)


def sum_of_gaussians(points, radii, low, counts, h, decay=2.3):
    """The filter's own kind of surface at level 1, on a given grid."""
    total = numpy.zeros(counts[::-1])
    solid = radii > 0.0
    points, radii = points[solid], radii[solid]
    for i, part, away in around(points, 2.8 * radii, low, counts, h):
        total[part] += numpy.exp(-decay * ((away / radii[i]) ** 2 - 1.0))
    return image_of(total, low, h)


def box_of(points, radii, h, padding=3.0):
    """First node and counts of a grid around the balls, its nodes at multiples of h."""
    low = numpy.floor(((points - radii[:, None]).min(axis=0) - padding) / h) * h
    high = (points + radii[:, None]).max(axis=0) + padding
    return low, numpy.ceil((high - low) / h).astype(int) + 1


def surface_of(kind, molecule, box, h):
    """(image, level, whether it is higher inside), or None for the filter's own sum of Gaussians."""
    points, charges, radii = molecule
    low, counts = box
    if kind == "gaussian":
        return sum_of_gaussians(points, radii, low, counts, h), 1.0, True
    if kind == "ses":
        source = isthmus.vtkMolecularFlowSurface()
        source.SetInputData(molecule_of(*molecule))
        source.SetMethod(isthmus.vtkMolecularFlowSurface.SolventExcluded)
        source.SetProbeRadius(1.4)
        source.SetSpacing(h)
        source.Update()
        image = source.GetOutputDataObject(1)
        image.GetPointData().SetActiveScalars("SignedDistance")
        return image, 0.0, False
    return union_of_balls(points, numpy.maximum(radii, 2.0) if kind == "none" else radii, low, counts, h), 0.0, True


def solvation(case, kind, molecule, box):
    """The energy of the transfer from the reference dielectric outside the surface to that of the solvent, kJ/mol.
    `case`: Settings, or what has the same attributes."""
    solute, solvent, reference = case.dielectrics
    surface = surface_of(kind, molecule, box, case.spacing)
    value = into_solvent(case, molecule, surface, solvent, case.salt)
    return value if reference == solute else value - into_solvent(case, molecule, surface, reference, 0.0)


def into_solvent(case, molecule, surface, solvent, salt):
    """The energy of the transfer from a medium with the dielectric of the solute everywhere."""
    image, level, higher = surface
    solver = isthmus.vtkPoissonBoltzmann()
    solver.SetInputData(0, molecule_of(*molecule))
    solver.SetInputData(1, image)
    solver.SetLevel(level)
    solver.SetInsideIsHigher(higher)
    solver.SetSoluteDielectric(case.dielectrics[0])
    solver.SetSolventDielectric(solvent)
    solver.SetTemperature(case.kelvin)
    solver.SetIonicStrength(salt)
    solver.SetNonlinear(case.nonlinear)
    solver.Update()
    if solver.GetOutput().GetNumberOfPoints() == 0:
        return float("nan")
    return solver.GetOutput().GetFieldData().GetArray("SolvationEnergyKilojoule").GetValue(0)


def coulomb_between(one, other, dielectric):
    """Interaction energy of two sets of charges, kJ/mol."""
    total = 0.0
    for x, q in zip(one[0], one[1]):
        total += q * (other[1] / numpy.linalg.norm(other[0] - x, axis=1)).sum()
    return COULOMB * total / dielectric
