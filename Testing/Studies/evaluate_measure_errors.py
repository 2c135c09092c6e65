"""Measures how well the errors that Surface Measures and Pore Profile state cover the true ones.

Usage: pvpython evaluate_measure_errors.py [--cases N] [--seed N]

Surfaces: spheres, ellipsoids, tori, spherocylinders and unions of two spheres, turned and moved at random, with 3 to 14
nodes for each smallest radius. Each is the level 0 of a signed distance, of a smooth edge (its tanh), or, for spheres and
ellipsoids, of 1 - q with the quadratic form q, measured as a volume, and contoured by flying edges; area and volume are known. Pores: cylinders,
hyperboloids and cones of rings of atoms, with planes 0.25 to 1.5 angstrom apart, whose exact radius is the least over
the rings. Compared are the smallest radius of the pore, and, at a random plane, the largest deviation of the exact
radius from the line between the planes beside it.

Prints a table in Markdown: share of cases in which the estimate covers the true error, median of estimate / true error,
and share of these ratios above 10, both without errors below 0.1 %.
"""

import argparse

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D

import study_paths  # noqa: F401 (before isthmus)
import isthmus

PI = numpy.pi


def ellipsoid_area(axes):
    """By Gauss' rule along the polar angle and the trapezoidal rule around."""
    a, b, c = axes
    places, weights = numpy.polynomial.legendre.leggauss(200)
    polar, around = numpy.meshgrid((places + 1) * PI / 2, (numpy.arange(200) + 0.5) * PI / 100, indexing="ij")
    element = numpy.sin(polar) * numpy.sqrt((b * c * numpy.sin(polar) * numpy.cos(around)) ** 2
                                            + (a * c * numpy.sin(polar) * numpy.sin(around)) ** 2
                                            + (a * b * numpy.cos(polar)) ** 2)
    return (element * weights[:, None]).sum() * PI / 2 * PI / 100


def scaled(points, axes):
    return points / numpy.asarray(axes).reshape(3, *[1] * (points.ndim - 1))


def ellipsoid_distance(axes):
    """To first order; exact at the surface."""
    def field(points):
        q = scaled(points, axes)
        length = numpy.sqrt((q ** 2).sum(0)) + 1e-12
        return (1 - length) * length / numpy.sqrt((scaled(q, axes) ** 2).sum(0) + 1e-12)
    return field


def two_spheres(small, distance):
    """Area and volume of the union of spheres of radius 1 and `small`."""
    plane = (distance ** 2 + 1 - small ** 2) / (2 * distance)
    area = volume = 0.0
    for radius, cap in ((1.0, 1 - plane), (small, small - (distance - plane))):
        area += 4 * PI * radius ** 2 - 2 * PI * radius * cap
        volume += 4 * PI / 3 * radius ** 3 - PI * cap ** 2 * (3 * radius - cap) / 3
    return area, volume


def shape(kind, random):
    """Field, area, volume, smallest radius, largest distance from the origin; the field with 1 - q, if any."""
    norm = lambda p: numpy.sqrt((p ** 2).sum(0))  # noqa: E731
    if kind == "sphere":
        return lambda p: 1 - norm(p), 4 * PI, 4 * PI / 3, 1.0, 1.0, lambda p: 1 - (p ** 2).sum(0)
    if kind == "ellipsoid":
        axes = (1.0, random.uniform(1, 2), random.uniform(1, 2.5))
        return (ellipsoid_distance(axes), ellipsoid_area(axes), 4 * PI / 3 * numpy.prod(axes), 1.0, max(axes),
                lambda p: 1 - (scaled(p, axes) ** 2).sum(0))
    if kind == "torus":
        large = random.uniform(1.6, 3.0)
        return (lambda p: 1 - numpy.hypot(numpy.hypot(p[0], p[1]) - large, p[2]), 4 * PI ** 2 * large,
                2 * PI ** 2 * large, 1.0, large + 1, None)
    if kind == "spherocylinder":
        half = random.uniform(0.5, 2.0)
        return (lambda p: 1 - numpy.sqrt(p[0] ** 2 + p[1] ** 2 + numpy.maximum(abs(p[2]) - half, 0) ** 2),
                4 * PI + 4 * PI * half, 4 * PI / 3 + 2 * PI * half, 1.0, 1 + half, None)
    small, distance = random.uniform(0.7, 1.0), random.uniform(0.6, 1.3)
    return (lambda p: numpy.maximum(1 - norm(p), small - numpy.sqrt(p[0] ** 2 + p[1] ** 2 + (p[2] - distance) ** 2)),
            *two_spheres(small, distance), small, 1 + distance, None)


