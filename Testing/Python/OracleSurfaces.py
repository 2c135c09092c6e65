"""Filters of surfaces and meshes on random ones with known answers (oracle_tools.py)."""

import numpy
from scipy.special import elliprg

import isthmus
from oracle_tools import (
    Pose, Volume, add_array, area_of, array, box, box_distance, column, dihedral_angles, euler_number, field,
    icosphere, main, oracle, points_of, poly_data, rounding, settle, tetrahedra_of, tetrahedron_volumes, torus,
    torus_distance, triangle_angles, triangles_of, unstructured, volume_of)


def shape(draw, size):
    """Points, triangles, (area, volume, genus), their relative errors: a box, an ellipsoid or a torus.

    Boxes are exact, and so are tori, as the solids of flat facets that they are. An ellipsoid's facets lie
    between it and itself times sqrt(1 - r^2), r the largest circumradius on the unit sphere: areas of convex
    bodies one within the other ascend, and so do volumes.
    """
    kind = draw.choice(["box", "ellipsoid", "torus"])
    if kind == "box":
        sides = size * draw.between(0.3, 1.0, 3)
        points, triangles = box(sides, draw.whole(1, 4), draw)
        a, b, c = sides
        return points, triangles, (2 * (a * b + b * c + c * a), a * b * c, 0), (0.0, 0.0)
    if kind == "ellipsoid":
        points, triangles, radius = icosphere(3)
        axes = size * draw.between(0.2, 0.5, 3)
        a, b, c = axes**2
        area = 4 * numpy.pi * elliprg(a * b, b * c, c * a)
        return points * axes, triangles, (area, 4 / 3 * numpy.pi * axes.prod(), 0), (radius**2, 1.5 * radius**2)
    big = size * draw.between(0.25, 0.35)
    small = big * draw.between(0.1, 0.4)
    n, m = draw.whole(3, 40), draw.whole(3, 30)
    points, triangles, v = torus(big, small, n, m)
    rho, z = big + small * numpy.cos(v[:m]), small * numpy.sin(v[:m])
    slant = numpy.hypot((rho - numpy.roll(rho, 1)) * numpy.cos(numpy.pi / n), z - numpy.roll(z, 1))
    area = n * (slant * (rho + numpy.roll(rho, 1))).sum() * numpy.sin(numpy.pi / n)
    volume = n * numpy.sin(2 * numpy.pi / n) * big * m / 2 * small**2 * numpy.sin(2 * numpy.pi / m)
    return points, triangles, (area, volume, 1), (0.0, 0.0)


@oracle("Surface Measures")
def surface_measures(draw):
    """Boxes, ellipsoids and tori beside each other, some with a cavity: area, volume, genus, components.
    Tolerance: that of shape(), and rounding of the points: error x length of edges, error x area."""
    size = draw.unit * 10.0
    points, triangles, count = [], [], 0
    area = volume = genus = area_error = volume_error = 0.0
    solids = draw.whole(1, 3)
    for i in range(solids):
        p, t, (a, v, g), (ea, ev) = shape(draw, size)
        parts = [(Pose(draw, 0.0).world(p), t, a, v, g, ea, ev)]
        if draw.chance(0.3):
            # A cavity in a box that is larger than all else.
            sides = size * draw.between(1.3, 2.0, 3)
            q, u = box(sides, 2, draw)
            s = sides.prod()
            f = 2 * (sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0])
            parts = [(p, t[:, ::-1], a, -v, g, ea, ev), (q, u, f, s, 0, 0.0, 0.0)]
        for p, t, a, v, g, ea, ev in parts:
            points.append(p + [5.0 * size * i, 0.0, 0.0])
            triangles.append(t + count)
            count += len(p)
            area, volume, genus = area + a, volume + v, genus + g
            area_error, volume_error = area_error + a * ea, volume_error + abs(v) * ev
    components = len(points)
    pose = Pose(draw, size)
    points, triangles = pose.world(numpy.concatenate(points)), numpy.concatenate(triangles)
    facing = draw.choice([1, 1, -1]) if components == solids else 1
    data = poly_data(draw, points, triangles[:, ::facing])
    error = 3 * rounding(data)
    edges = numpy.linalg.norm(points[triangles] - points[numpy.roll(triangles, 1, 1)], axis=2).sum()
    measured = settle(isthmus.vtkSurfaceMeasures(), [data])
    output = measured.GetOutput()
    yield "area", field(output, "Area") - area, area_error + error * edges + 1e-12 * area
    yield "volume", field(output, "Volume") - facing * volume, volume_error + error * area + 1e-12 * volume
    for name, wanted in (("Genus", genus), ("Components", components), ("OpenEdges", 0), ("IrregularPoints", 0)):
        yield name, field(output, name) - wanted, 0.0
    table = measured.GetTable()
    yield "areas of components", column(table, "Area")[1:].sum() - area, area_error + error * edges + 1e-12 * area


