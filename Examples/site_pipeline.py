"""From charges or atoms to ranked binding sites: the steps of binding_sites.py, without pictures."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData,
    vtkFlyingEdges3D,
    vtkPolyDataConnectivityFilter,
    vtkThresholdPoints,
)
from vtkmodules.vtkFiltersModeling import vtkSelectEnclosedPoints

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus

DECAY = 1.2  # of the Gaussians: BindingSites.md describes the data used for tuning
SPACING = 0.6  # angstrom
WATER, SALT = 78.54, 0.15  # dielectric constant; mol/l
WITHOUT_HYDROGENS = 1.25  # roughly compensates for missing hydrogens in the radii of heavy atoms


def read_atoms(path):
    """Atoms with Radius from a PQR file (its own radii) or a PDB file (the reader's table)."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def density(atoms, decay=DECAY, spacing=SPACING, scale=1.0):
    """Sum of Gaussians whose level 1 encloses the balls of all atoms, their radii times `scale`."""
    gaussians = isthmus.vtkMolecularDensity()
    gaussians.SetInputData(atoms)
    gaussians.SetDecay(decay)
    gaussians.SetSpacing(spacing)
    gaussians.SetRadiusScale(scale)
    gaussians.Update()
    return gaussians.GetOutput()


def outer_surface(image, level=1.0, higher=True):
    """The largest component of a level set, with its curvatures; higher: whether the inside has the higher values."""
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, level)
    contour.ComputeNormalsOff()
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(contour.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    clean = vtkCleanPolyData()
    clean.SetInputConnection(largest.GetOutputPort())
    clean.PointMergingOff()
    curvature = isthmus.vtkHessianCurvature()
    curvature.SetInputData(image)
    curvature.SetInputConnection(1, clean.GetOutputPort())
    curvature.SetInsideIsHigher(higher)
    curvature.Update()
    return curvature.GetOutput()


def read_potential(path):
    reader = isthmus.vtkOpenDXReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def flow_image(atoms, spacing=SPACING):
    """The signed distance (active) from the minimal molecular surface of the atoms."""
    flow = isthmus.vtkMolecularFlowSurface()
    flow.SetInputData(atoms)
    flow.SetSpacing(spacing)
    flow.Update()
    image = flow.GetOutputDataObject(1)
    image.GetPointData().SetActiveScalars("SignedDistance")
    return image


def polarized(surface, potential=None):
    """The surface with PolarizedCurvature and related arrays; without an image, from its own array Potential."""
    products = isthmus.vtkPolarizedCurvature()
    products.SetInputData(surface)
    if potential:
        products.SetPotentialData(potential)
    products.Update()
    return products.GetOutput()


def with_potential(surface, atoms):
    """The closed surface with the potential of the atoms in it: Poisson-Boltzmann, 0.15 mol/l, fitted at
    its points from both sides."""
    solver = isthmus.vtkPoissonBoltzmann()
    solver.SetInputData(0, inside(surface, atoms))
    solver.SetInputData(1, surface)
    solver.SetSpacing(SPACING)
    solver.SetSolventDielectric(WATER)
    solver.SetIonicStrength(SALT)
    solver.Update()
    solved = solver.GetSurface()
    if not solved.GetNumberOfPoints():
        raise RuntimeError("The potential could not be computed; see the messages above.")
    return solved


def inside(surface, atoms):
    """The atoms enclosed by a closed surface; single ions may have a surface of their own."""
    test = vtkSelectEnclosedPoints()
    test.SetInputData(atoms)
    test.SetSurfaceData(surface)
    test.Update()
    kept = vtkThresholdPoints()
    kept.SetInputConnection(test.GetOutputPort())
    kept.SetInputArrayToProcess(0, 0, 0, 0, "SelectedPoints")
    kept.ThresholdByUpper(0.5)
    kept.Update()
    left_out = atoms.GetNumberOfPoints() - kept.GetOutput().GetNumberOfPoints()
    if left_out:
        print(f"{left_out} atoms lie outside of the largest surface: their charges are left out.")
    return kept.GetOutput()


def sites(surface, atoms=None, **settings):
    """(labelled surface, list of rows) of vtkBindingSites: pockets with atoms, else patches."""
    array = settings.pop("array", "PolarizedCurvature")
    finder = isthmus.vtkBindingSites()
    finder.SetInputData(surface)
    if atoms:
        finder.SetAtomsData(atoms)
    finder.SetInputArrayToProcess(0, 0, 0, 0, array)
    for name, value in settings.items():
        getattr(finder, "Set" + name)(value)
    finder.Update()
    table = finder.GetSiteTable()
    names = [table.GetColumnName(c) for c in range(table.GetNumberOfColumns())]
    rows = [
        {name: cell.ToString() if cell.IsString() else cell.ToDouble()
         for name, cell in ((name, table.GetValueByName(row, name)) for name in names)}
        for row in range(table.GetNumberOfRows())
    ]
    return finder.GetOutput(), rows


def center(row):
    return numpy.array([row["CenterX"], row["CenterY"], row["CenterZ"]])


def distance_to(points, place):
    """The distance from a position to the nearest of some points."""
    return float(numpy.linalg.norm(numpy.asarray(points) - place, axis=1).min())


def values(surface, name):
    return vtk_to_numpy(surface.GetPointData().GetArray(name)).astype(float)


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def triangles_of(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def point_areas(surface):
    """A third of the area of the triangles around each point."""
    points, triangles = points_of(surface), triangles_of(surface)
    corner = points[triangles]
    areas = numpy.linalg.norm(
        numpy.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1
    )
    return numpy.bincount(triangles.ravel(), numpy.repeat(areas / 6.0, 3), minlength=len(points))