SHAPES = ("sphere", "ellipsoid", "torus", "spherocylinder", "two spheres")


def volume_of(field, h, extent, random):
    """A field that is turned and moved at random, on nodes of spacing h."""
    turn = numpy.linalg.qr(random.normal(size=(3, 3)))[0]
    half = int(numpy.ceil(1.05 * extent / h)) + 3
    axis = numpy.arange(-half, half + 1) * h
    nodes = numpy.stack(numpy.meshgrid(axis, axis, axis, indexing="ij"))
    values = field(numpy.tensordot(turn, nodes + random.uniform(-0.5, 0.5, (3, 1, 1, 1)) * h, 1))
    image = vtkImageData()
    image.SetDimensions(*[len(axis)] * 3)
    image.SetSpacing(h, h, h)
    image.GetPointData().SetScalars(numpy_to_vtk(values.transpose(2, 1, 0).ravel(), deep=True))
    return image


def contour(image):
    surface = vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, 0.0)
    surface.Update()
    return surface.GetOutput()


def surface_case(kind, random):
    """Relative (true, stated) errors of area and volume of the contour, and of the level itself."""
    field, area, volume, small, extent, quadratic = shape(kind, random)
    form = random.integers(3 if quadratic else 2)
    width = small * random.uniform(0.15, 0.45)
    chosen = (field, lambda p: numpy.tanh(field(p) / width), quadratic)[form]
    h = small / numpy.exp(random.uniform(numpy.log(3), numpy.log(14)))
    image = volume_of(chosen, h, extent, random)
    pairs = []
    for data in (contour(image), image):
        measures = isthmus.vtkSurfaceMeasures()
        measures.SetInputData(data)
        measures.SetLevel(0.0)
        measures.Update()
        fields = measures.GetOutputDataObject(0).GetFieldData()
        value = {name: fields.GetArray(name).GetValue(0) for name in ("Area", "Volume", "AreaError", "VolumeError")}
        pairs += [(abs(value["Area"] - area) / area, value["AreaError"] / area),
                  (abs(value["Volume"] - volume) / volume, value["VolumeError"] / volume)]
    return pairs


def rings(kind, random):
    """Heights and radii of rings, radius of the atoms: a pore of the kind along z."""
    atom, throat = random.uniform(1.2, 1.9), random.uniform(1.0, 2.5)
    heights = numpy.arange(-12, 12.01, random.uniform(0.8, 3.0)) + random.uniform(-0.5, 0.5)
    if kind == "cylinder":
        radii = numpy.full_like(heights, throat + atom)
    elif kind == "hyperboloid":
        radii = numpy.hypot(throat + atom, random.uniform(0.15, 0.35) * heights)
    else:
        radii = throat + atom + random.uniform(0.02, 0.12) * (heights + 12)
    return heights, radii, atom