@oracle("Surface To Grid")
def surface_to_grid(draw):
    """A box on a grid in another pose: inside, signed distance, crossings and their normals.
    Tolerance: rounding of the points within the band and with ExactEverywhere (2^-20 h for crossings); beyond, never too small, and too
    large by h^2 / (2 distance), since a crossing lies within a spacing h of the nearest point (the header); by 2 h
    within h of an edge, where the nearest crossing may be a face's cell away, h x h stretched by up to sqrt(3)."""
    size = draw.unit * 10.0
    sides = size * draw.between(0.4, 1.0, 3)
    pose = Pose(draw, size)
    points, triangles = box(sides, draw.whole(1, 3), draw)
    data = poly_data(draw, pose.world(points), triangles)
    grid = Volume(draw, lambda p: p[:, 0], pose.center, 0.75 * size, 13)
    exact_everywhere = draw.chance(0.3)
    filter_ = settle(isthmus.vtkSurfaceToGrid(), [data, grid.data], ExactEverywhere=exact_everywhere)
    output = filter_.GetOutput().GetPointData()
    error = 4 * rounding(data) + 4 * rounding(grid.points)
    exact = box_distance(pose.local(grid.points), sides)
    inside = array(output, "Inside") > 0
    yield "inside", (inside != (exact < 0)) & (numpy.abs(exact) > error), 0
    found = array(output, "SignedDistance")
    beyond = (numpy.abs(exact) > 2 * grid.h) & (not exact_everywhere)
    # The nearest point of the box, and whether it is at least one spacing from the edges of its face.
    local = pose.local(grid.points)
    foot = numpy.clip(local, -sides / 2, sides / 2)
    within = exact < 0
    gaps = sides / 2 - numpy.abs(foot)
    axis = gaps.argmin(1)
    numpy.put_along_axis(foot, axis[:, None], numpy.where(
        within, numpy.sign(local[numpy.arange(len(local)), axis]) * sides[axis] / 2,
        foot[numpy.arange(len(local)), axis])[:, None], 1)
    flat = numpy.sort(sides / 2 - numpy.abs(foot), 1)[:, 1] > grid.h
    excess = numpy.abs(found) - numpy.abs(exact)
    yield "sign", (numpy.sign(found) != numpy.sign(exact)) & (numpy.abs(exact) > error), 0
    yield "distance", excess[~beyond], error
    yield "distance too small", numpy.maximum(-excess[beyond], 0.0), error
    for where, part, most in (("over faces", flat & beyond, grid.h**2 / (2 * numpy.maximum(numpy.abs(exact), 1e-99))),
                              ("at edges", ~flat & beyond, numpy.full(len(exact), 2 * grid.h))):
        yield f"distance beyond the band {where}", numpy.maximum(excess[part], 0.0), error + most[part]
    crossings = filter_.GetCrossings()
    # Lines are crossed where the surface is whose corners have moved to a lattice of 2^-20 spacings.
    error += 4 * rounding(crossings) + 2.0**-20 * grid.h
    places = pose.local(points_of(crossings))
    yield "crossings", box_distance(places, sides), error
    normals = array(crossings.GetPointData(), "Normals") @ pose.axes
    # The face of a crossing is that which it is nearest to.
    gaps = numpy.abs(numpy.abs(places) - sides / 2)
    clear = numpy.sort(gaps, 1)[:, 1] > 10 * error
    axis = gaps.argmin(1)
    along = numpy.take_along_axis(normals * numpy.sign(places), axis[:, None], 1)[:, 0]
    yield "normals", (along - 1.0)[clear], 1e-6 + (10 * error / sides.min())
    # Each line of the grid crosses a convex body twice or not at all.
    node, axes = array(crossings.GetPointData(), "Node"), array(crossings.GetPointData(), "Axis").astype(int)
    index = grid.index[node.astype(int)]
    lines = numpy.array([axes, *(numpy.where(axes == a, -1, index[:, a]) for a in range(3))])
    _, counts = numpy.unique(lines, axis=1, return_counts=True)
    yield "crossings of a line", counts % 2, 0


