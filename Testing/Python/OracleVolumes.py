"""Filters of volumes on random ones with known answers (oracle_tools.py)."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import isthmus
from oracle_tools import (
    Pose, Standards, Volume, area_of, array, column, dihedral_angles, euler_number, field, main, oracle, points_of,
    settle, tetrahedra_of, tetrahedron_volumes, torus_distance, triangle_angles, triangles_of, volume_of)


class Ball:
    """1 - |x|^2 / r^2 of the nearest of some balls: level 0 is their spheres, and a level l the ones of radius
    r sqrt(1 - l). Linear between nodes h apart, it is off by h^2 / 4 r^2 at most along an edge and three times
    that in a cell; the surface by half of r times as much."""

    def __init__(self, draw, size, count):
        self.radii = size * draw.between(0.6, 1.0, count)
        self.centers = numpy.zeros((count, 3))
        self.centers[:, 0] = 2.6 * size * (numpy.arange(count) - (count - 1) / 2)
        self.half = size * (1.4 + 1.3 * (count - 1))
        self.pose = Pose(draw, size)
        self.centers = self.pose.world(self.centers)

    def __call__(self, points):
        return numpy.max([1 - ((points - c)**2).sum(1) / r**2 for c, r in zip(self.centers, self.radii)], axis=0)

    def at_level(self, level):
        return self.radii * numpy.sqrt(1 - level)


def sphere_gap(points, centers, radii):
    """Signed distance to the nearest of some spheres that are apart."""
    gaps = numpy.array([numpy.linalg.norm(points - c, axis=1) - r for c, r in zip(centers, radii)])
    return numpy.take_along_axis(gaps, numpy.abs(gaps).argmin(0)[None], 0)[0]


@oracle("Map Surface")
def map_surface(draw):
    """Spheres in a volume of any type, spacing, direction: distance, areas of components, volume, level.
    Tolerance, d = diagonal of a cell, r = radius: points lie on edges of the grid, h^2 / (8 r) off, and the
    quantum of the type over the gradient; facets span a cell, sag d^2 / (8 r); areas and volumes twice the sum
    over r, and the facets' tilt (d / 2 r)^2."""
    size, count = draw.unit * 5.0, draw.whole(1, 2)
    ball = Ball(draw, size, count)
    inverse = draw.chance(0.3)
    sign = -1.0 if inverse else 1.0
    volume = Volume(draw, lambda p: sign * numpy.maximum(ball(p), -3.0), ball.pose.center, ball.half, 16 * count)
    level = draw.between(-0.1, 0.3)
    radii = ball.at_level(level)
    filter_ = settle(isthmus.vtkMapSurface(), [volume.data], Level=float(volume.stored(sign * level)),
                     InsideIsHigher=not inverse)
    output = filter_.GetOutput()
    points, cells = points_of(output), triangles_of(output)
    small = radii.min()
    # A value's error moves the surface by error r^2 / 2 level radius.
    quantum = volume.quantum * ball.radii.max()**2 / (2 * small)
    diagonal = numpy.linalg.norm(volume.spacing)
    off = small - numpy.sqrt(small**2 - volume.h**2 / 4) + 2 * quantum + 1e-5 * size
    yield "distance of points", sphere_gap(points, ball.centers, radii), off
    share = 2 * (off + diagonal**2 / (8 * small)) / small + (diagonal / (2 * small))**2
    exact = numpy.sort(4 * numpy.pi * radii**2)[::-1]
    found = array(output.GetFieldData(), "ComponentArea")
    yield "components", len(found) - count, 0
    yield "areas of components", found / exact - 1, share
    yield "volume", volume_of(points, cells) / (4 / 3 * numpy.pi * (radii**3).sum()) - 1, 1.5 * share
    yield "Euler number", euler_number(cells) - 2 * count, 0
    yield "level", (field(output, "Level") / volume.scale - volume.stored(sign * level) / volume.scale), 1e-9