def pore_of(heights, radii, atom, spacing, offset):
    """Pore Profile along z: heights and radii of its samples, their errors; the table's radius and error."""
    places = []
    for number, (z, r) in enumerate(zip(heights, radii)):
        count = max(12, int(numpy.ceil(2 * PI * r / 1.5)))
        angles = (numpy.arange(count) + 0.5 * (number % 2)) * 2 * PI / count
        places.append(numpy.stack([r * numpy.cos(angles), r * numpy.sin(angles), numpy.full(count, z)], 1))
    places = numpy.concatenate(places)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    atoms = vtkPolyData()
    atoms.SetPoints(points)
    vertices = vtkCellArray()
    for i in range(len(places)):
        vertices.InsertNextCell(1, [i])
    atoms.SetVerts(vertices)
    radius = numpy_to_vtk(numpy.full(len(places), atom), deep=True)
    radius.SetName("Radius")
    atoms.GetPointData().AddArray(radius)
    profile = isthmus.vtkPoreProfile()
    profile.SetInputData(atoms)
    profile.SetMode(isthmus.vtkPoreProfile.PointAndDirection)
    profile.SetPoint(0.0, 0.0, offset)
    profile.SetSpacing(spacing)
    profile.SetEndRadius(8.0)
    profile.Update()
    samples, table = profile.GetProfile(), profile.GetPoreTable()
    column = lambda name: vtk_to_numpy(samples.GetColumnByName(name))  # noqa: E731
    return (column("Z"), column("Radius"), column("RadiusError"),
            table.GetValueByName(0, "Radius").ToDouble(), table.GetValueByName(0, "RadiusError").ToDouble())


def pore_case(kind, random):
    """Relative (true, stated) errors of the smallest radius, and of the profile at a random plane."""
    heights, radii, atom = rings(kind, random)
    spacing = random.uniform(0.25, 1.5)
    z, radius, error, narrowest, narrowest_error = pore_of(heights, radii, atom, spacing, random.uniform(-1, 1))

    def exact(at):
        return (numpy.hypot(radii[:, None], numpy.asarray(at)[None] - heights[:, None]) - atom).min(0)
    inside = (z > heights[0]) & (z < heights[-1])
    # Beyond the ends of a cylinder the pore is wider, so the smallest radius lies between planes inside.
    least = exact(numpy.linspace(z[inside][0] - spacing, z[inside][-1] + spacing, 20001)).min()
    chosen = random.choice(numpy.flatnonzero(inside)[1:-1])
    off = 0.0
    for i in (chosen - 1, chosen):
        share = numpy.linspace(0, 1, 101)
        line = radius[i] + share * (radius[i + 1] - radius[i])
        off = max(off, abs(exact(z[i] + share * (z[i + 1] - z[i])) - line).max())
    return (((narrowest - least) / least, narrowest_error / least), (off / radius[chosen], error[chosen] / radius[chosen]))


PORES = ("cylinder", "hyperboloid", "cone")


def summary(pairs):
    """Coverage, median ratio, share of ratios above 10, counted errors."""
    true, stated = numpy.array(pairs).T
    counted = true > 1e-3
    ratios = stated[counted] / true[counted]
    return (float(numpy.mean(stated >= true)), float(numpy.median(ratios)) if counted.any() else numpy.nan,
            float(numpy.mean(ratios > 10)) if counted.any() else 0.0, int(counted.sum()))


def evaluate(cases, seed):
    """Rows of the table by name: pairs of true and stated errors."""
    random = numpy.random.default_rng(seed)
    surfaces = [surface_case(SHAPES[i % len(SHAPES)], random) for i in range(cases)]
    pores = [pore_case(PORES[i % len(PORES)], random) for i in range(cases)]
    return {"`AreaError`": [case[0] for case in surfaces], "`VolumeError`": [case[1] for case in surfaces],
            "`AreaError` of a level": [case[2] for case in surfaces],
            "`VolumeError` of a level": [case[3] for case in surfaces],
            "`RadiusError` of the smallest radius": [case[0] for case in pores],
            "`RadiusError` along the pore": [case[1] for case in pores]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    print("| estimate | cases | covered, % | errors above 0.1 % | median of estimate / error | above 10, % |\n"
          "|---|---|---|---|---|---|")
    for name, pairs in evaluate(options.cases, options.seed).items():
        covered, median, above, counted = summary(pairs)
        print(f"| {name} | {len(pairs)} | {100 * covered:.1f} | {counted} | {median:.1f} | {100 * above:.1f} |",
              flush=True)


if __name__ == "__main__":
    main()