@oracle("Area Quantiles")
def area_quantiles(draw):
    """Height on a sphere, even by area: the quantile q is radius x (2 q - 1); of an image, numpy's.
    Tolerance: the height that an edge spans, since a value has the area around its point, and twice the
    relative error of the facets' areas."""
    quantiles = numpy.sort(draw.between(0.0, 1.0, 2))
    if draw.chance(0.3):
        volume = Volume(draw, lambda p: draw.random.normal(size=len(p)), numpy.zeros(3), 1.0, 8,
                        kinds=[numpy.float32, numpy.float64])
        filter_ = isthmus.vtkAreaQuantiles()
        filter_.SetInputArrayToProcess(0, 0, 0, 0, "Field")
        settle(filter_, [volume.data], Lower=quantiles[0], Upper=quantiles[1])
        values = numpy.sort(array(volume.data.GetPointData(), "Field"))
        below = [numpy.searchsorted(values, v, "left") / len(values) for v in column(filter_.GetOutput(), "Range")]
        yield "share of nodes", below - quantiles, 1.001 / len(values)
        return
    radius = draw.unit * draw.between(1.0, 10.0)
    points, triangles, circumradius = icosphere(4)
    pose = Pose(draw, radius)
    scale, offset = draw.choice([-1.0, 1.0]) * draw.between(0.1, 100.0), draw.between(-10.0, 10.0)
    heights = points @ draw.direction()
    data = poly_data(draw, pose.world(radius * points), triangles, {"Height": scale * heights + offset})
    where = 0
    if draw.chance():
        where = 1
        middles = array(data.GetPointData(), "Height")[triangles_of(data)].mean(1)
        data.GetPointData().RemoveArray("Height")
        add_array(data.GetCellData(), "Height", middles)
    filter_ = isthmus.vtkAreaQuantiles()
    filter_.SetInputArrayToProcess(0, 0, 0, where, "Height")
    settle(filter_, [data], Lower=quantiles[0], Upper=quantiles[1])
    wanted = numpy.sort(2 * quantiles - 1)
    if scale < 0:
        # What is above falls to below.
        wanted = numpy.sort(2 * (1 - quantiles) - 1)[::-1]
    longest = numpy.linalg.norm(points[triangles] - points[numpy.roll(triangles, 1, 1)], axis=2).max()
    yield "height", (column(filter_.GetOutput(), "Range") - offset) / scale - wanted, longest + 2 * circumradius**2


@oracle("Surface Curvature")
def surface_curvature(draw):
    """Tori, regular in their parameters: mean, Gaussian and principal curvatures, the Euler number.
    Tolerance, k = largest curvature, h = longest edge: second order, k (k h)^2 and k^2 (k h)^2, with the radius
    of the ball for h where the tensor is averaged; principal curvatures are H +- sqrt(H^2 - K), which loses
    nothing here, as they differ everywhere."""
    big = draw.unit * draw.between(2.0, 10.0)
    small = big * draw.between(0.25, 0.5)
    m = draw.whole(24, 32)
    n = int(m * big / small * draw.between(0.9, 1.2))
    points, triangles, v = torus(big, small, n, m)
    k = max(1 / small, 1 / (big - small))
    h = numpy.linalg.norm(points[triangles] - points[numpy.roll(triangles, 1, 1)], axis=2).max()
    pose = Pose(draw, big)
    facing = draw.choice([1, -1])
    data = poly_data(draw, pose.world(points), triangles[:, ::facing], {"Angle": v}, numpy.float64)
    filter_, tensor = isthmus.vtkSurfaceCurvature(), draw.chance(0.3)
    if tensor:
        h *= 2.0
        settle(filter_, [data], Method=draw.choice([1, 2]), Neighbourhood=draw.choice([1, 2]), Radius=h)
    else:
        settle(filter_, [data], DualArea=draw.choice([0, 2]))
    output = filter_.GetOutput()
    angle = array(output.GetPointData(), "Angle")
    first, second = 1 / small, numpy.cos(angle) / (big + small * numpy.cos(angle))
    yield "valid", array(output.GetPointData(), "CurvatureValid") - 1, 0
    tolerance = k * (k * h)**2
    for name, wanted, scale in (("MeanCurvature", (first + second) / 2, 1.0),
                                ("GaussianCurvature", first * second, k),
                                ("MaximumCurvature", first + 0 * second, 1.0), ("MinimumCurvature", second, 1.0)):
        yield ("tensor " if tensor else "") + name, array(output.GetPointData(), name) - wanted, tolerance * scale
    yield "sum of PointArea", array(output.GetPointData(), "PointArea").sum() / area_of(points, triangles) - 1, 1e-9
    if not tensor:
        yield "Euler number", field(output, "GaussBonnetEulerNumber"), 1e-9 * len(points)