@oracle("Delaunay Isosurface")
def delaunay_isosurface(draw):
    """A sphere in a volume: distance, volume, angles, topology.
    Tolerance: of points, 3 h^2 / (8 r), what trilinear interpolation does in a cell, and the quantum of the
    type; volume: that and Distance over the area; angles at least 30 degrees (the header)."""
    size = draw.unit * 5.0
    ball = Ball(draw, size, 1)
    volume = Volume(draw, ball, ball.pose.center, ball.half, 14, stretch=1.3)
    level = draw.between(-0.1, 0.3)
    radius = ball.at_level(level)[0]
    distance = 0.3 * volume.h
    output = settle(isthmus.vtkDelaunayIsosurface(), [volume.data], Level=float(volume.stored(level)),
                    Radius=2.0 * volume.h, Distance=distance).GetOutput()
    points, cells = points_of(output), triangles_of(output)
    off = 3 * volume.h**2 / (8 * radius) + 2 * volume.quantum * ball.radii[0]**2 / (2 * radius) + 1e-4 * size
    yield "distance of points", sphere_gap(points, ball.centers, [radius]), off
    yield "volume", volume_of(points, cells) / (4 / 3 * numpy.pi * radius**3) - 1, 3 * (off + distance) / radius
    yield "least angle", max(30.0 - triangle_angles(points, cells).min(), 0), 1e-3
    yield "Euler number", euler_number(cells) - 2, 0


@oracle("Isosurface Stuffing")
def isosurface_stuffing(draw):
    """A sphere in a volume: volume by region, distance of its points, dihedral angles.
    Tolerance: of points, 3 h^2 / (8 r) for the interpolation and as much for a lattice of CellSize h; the quantum
    of the type; volume: that and the sag of facets of a cell, over the area; angles as in the header."""
    size = draw.unit * 5.0
    ball = Ball(draw, size, 1)
    volume = Volume(draw, ball, ball.pose.center, ball.half, 12, stretch=1.3)
    level = draw.between(-0.1, 0.3)
    radius = ball.at_level(level)[0]
    side = draw.choice([0, 0, 1, 2])
    output = settle(isthmus.vtkIsosurfaceStuffing(), [volume.data], Level=float(volume.stored(level)), Side=side,
                    CellSize=volume.h, GradingLevels=draw.choice([0, 0, 2])).GetOutput()
    points, cells = tetrahedra_of(output)
    volumes = tetrahedron_volumes(points, cells)
    region = array(output.GetCellData(), "RegionId")
    off = 6 * volume.h**2 / (8 * radius) + 2 * volume.quantum * ball.radii[0]**2 / (2 * radius) + 1e-5 * size
    on = points[array(output.GetPointData(), "OnSurface") > 0]
    yield "distance of points", sphere_gap(on, ball.centers, [radius]), off
    yield "orientation", volumes <= 0, 0
    if side != 1:
        yield "volume inside", volumes[region == 1].sum() / (4 / 3 * numpy.pi * radius**3) - 1, \
            3 * (off + 3 * volume.h**2 / (8 * radius)) / radius
    angles = dihedral_angles(points, cells)
    yield "angles", max(10.7 - angles.min(), angles.max() - 164.8, 0), 0.05


def implicit_curvature(gradient, hessian):
    """Mean and Gaussian curvature of level sets that are higher inside (R. Goldman, CAGD 22 (2005) 632)."""
    length = numpy.linalg.norm(gradient, axis=1)
    bend = numpy.einsum("ni,nij,nj->n", gradient, hessian, gradient)
    mean = -(length**2 * numpy.trace(hessian, axis1=1, axis2=2) - bend) / (2 * length**3)
    rows = [numpy.cross(hessian[:, (i + 1) % 3], hessian[:, (i + 2) % 3]) for i in range(3)]
    cofactor = numpy.stack(rows, 1)
    return mean, numpy.einsum("ni,nij,nj->n", gradient, cofactor, gradient) / length**4