@oracle("Polarized Curvature")
def polarized_curvature(draw):
    """A potential that is trilinear along the axes of its image: the products with given curvatures.
    Tolerance: rounding, since trilinear interpolation is exact for it."""
    radius = draw.unit * 5.0
    points, triangles, _ = icosphere(2)
    pose = Pose(draw, radius)
    kappa = draw.random.normal(size=(2, len(points))) / radius
    data = poly_data(draw, pose.world(radius * points), triangles,
                     {"MaximumCurvature": kappa.max(0), "MinimumCurvature": kappa.min(0)}, numpy.float64)
    c = draw.random.normal(size=8)
    grid = None

    def potential(p):
        x, y, z = ((p - pose.center) @ axes / radius).T
        return c[0] + c[1] * x + c[2] * y + c[3] * z + c[4] * x * y + c[5] * y * z + c[6] * z * x + c[7] * x * y * z
    axes = numpy.eye(3)
    grid = Volume(draw, lambda p: p[:, 0], pose.center, draw.choice([0.8, 1.2]) * radius, 12,
                  kinds=[numpy.float32, numpy.float64])
    axes = grid.axes
    kind = draw.choice([numpy.float32, numpy.float64])
    add_array(grid.data.GetPointData(), "Potential", potential(grid.points).astype(kind))
    threshold = draw.choice([0.0, 0.3 / radius])
    output = settle(isthmus.vtkPolarizedCurvature(), [data, grid.data], ClassThreshold=threshold).GetOutput()
    values = output.GetPointData()
    places = points_of(output)
    low, high = grid.points[0] @ axes, grid.points[-1] @ axes
    along = places @ axes
    within = ((along >= low) & (along <= high)).all(1)
    yield "PotentialValid", array(values, "PotentialValid") - within, 0
    first, second = array(values, "MaximumCurvature")[within], array(values, "MinimumCurvature")[within]
    phi = potential(places)[within]
    error = 30 * numpy.finfo(kind).eps * numpy.abs(c).sum() + 30 * rounding(places) / radius * numpy.abs(c).sum()
    yield "Potential", array(values, "Potential")[within] - phi, error
    largest = numpy.maximum(numpy.abs(first), numpy.abs(second))
    plus, minus = numpy.maximum(phi, 0), numpy.minimum(phi, 0)
    for name, wanted in (("PositivePotentialKappa1", plus * first), ("PositivePotentialKappa2", plus * second),
                         ("NegativePotentialKappa1", minus * first), ("NegativePotentialKappa2", minus * second),
                         ("PolarizedCurvature", phi * second)):
        yield name, array(values, name)[within] - wanted, error * largest + 1e-15 / radius
    convex, concave = numpy.abs(phi * first) * (first > 0), numpy.abs(phi * second) * (second < 0)
    classes = numpy.where(convex >= concave, 1, 2) + 2 * (phi < 0)
    amplitude = numpy.maximum(convex, concave)
    classes[amplitude <= threshold] = 0
    near = (numpy.abs(convex - concave) < 3 * error * largest) | (numpy.abs(amplitude - threshold) < 3 * error * largest)
    yield "SiteClass", ((array(values, "SiteClass")[within] - classes) != 0) & ~near, 0
    yield "off the grid", ~numpy.isnan(array(values, "PolarizedCurvature")[~within]), 0


def clipped(polygon, gradient, level):
    """The part of a convex polygon where gradient . x is below the level."""
    result = []
    values = polygon @ gradient - level
    for i in range(len(polygon)):
        j = (i + 1) % len(polygon)
        if values[i] < 0:
            result.append(polygon[i])
        if (values[i] < 0) != (values[j] < 0):
            result.append(polygon[i] + (polygon[j] - polygon[i]) * values[i] / (values[i] - values[j]))
    return numpy.array(result).reshape(-1, 3)


def polygon_area(polygon):
    if len(polygon) < 3:
        return 0.0
    fan = numpy.cross(polygon[1:-1] - polygon[0], polygon[2:] - polygon[0])
    return numpy.linalg.norm(fan.sum(0)) / 2


@oracle("Scalar Regions")
def scalar_regions(draw):
    """Boxes with two scalars that are linear in space: areas between thresholds, joint areas, histogram.
    Tolerance: rounding, since a linear scalar's areas are cut from triangles exactly."""
    size = draw.unit * 10.0
    sides = size * draw.between(0.3, 1.0, 3)
    points, triangles = box(sides, draw.whole(1, 5), draw)
    gradients = [draw.direction() / size for _ in range(2)]
    pose = Pose(draw, size)
    scalars = {name: points @ g for name, g in zip(("First", "Second"), gradients)}
    data = poly_data(draw, pose.world(points), triangles, scalars, numpy.float64)
    thresholds = [numpy.sort(draw.between(-0.6, 0.6, draw.whole(1, 4))) for _ in range(2)]
    filter_ = isthmus.vtkScalarRegions()
    filter_.SetInputArrayToProcess(0, 0, 0, 0, "First")
    filter_.SetInputArrayToProcess(1, 0, 0, 0, "Second")
    filter_.SetNumberOfThresholds(len(thresholds[0]))
    filter_.SetNumberOfSecondThresholds(len(thresholds[1]))
    for i, t in enumerate(thresholds[0]):
        filter_.SetThreshold(i, t)
    for i, t in enumerate(thresholds[1]):
        filter_.SetSecondThreshold(i, t)
    settle(filter_, [data], UseSecondScalar=True, HistogramBins=8)
    corners, quads = box(sides)
    faces = []
    for a, b in zip(quads[::2], quads[1::2]):
        faces.append(corners[[a[0], a[1], a[2], b[2]]])

    def below(first, second):
        total = 0.0
        for face in faces:
            part = face
            for level, gradient in ((first, gradients[0]), (second, gradients[1])):
                if len(part) and numpy.isfinite(level):
                    part = clipped(part, gradient, level)
            total += polygon_area(part)
        return total
    levels = [numpy.concatenate([t, [numpy.inf]]) for t in thresholds]
    both = numpy.array([[below(a, b) for b in levels[1]] for a in levels[0]])
    joint = numpy.diff(numpy.diff(numpy.pad(both, ((1, 0), (1, 0))), axis=0), axis=1)
    table = filter_.GetRegionTable()
    error = 1e-9 * both[-1, -1] + 10 * rounding(data) * size
    yield "areas", column(table, "Area") - joint.sum(1), error
    yield "fractions", column(table, "Fraction") - joint.sum(1) / both[-1, -1], error / both[-1, -1]
    names = [table.GetColumnName(i) for i in range(table.GetNumberOfColumns())][-joint.shape[1]:]
    yield "joint areas", numpy.stack([column(table, name) for name in names], 1) - joint, error
    low, high = scalars["First"].min(), scalars["First"].max()
    edges = numpy.linspace(low, high, 9)
    wanted = numpy.diff([0.0] + [below(e, numpy.inf) for e in edges[1:-1]] + [both[-1, -1]])
    yield "histogram", column(filter_.GetHistogram(), "Area") - wanted, error