@oracle("Hessian Curvature")
def hessian_curvature(draw):
    """Quadratic forms, whose central differences are exact: curvatures at the nodes and at points.
    Tolerance, e = rounding of a value by its type: second differences are off by 4 e / h^2, in nine entries,
    first ones by e / h, over the gradient; a tenth of the output's single precision."""
    size = draw.unit * 5.0
    center = draw.center(size)
    form = draw.random.normal(size=(3, 3))
    form = (form + form.T) / size**2
    slope = draw.direction() * 2.0 / size

    def value(p):
        x = p - center
        return numpy.einsum("ni,ij,nj->n", x, form, x) / 2 + x @ slope
    volume = Volume(draw, value, center, size, 12, kinds=[numpy.float32, numpy.float64, numpy.int32])
    order = draw.choice([2, 4])
    higher = draw.chance()
    filter_ = settle(isthmus.vtkHessianCurvature(), [volume.data], AutomaticScale=False, Scale=0.0, Accuracy=order,
                     InsideIsHigher=higher)
    values = filter_.GetOutput().GetPointData()
    valid = array(values, "CurvatureValid") > 0
    border = ((volume.index < order // 2) | (volume.index >= volume.counts - order // 2)).any(1)
    x = volume.points - center
    gradient = x @ form + slope
    length = numpy.linalg.norm(gradient, axis=1)
    yield "validity", (valid == border) & (length > 1e-3 / size), 0
    hessian = numpy.broadcast_to(form, (len(x), 3, 3))
    mean, gauss = implicit_curvature(gradient, hessian)
    sign = 1.0 if higher else -1.0
    norm = numpy.linalg.norm(form)
    least = volume.spacing.min()
    # Stencils of order 4 have larger weights: 16/3 and 3/2 in place of 4 and 1.
    bend = 9 * 6 * volume.quantum / least**2 / length
    turn = 3 * 1.5 * volume.quantum / least / length
    error = 2 * bend + 4 * turn * norm / length
    flat = numpy.finfo(numpy.float32).eps * norm / length
    use = valid & (error < 0.5 * norm / length) & (length > 1e-2 / size)
    yield "MeanCurvature", (array(values, "MeanCurvature") - sign * mean)[use], (error + 2 * flat)[use]
    yield "GaussianCurvature", (array(values, "GaussianCurvature") - gauss)[use], \
        (4 * (error + flat) * norm / length)[use]


@oracle("Hessian Curvature: CurvatureError")
def curvature_error(draw):
    """A ball with a soft edge in white noise: CurvatureError is the standard error of the mean curvature at the edge.
    Tolerance: none but that, as the filter states it. Surroundings without structure show it the noise."""
    size = draw.unit * 10.0
    center, radius, width = draw.center(size), size * draw.between(0.5, 0.7), size * draw.between(0.08, 0.12)
    noise = draw.between(0.01, 0.05)

    def value(p):
        r = numpy.linalg.norm(p - center, axis=1)
        return 1 / (1 + numpy.exp((r - radius) / width)) + noise * draw.random.normal(size=len(p))
    volume = Volume(draw, value, center, 1.2 * size, 32, kinds=[numpy.float32], stretch=1.01)
    values = settle(isthmus.vtkHessianCurvature(), [volume.data]).GetOutput().GetPointData()
    r = numpy.linalg.norm(volume.points - center, axis=1)
    use = (array(values, "CurvatureValid") > 0) & (numpy.abs(r - radius) < width)
    yield "MeanCurvature", (array(values, "MeanCurvature") - 1 / r)[use], \
        Standards(array(values, "CurvatureError")[use])


@oracle("Scalar Persistence")
def scalar_persistence(draw):
    """Distances squared from a circle, a sphere or two points: birth, death and dimension of the features.
    Tolerance, d = diagonal of a cell: no node is farther than d / 2 from an extremum or saddle of radius R, where
    the function differs by (d / 2)^2 at most, and by as much again along the path or membrane of nodes; and 2 R
    times that path's distance d / 2 where the function has a slope across, at the cut of a sphere or circle."""
    size = draw.unit * 5.0
    pose = Pose(draw, size)
    radius = size * draw.between(0.4, 0.5)
    kind = draw.choice(["circle", "sphere", "points"])

    def value(p):
        q = pose.local(p)
        if kind == "circle":
            return torus_distance(q, radius, 0.0)**2
        if kind == "sphere":
            return (numpy.linalg.norm(q, axis=1) - radius)**2
        return numpy.minimum(((q - [radius, 0, 0])**2).sum(1), ((q + [radius, 0, 0])**2).sum(1))
    over = draw.chance()
    sign = -1.0 if over else 1.0
    volume = Volume(draw, lambda p: sign * value(p), pose.center, size, 18, stretch=1.2)
    filter_ = settle(isthmus.vtkScalarPersistence(), [volume.data], Superlevel=over,
                     MinimumPersistence=float(0.4 * radius**2 * volume.scale))
    table = filter_.GetDiagram()
    dimension = column(table, "Dimension").astype(int)
    birth = sign * (column(table, "Birth") - volume.offset) / volume.scale
    death = sign * (column(table, "Death") - volume.offset) / volume.scale
    d = numpy.linalg.norm(volume.spacing)
    low, slope = 0.75 * d**2 + 2 * volume.quantum, d * radius
    wanted = {"circle": 1, "sphere": 2, "points": 0}[kind]
    ends = numpy.isfinite(death)
    yield "classes that never die", (~ends).sum() - 1, 0
    yield "features", int((~ends | (dimension == wanted)).sum()) - 2, 0
    yield "other features", len(dimension) - 2, 0
    if len(dimension) == 2:
        yield f"birth, {kind}", birth[ends], d**2 + 2 * volume.quantum
        yield f"death, {kind}", death[ends] - radius**2, low + slope
        yield f"birth of the whole, {kind}", birth[~ends], low


@oracle("Map Handles")
def map_handles(draw):
    """A ring of density, 1 at its core: the window's level, what exists between, the stable level's contour.
    Tolerance, d = diagonal of a cell: as for Scalar Persistence, of a Gaussian of the distance."""
    size = draw.unit * 5.0
    pose = Pose(draw, size)
    radius, width = size * draw.between(0.5, 0.6), size * draw.between(0.22, 0.28)

    def value(p):
        return numpy.exp(-torus_distance(pose.local(p), radius, 0.0)**2 / (2 * width**2))
    volume = Volume(draw, value, pose.center, 1.2 * size, 20, kinds=[numpy.float32, numpy.float64], stretch=1.2)
    low = float(numpy.exp(-radius**2 / (2 * width**2)))
    levels = volume.stored([low / 2, 1.0])
    filter_ = settle(isthmus.vtkMapHandles(), [volume.data], Range=(float(levels[0]), float(levels[1])),
                     MinimumPersistence=1.0)
    windows = filter_.GetOutputDataObject(1)
    d = numpy.linalg.norm(volume.spacing)
    # The slope of a Gaussian is 0.61 / width at most, over half a diagonal.
    error = 0.61 / width * d / 2 + 2 * volume.quantum
    contour = filter_.GetOutputDataObject(4)
    level = (field(contour, "StableLevel") - volume.offset) / volume.scale
    yield "windows", windows.GetNumberOfPoints() - 1, 0
    if windows.GetNumberOfPoints() == 1:
        found = (array(windows.GetPointData(), "Level") - volume.offset) / volume.scale
        yield "level of the window", found - low, error
    yield "stable level", not low - error < level < 1, 0
    yield "Euler number of the contour", euler_number(triangles_of(contour)), 0


def cosine(draw, volume_kind, waves):
    """A cosine of `waves` halves along each axis of a box with no flux at its faces, half a cell beyond the nodes,
    and the eigenvalue of the 7-point Laplacian on it."""
    counts = numpy.array([draw.whole(10, 16) for _ in range(3)])
    volume = Volume(draw, lambda p: numpy.zeros(len(p)) + numpy.arange(len(p)) % 2, numpy.zeros(3), 5.0, 10,
                    kinds=[volume_kind], dimensions=counts)
    angle = numpy.pi * waves / counts
    values = numpy.cos(angle * (volume.index + 0.5)).prod(1)
    h = volume.spacing / volume.spacing.min()
    eigenvalue = (4 * numpy.sin(angle / 2)**2 / h**2).sum()
    stored = volume.data.GetPointData().GetScalars()
    vtk_to_numpy(stored)[:] = values
    return volume, values, eigenvalue, h


@oracle("High-Order Diffusion")
def high_order_diffusion(draw):
    """Cosines, which are eigenvectors of the grid's Laplacian: decay exp(-d eigenvalue^(q + 1) Time).
    Tolerance, z = rate x longest step, a twelfth of the time or seven explicit ones (SuperTimeStepping.h): of
    second order, rate x Time x z^2 / 6; rounding that grows with the square of a step's stages, 2 x step x the
    Laplacian's bound."""
    waves = numpy.array([draw.whole(0, 3) for _ in range(3)])
    kind = draw.choice([numpy.float32, numpy.float64])
    volume, values, eigenvalue, h = cosine(draw, kind, waves)
    order, rate = draw.whole(0, 3), draw.between(0.5, 2.0)
    time = draw.between(0.1, 2.0) / max(rate * eigenvalue**(order + 1), 0.1 * rate)
    diffusivity = [1.0] * 4
    diffusivity[order] = rate
    filter_ = settle(isthmus.vtkHighOrderDiffusion(), [volume.data], Order=order, EdgeStopping=0, Time=time,
                     Diffusivity=tuple(diffusivity))
    found = array(filter_.GetOutput().GetPointData(), "Field")
    rate *= eigenvalue**(order + 1)
    bound = diffusivity[order] * (4 / h**2).sum()**(order + 1)
    step = max(time / 12, 14 / bound)
    yield "values", found - values * numpy.exp(-rate * time), \
        rate * time * (rate * step)**2 / 6 + 2 * numpy.finfo(kind).eps * (2 * step * bound + 10)


@oracle("PDE Transform")
def pde_transform(draw):
    """Cosines: low-pass k multiplies them by 2^-(eigenvalue / that of wavelength k)^(q + 1); modes are differences.
    Tolerance: 1e-7 of the input in single and 1e-13 in double precision (the header), and rounding of a hundred
    stages."""
    kind = draw.choice([numpy.float32, numpy.float64])
    waves = numpy.array([draw.whole(0, 5) for _ in range(3)])
    volume, values, eigenvalue, _ = cosine(draw, kind, waves)
    modes, first, last = draw.whole(1, 4), draw.whole(0, 3), 0
    wavelength, ratio = draw.between(3.0, 6.0), draw.between(1.3, 2.5)
    filter_ = settle(isthmus.vtkPDETransform(), [volume.data], NumberOfModes=modes, FirstOrder=first, LastOrder=last,
                     FirstWavelength=wavelength, WavelengthRatio=ratio)
    output = filter_.GetOutput().GetPointData()
    left, error = 1.0, 1e-7 + 300 * numpy.finfo(kind).eps
    for k in range(modes):
        order = max(first - k, last)
        length = wavelength * ratio**k
        kept = left * numpy.exp(-numpy.log(2) * (eigenvalue / (2 * numpy.pi / length)**2)**(order + 1))
        yield "modes", array(output, f"Mode{k + 1}") - values * (left - kept), error
        left = kept
    yield "Residue", array(output, "Residue") - values * left, error


@oracle("Diffusion High Pass")
def diffusion_high_pass(draw):
    """Cosines: two linear equations for the amplitudes of both fields, solved exactly.
    Tolerance: coupling and diffusion alternate in 40 steps of second order, Time x step^2 x rate^3 / 12, rate the
    sum of all; in each, diffusion takes explicit steps or super steps of second order as well; 1e-5 for rounding."""
    waves = numpy.array([draw.whole(0, 3) for _ in range(3)])
    volume, values, eigenvalue, _ = cosine(draw, draw.choice([numpy.float32, numpy.float64]), waves)
    slow, fast = draw.between(0.0, 0.2), draw.between(0.3, 1.5)
    pull_u, pull_v, time = draw.between(0.0, 0.2), draw.between(0.0, 0.2), draw.between(0.5, 5.0)
    filter_ = settle(isthmus.vtkDiffusionHighPass(), [volume.data], DiffusivityU=slow, DiffusivityV=fast,
                     CouplingU=pull_u, CouplingV=pull_v, Time=time, Steps=40, arrays=["SlowField", "FastField"])
    rate = numpy.array([[-slow * eigenvalue - pull_u, pull_u], [pull_v, -fast * eigenvalue - pull_v]])
    total = (slow + fast) * eigenvalue + pull_u + pull_v
    lambdas, vectors = numpy.linalg.eig(rate)
    u, v = (vectors @ (numpy.exp(lambdas * time) * numpy.linalg.solve(vectors, [1.0, 1.0]))).real
    output = filter_.GetOutput().GetPointData()
    for name, wanted in (("HighPass", u - v), ("SlowField", u), ("FastField", v)):
        yield name, array(output, name) - wanted * values, 2 * time * (time / 40)**2 * total**3 / 12 + 1e-5


@oracle("Map Surface and Choking Loops")
def map_to_loops(draw):
    """A ring: the handle has the tube's radius, the tunnel that of the hole.
    Tolerance: radii lie within Uncertainty below the stated one; the surface is off by h^2 / (8 r) at its points
    and d^2 / (8 r) between, d the diagonal of a cell, r the smaller radius, and by the quantum of the type."""
    size = draw.unit * 10.0
    pose = Pose(draw, size)
    small = size * draw.between(0.18, 0.25)
    big = size * draw.between(0.55, 0.65)
    volume = Volume(draw, lambda p: -torus_distance(pose.local(p), big, small), pose.center, 1.1 * size, 26,
                    kinds=[numpy.float32, numpy.float64, numpy.int16], stretch=1.2)
    surface = settle(isthmus.vtkMapSurface(), [volume.data], Level=float(volume.stored(0.0)))
    filter_ = settle(isthmus.vtkChokingLoops(), [surface.GetOutput()], SampleSpacing=0.15 * size)
    loops = filter_.GetOutputDataObject(0).GetCellData()
    kind, radius = array(loops, "Kind"), array(loops, "Radius")
    slack = array(loops, "Uncertainty")
    d = numpy.linalg.norm(volume.spacing)
    off = (d**2 + volume.h**2) / (8 * min(small, big - small) - 4 * d) + 2 * volume.quantum
    for which, wanted, name in ((0, small, "handle"), (1, big - small, "tunnel")):
        yield f"{name}s", (kind == which).sum() - 1, 0
        found, least = radius[kind == which], (radius - slack)[kind == which]
        yield f"{name}: radius below", numpy.maximum(wanted - found, 0), off
        yield f"{name}: radius above", numpy.maximum(least - wanted, 0), off


if __name__ == "__main__":
    main()