@oracle("Dual Contouring")
def dual_contouring(draw):
    """Spheres and tori sampled on a grid: distance of the points, volume, a closed surface.
    Tolerance, h = Spacing, d = sqrt(3) h the diagonal of a cell, k = largest curvature: a point is where the
    tangent planes of crossings within d meet best, k d^2 / 2 above the surface at most; sag of the facets; the
    volume is that over the area, and twice as much for triangles between such points."""
    size = draw.unit * 10.0
    pose = Pose(draw, size)
    if draw.chance():
        radius = size / 2
        points, triangles, circumradius = icosphere(4)
        points, sag = radius * points, radius * (1 - numpy.sqrt(1 - circumradius**2))
        exact, k, genus = (lambda p: numpy.linalg.norm(p, axis=1) - radius), 1 / radius, 0
        area, volume = 4 * numpy.pi * radius**2, 4 / 3 * numpy.pi * radius**3
    else:
        big = size * draw.between(0.3, 0.35)
        small = big * draw.between(0.4, 0.5)
        points, triangles, _ = torus(big, small, 80, 40)
        sag = (big + small) * (1 - numpy.cos(numpy.pi / 80)) + small * (1 - numpy.cos(numpy.pi / 40))
        exact, k, genus = (lambda p: torus_distance(p, big, small)), 1 / small, 1
        area, volume = 4 * numpy.pi**2 * big * small, 2 * numpy.pi**2 * big * small**2
    data = poly_data(draw, pose.world(points), triangles)
    h = size / draw.between(16.0, 20.0)
    output = settle(isthmus.vtkDualContouring(), [data], Spacing=h).GetOutput()
    found, cells = points_of(output), triangles_of(output)
    error = 1.5 * k * h**2 + sag + 30 * rounding(data)
    yield "distance of points", exact(pose.local(found)), error
    yield "volume", volume_of(found, cells) - volume, 2 * area * error
    yield "Euler number", euler_number(cells) - 2 + 2 * genus, 0


@oracle("Offset Surface")
def offset_surface(draw):
    """Boxes from outside, spheres and tori from either side: distances of the points, area.
    Tolerance, h = GridSpacing, r = least radius of the offset's curvature: the exact distance, linear between two
    nodes, is off by h^2 / (8 r), of nodes one h nearer, and h / 4 times the turn between facets; sag of the facets. Area: the same over r, twice, and the
    facets' angles, (h / r)^2 / 2; over the edges of a box, all of it has the radius of the offset."""
    size = draw.unit * 10.0
    pose, side = Pose(draw, size), draw.choice([0, 1])
    kind = draw.choice(["box", "sphere", "torus"])
    if kind == "box":
        side, sides = 1, size * draw.between(0.3, 1.0, 3)
        points, triangles = box(sides, 2, draw)
        distance, sag = size * draw.between(0.2, 0.5), 0.0
        turn, least, exact = 0.0, distance, lambda p: box_distance(p, sides)
        a, b, c = sides
        area = 2 * (a * b + b * c + c * a) + 2 * numpy.pi * distance * (a + b + c) + 4 * numpy.pi * distance**2
    elif kind == "sphere":
        radius = size * draw.between(0.4, 0.7)
        points, triangles, circumradius = icosphere(4)
        points, sag, turn = points * radius, radius * (1 - numpy.sqrt(1 - circumradius**2)), 2 * circumradius
        distance = radius * draw.between(0.2, 0.5)
        least = radius - distance if side == 0 else radius + distance
        exact = lambda p: numpy.linalg.norm(p, axis=1) - radius  # noqa: E731
        area = 4 * numpy.pi * least**2
    else:
        big = size * draw.between(0.4, 0.6)
        small = big * draw.between(0.3, 0.5)
        points, triangles, _ = torus(big, small, 72, 36)
        sag = (big + small) * (1 - numpy.cos(numpy.pi / 72)) + small * (1 - numpy.cos(numpy.pi / 36))
        turn, distance = 2 * numpy.pi / 36, small * draw.between(0.1, 0.3)
        tube = small - distance if side == 0 else small + distance
        least = min(tube, big - tube)
        exact = lambda p: torus_distance(p, big, small)  # noqa: E731
        area = 4 * numpy.pi**2 * big * tube
    data = poly_data(draw, pose.world(points), triangles)
    filter_ = settle(isthmus.vtkOffsetSurface(), [data], Distance=distance, Side=side,
                     Resolution=24 if kind != "torus" else 40)
    output = filter_.GetOutput()
    found, cells, h = points_of(output), triangles_of(output), field(output, "GridSpacing")
    nearer = least - h
    error = sag + h**2 / (8 * nearer) + h * turn / 4 + 4 * rounding(data)
    yield f"distance, {kind}", exact(pose.local(found)) + (distance if side == 0 else -distance), error
    yield f"area, {kind}", area_of(found, cells) / area - 1, 2 * error / least + (h / nearer)**2 / 2
    yield "Euler number", euler_number(cells) - (0 if kind == "torus" else 2), 0


@oracle("Surface Remesh")
def surface_remesh(draw):
    """Boxes, whose edges are kept: volume, area, distance of the points; spheres: distance, angles, mean edge.
    Tolerance: rounding for boxes, since points stay on the faces and features on the edges; the sag of both
    meshes for spheres."""
    size = draw.unit * 10.0
    pose = Pose(draw, size)
    if draw.chance():
        sides = size * draw.between(0.5, 1.0, 3)
        points, triangles = box(sides, draw.whole(2, 4), draw)
        data = poly_data(draw, pose.world(points), triangles, kind=numpy.float64)
        length = sides.min() * draw.between(0.2, 0.4)
        output = settle(isthmus.vtkSurfaceRemesh(), [data], Target=1, EdgeLength=length).GetOutput()
        found, cells = points_of(output), triangles_of(output)
        error = 10 * rounding(data) + 1e-7 * size
        yield "box: distance", box_distance(pose.local(found), sides), error
        yield "box: volume", volume_of(found, cells) / sides.prod() - 1, 10 * error / sides.min()
        area = 2 * (sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0])
        yield "box: area", area_of(found, cells) / area - 1, 10 * error / sides.min()
        yield "box: Euler number", euler_number(cells) - 2, 0
        return
    radius = size / 2
    points, triangles, circumradius = icosphere(3)
    data = poly_data(draw, pose.world(radius * points), triangles)
    delaunay = draw.chance()
    length = radius * draw.between(0.25, 0.4)
    filter_ = isthmus.vtkSurfaceRemesh()
    output = settle(filter_, [data], Target=1, EdgeLength=length, Method=int(delaunay)).GetOutput()
    found, cells = points_of(output), triangles_of(output)
    sag = radius * (1 - numpy.sqrt(1 - circumradius**2)) + 4 * rounding(data)
    distance = numpy.linalg.norm(pose.local(found), axis=1) - radius
    yield "sphere: distance", numpy.where(distance > 0, distance, 0), 4 * rounding(data) + 1e-7 * size
    yield "sphere: sag", numpy.where(distance < 0, distance, 0), sag + 1e-7 * size
    edges = numpy.linalg.norm(found[cells] - found[numpy.roll(cells, 1, 1)], axis=2)
    if delaunay:
        circles = edges.prod(1) / 4 / numpy.array([area_of(found, c[None]) for c in cells])
        yield "sphere: circumscribed circles", max(circles.max() / length * numpy.sqrt(3) - 1, 0), 1e-6
        yield "sphere: least angle", max(25.0 - triangle_angles(found, cells).min(), 0), 1e-6
    else:
        # Split above 4/3, collapsed below 4/5 of the length, which the last round may leave: the mean is between.
        yield "sphere: mean edge", numpy.log(edges.mean() / length), numpy.log(4 / 3)
    yield "sphere: Euler number", euler_number(cells) - 2, 0


@oracle("Tetrahedral Mesher")
def tetrahedral_mesher(draw):
    """Boxes and ellipsoids, some in a box, some with a cavity: volume by region, the faces of the surface.
    Tolerance: rounding, since TetGen keeps the triangles; for another backend HausdorffDistance x area."""
    size = draw.unit * 10.0
    pose = Pose(draw, size)
    kind = draw.choice(["solid", "cavity"])
    if draw.chance():
        points, triangles = box(size * draw.between(0.2, 0.5, 3), 1, draw)
    else:
        points, triangles, _ = icosphere(1)
        points = points * (size * draw.between(0.1, 0.25, 3))
    inner = volume_of(points, triangles)
    volumes = {1: inner}
    if kind == "cavity":
        outer, more = box(size * draw.between(0.7, 1.0, 3), 1, draw)
        volumes = {1: volume_of(outer, more) - inner, -1: inner}
        triangles = numpy.concatenate([triangles[:, ::-1], more + len(points)])
        points = numpy.concatenate([points, outer])
    points = pose.world(points)
    data = poly_data(draw, points, triangles, kind=numpy.float64)
    side, margin = draw.choice([0, 0, 1, 2]), draw.between(0.2, 0.6)
    output = settle(isthmus.vtkTetrahedralMesher(), [data], Library=2, Side=side, BoxMargin=margin).GetOutput()
    found, cells = tetrahedra_of(output)
    volume = tetrahedron_volumes(found, cells)
    region = array(output.GetCellData(), "RegionId").astype(int)
    yield "orientation", volume <= 0, 0
    moved = field(output, "HausdorffDistance")
    if output.GetFieldData().GetAbstractArray("Engine").GetValue(0) != "TetGen":
        # Where TetGen fails, another backend moves the surface, by no more than it says.
        yield "volume with a surface that moved", volume[region > 0].sum() - volumes[1], \
            1.1 * moved * area_of(points, triangles)
        return
    bounds = points.max(0) - points.min(0)
    whole = (bounds + 2 * margin * numpy.linalg.norm(bounds)).prod()
    wanted = {0: {1: volumes[1]}, 1: {k: v for k, v in volumes.items() if k < 0}, 2: dict(volumes)}[side]
    if side:
        wanted[0] = whole - sum(volumes.values())
    yield "regions", len(set(region) ^ set(wanted)), 0
    for k, v in wanted.items():
        yield f"volume of region {k}", volume[region == k].sum() / v - 1, 1e-9 + 100 * rounding(data) / size
    ids = array(output.GetPointData(), "OriginalPointId").astype(int)
    kept = points_of(data)[ids[ids >= 0]]
    yield "places of the surface's points", numpy.abs(found[ids >= 0] - kept), 2 * rounding(data)
    yield "missing points", len(points) - (ids >= 0).sum(), 0


@oracle("Mesh Quality")
def mesh_quality(draw):
    """Random triangles or tetrahedra: angles by cosines, circumradius over shortest edge, the histogram.
    Tolerance: rounding, which a flat cell's circumradius multiplies: 1e-9 over the sine of its smallest angle."""
    count = 100
    points = draw.random.normal(size=(count, 3)) * draw.unit
    if draw.chance():
        cells = numpy.array([draw.random.permutation(count)[:3] for _ in range(count)])
        data = poly_data(draw, points, cells, kind=numpy.float64)
        points, cells = points_of(data), triangles_of(data)
        angles = triangle_angles(points, cells)
    else:
        cells = numpy.array([draw.random.permutation(count)[:4] for _ in range(count)])
        data = unstructured(points, cells)
        angles = dihedral_angles(points, cells)
    bins = draw.whole(1, 90)
    filter_ = settle(isthmus.vtkMeshQualityReport(), [data], NumberOfBins=bins)
    values = filter_.GetOutputDataObject(0).GetCellData()
    sine = numpy.sin(numpy.radians(angles)).min(1)
    yield "SmallestAngle", array(values, "SmallestAngle") - angles.min(1), 1e-6
    yield "LargestAngle", array(values, "LargestAngle") - angles.max(1), 1e-6
    p = points[cells]
    shortest = numpy.min([numpy.linalg.norm(p[:, i] - p[:, j], axis=1)
                          for i in range(p.shape[1]) for j in range(i)], axis=0)
    # The circumcenter has equal distances: linear equations, for triangles by the least norm.
    radius = []
    for q in p:
        rows = q[1:] - q[0]
        center = numpy.linalg.lstsq(rows, (rows**2).sum(1) / 2, rcond=None)[0]
        radius.append(numpy.linalg.norm(center))
    ratio = numpy.array(radius) / shortest
    yield "RadiusEdgeRatio", array(values, "RadiusEdgeRatio") / ratio - 1, 1e-9 / sine**2
    table = filter_.GetOutputDataObject(1)
    wanted, edges = numpy.histogram(angles, bins, (0.0, 180.0))
    near = numpy.abs(angles[..., None] - edges).min() < 1e-9
    yield "histogram", 0 if near else numpy.abs(column(table, "Count") - wanted).max(), 0


if __name__ == "__main__":
    main()
