"""Filters of molecules and choking loops on random inputs with known answers (oracle_tools.py)."""

import numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

import isthmus
from oracle_tools import (
    Pose, add_array, array, column, field, main, oracle, points_of, poly_data, rounding, settle, torus, vtk_points)

COULOMB = 332.0637  # kcal angstrom / (mol e^2)


def atoms(draw, places, radii, **arrays):
    """Points in random order, in single or double precision."""
    order = draw.random.permutation(len(places))
    data = vtkPolyData()
    data.SetPoints(vtk_points(places[order].astype(draw.choice([numpy.float32, numpy.float64]))))
    add_array(data.GetPointData(), "Radius", numpy.broadcast_to(radii, len(places))[order].astype(float))
    for name, values in arrays.items():
        add_array(data.GetPointData(), name, numpy.broadcast_to(values, len(places))[order].astype(float))
    return data


def nodes_of(image):
    low, h, extent = image.GetOrigin(), image.GetSpacing(), image.GetExtent()
    x, y, z = (low[a] + h[a] * numpy.arange(extent[2 * a], extent[2 * a + 1] + 1) for a in range(3))
    k, j, i = numpy.meshgrid(z, y, x, indexing="ij")
    return numpy.stack([i.ravel(), j.ravel(), k.ravel()], 1)


@oracle("Molecular Density")
def molecular_density(draw):
    """A few atoms: the sum of Gaussians, or the union of balls, at every node.
    Tolerance: single precision of the sum, and of the places over the steepest slope, 2 decay d / R^2; balls are
    compared where a place's rounding does not decide."""
    unit = draw.unit
    count = draw.whole(1, 12)
    places = draw.center(unit * 20.0) + draw.random.normal(size=(count, 3)) * unit * 2.0
    radii = unit * draw.between(0.8, 2.0, count)
    data = atoms(draw, places, radii)
    places, radii = points_of(data), array(data.GetPointData(), "Radius")
    form, scale, decay = draw.whole(0, 1), draw.between(0.8, 1.5), draw.between(0.5, 4.0)
    output = settle(isthmus.vtkMolecularDensity(), [data], Form=form, RadiusScale=scale, Decay=decay,
                    Spacing=unit * draw.between(0.7, 1.2), Padding=tuple(unit * draw.between(2.0, 4.0, 3))).GetOutput()
    found, nodes = array(output.GetPointData(), "Density"), nodes_of(output)
    squared = ((nodes[:, None] - places[None])**2).sum(2) / (scale * radii)**2
    if form == 0:
        clear = numpy.abs(squared - 1).min(1) > 1e-5
        yield "union of balls", (found - (squared < 1).any(1))[clear], 0
        return
    exact = numpy.exp(-decay * (squared - 1)).sum(1)
    yield "sum of Gaussians", found - exact, 1e-5 * (exact + 1)
    bounds = numpy.concatenate([nodes.min(0), -nodes.max(0)])
    reach = numpy.concatenate([(places - (scale * radii)[:, None]).min(0), -(places + (scale * radii)[:, None]).max(0)])
    yield "padding", numpy.maximum(bounds - reach + 1.9 * unit, 0), 0


@oracle("Fullerene Stability")
def fullerene_stability(draw):
    """Regular polygons and cubes, exactly symmetric, one or two far apart: bars of rings and the cavity.
    Tolerance: rounding of the places, ten times, since a circumradius is a quotient of lengths."""
    size = draw.unit * 10.0
    places, rings, cavity = [], [], 0.0
    for i in range(draw.whole(1, 2)):
        edge = size * draw.between(0.1, 0.3)
        if draw.chance(0.6):
            n = draw.whole(4, 9)
            radius = edge / (2 * numpy.sin(numpy.pi / n))
            angle = 2 * numpy.pi * numpy.arange(n) / n
            shape = radius * numpy.stack([numpy.cos(angle), numpy.sin(angle), 0 * angle], 1)
            rings.append((edge / 2, radius))
        else:
            shape = edge * (numpy.indices((2, 2, 2)).reshape(3, -1).T - 0.5)
            # Twelve edges on eight corners close five cycles; its faces fill them, and the last but one its inside.
            rings += 5 * [(edge / 2, edge / numpy.sqrt(2))]
            cavity = max(cavity, edge * (numpy.sqrt(3) / 2 - numpy.sqrt(0.5)))
        places.append(Pose(draw, 0.0).world(shape) + [10.0 * size * i, 0.0, 0.0])
    data = atoms(draw, Pose(draw, size).world(numpy.concatenate(places)), 1.0)
    filter_ = settle(isthmus.vtkFullereneStability(), [data], FilterDelta=0.01 * size)
    table, bars = filter_.GetOutputDataObject(0), filter_.GetOutputDataObject(1)
    error = 20 * rounding(data)
    birth, death = numpy.array(rings).T
    long = column(bars, "Persistence")
    one = (column(bars, "Dimension") == 1) & (long > 0.01 * size)
    yield "bars", column(table, "Bars")[0] - len(rings), 0
    if one.sum() == len(rings):
        yield "births", numpy.sort(column(bars, "Birth")[one]) - numpy.sort(birth), error
        yield "deaths", numpy.sort(column(bars, "Death")[one]) - numpy.sort(death), error
    # Without short bars, of the ways from one molecule to the other.
    yield "FilteredIntegral", column(table, "FilteredIntegral")[0] - (death - birth).sum(), 4 * len(rings) * error
    yield "Cavity", column(table, "Cavity")[0] - cavity, 2 * error


def torus_surface(draw):
    big = draw.unit * draw.between(5.0, 8.0)
    small = big * draw.between(0.25, 0.6)
    n, m = 48, 28
    points, triangles, _ = torus(big, small, n, m)
    sag = (big + small) * (1 - numpy.cos(numpy.pi / n)) + small * (1 - numpy.cos(numpy.pi / m))
    data = poly_data(draw, Pose(draw, big).world(points), triangles[:, ::draw.choice([1, 1, -1])])
    return big, small, sag, data


@oracle("Choking Loops")
def choking_loops(draw):
    """A torus: its handle has the radius of the tube, its tunnel that of the hole.
    Tolerance: the sag of the facets; the true radius lies within Uncertainty below the stated one (the header)."""
    big, small, sag, data = torus_surface(draw)
    filter_ = settle(isthmus.vtkChokingLoops(), [data], SampleSpacing=0.4 * min(small, big - small))
    loops = filter_.GetOutput().GetCellData()
    kind, radius = array(loops, "Kind"), array(loops, "Radius")
    least = radius - array(loops, "Uncertainty")
    for which, wanted, name in ((0, small, "handle"), (1, big - small, "tunnel")):
        yield f"{name}s", (kind == which).sum() - 1, 0
        yield f"{name}: radius below", numpy.maximum(wanted - radius[kind == which], 0), sag
        yield f"{name}: radius above", numpy.maximum(least[kind == which] - wanted, 0), sag
    # A meridian of the tube; the hole's equator, the shortest of the tunnel's class.
    length = array(loops, "Length")
    yield "length of the handle's loop", length[kind == 0] - 2 * numpy.pi * small, 2 * numpy.pi * sag
    yield "length of the tunnel's loop", length[kind == 1] - 2 * numpy.pi * (big - small), 2 * numpy.pi * sag


@oracle("Handle Filling")
def handle_filling(draw):
    """A torus: filled or cut where the size is above its smaller radius, else as it was.
    Tolerance: none, of sizes farther from it than the sag of the facets and a sample."""
    big, small, sag, data = torus_surface(draw)
    side = draw.whole(0, 2)
    radius = {0: small, 1: big - small, 2: min(small, big - small)}[side]
    below = radius * draw.choice([draw.between(0.3, 0.7), draw.between(1.3, 2.0)])
    filter_ = settle(isthmus.vtkHandleFilling(), [data], FillHandlesBelow=below, Side=side,
                     SampleSpacing=0.4 * min(small, big - small))
    genus = array(filter_.GetOutput().GetFieldData(), "Genus")
    yield "genus", genus - [1, 0 if below > radius else 1], 0
    yield "left open", field(filter_.GetOutput(), "LeftOpen"), 0


@oracle("Pore Profile")
def pore_profile(draw):
    """A tube of rings with a waist: the radius at each ring, the narrowest one.
    Tolerance, s = Spacing: a plane lies within s / 2 of a ring, sqrt(r^2 + s^2 / 4) - r, r the ring's radius; half
    of the rest, as far as neighbouring rings are wider; the center is found to 1e-3."""
    count, n = draw.whole(9, 13), draw.whole(16, 20)
    atom, gap, waist = draw.between(1.5, 1.9), draw.between(1.0, 1.5), draw.whole(3, 5)
    narrow = draw.between(3.8, 4.4)
    # Wider away from the waist, by less than the distance between rings.
    widths = narrow + 0.04 * (numpy.arange(count) - waist)**2
    angle = 2 * numpy.pi * (numpy.arange(n)[None] + 0.5 * (numpy.arange(count)[:, None] % 2)) / n
    shape = numpy.stack([widths[:, None] * numpy.cos(angle), widths[:, None] * numpy.sin(angle),
                         gap * (numpy.arange(count) - waist)[:, None] + 0 * angle], -1).reshape(-1, 3)
    pose = Pose(draw, 20.0)
    data = atoms(draw, pose.world(shape), atom)
    spacing = draw.between(0.1, 0.3)
    filter_ = settle(isthmus.vtkPoreProfile(), [data], Mode=2, Point=tuple(pose.center),
                     Direction=tuple(pose.axes[:, 2] * draw.choice([-1.0, 1.0])), Spacing=spacing, EndRadius=8.0)
    table = filter_.GetPoreTable()
    yield "pores", table.GetNumberOfRows() - 1, 0
    if table.GetNumberOfRows() == 1:
        error = numpy.sqrt(narrow**2 + spacing**2 / 4) - narrow + 1e-3
        yield "least radius", column(table, "Radius")[0] - (narrow - atom), error
        place = numpy.array([column(table, "Bottleneck" + a)[0] for a in "XYZ"])
        yield "place along the pore", pose.local(place[None])[0, 2], gap
        yield "place across the pore", numpy.hypot(*pose.local(place[None])[0, :2]), 0.1


def sphere_distance(draw, radius, h, margin, upright=False):
    """Signed distance to a sphere on a grid of cubes around it, and its center."""
    center = draw.center(10.0)
    axes = numpy.eye(3) if upright else draw.rotation(mirrored=draw.chance(0.25))
    n = int(numpy.ceil(2 * (radius + margin) / h)) + 1
    first = numpy.array([draw.whole(-9, 9) for _ in range(3)])
    low = -h * (n - 1) / 2 + h * draw.between(-0.4, 0.4, 3)
    data = vtkImageData()
    data.SetExtent(*(int(v) for f in first for v in (f, f + n - 1)))
    data.SetSpacing(h, h, h)
    data.SetOrigin(*(center + axes @ (low - h * first)))
    data.SetDirectionMatrix(*axes.ravel())
    k, j, i = numpy.meshgrid(*3 * [numpy.arange(n)], indexing="ij")
    nodes = low + h * numpy.stack([i.ravel(), j.ravel(), k.ravel()], 1)
    distance = numpy.linalg.norm(nodes, axis=1) - radius
    add_array(data.GetPointData(), "SignedDistance", distance.astype(draw.choice([numpy.float32, numpy.float64])))
    data.GetPointData().SetActiveScalars("SignedDistance")
    return data, center


@oracle("Nonpolar Solvation")
def nonpolar_solvation(draw):
    """An atom in a sphere: area, volume, their energies, and dispersion, the integral of the attractive part of a
    Lennard-Jones pair (Dispersion.h) outside of the sphere.
    Tolerance: second order in the spacing over the radius, (h / R)^2; of energies the same."""
    radius = draw.between(1.8, 4.0)
    h = draw.between(0.35, 0.5)
    image, center = sphere_distance(draw, radius, h, 2.0, upright=True)
    own, depth = draw.between(1.2, 2.0), draw.between(0.01, 0.3)
    tension, pressure, density = draw.between(0.01, 0.1), draw.between(0.01, 0.1), draw.between(0.01, 0.05)
    data = atoms(draw, center[None], own, WellDepth=depth)
    filter_ = settle(isthmus.vtkNonpolarSolvation(), [data, image], SurfaceTension=tension, Pressure=pressure,
                     SolventDensity=density)
    table, share = filter_.GetOutputDataObject(1), (h / radius)**2
    area, volume = 4 * numpy.pi * radius**2, 4 / 3 * numpy.pi * radius**3
    pair, least = numpy.sqrt(depth * 0.1521), own + 1.7683
    start = max(radius, least)
    energy = pair * (least**12 / (9 * start**9) - 2 * least**6 / (3 * start**3))
    energy -= pair * max(least**3 - radius**3, 0) / 3
    energy *= 4 * numpy.pi * density
    for name, wanted in (("Area", area), ("Volume", volume), ("SurfaceEnergy", tension * area),
                         ("VolumeEnergy", pressure * volume), ("DispersionEnergy", energy)):
        yield name, column(table, name)[0] / wanted - 1, share
    per_atom = filter_.GetOutput().GetPointData()
    yield "sum of atoms", array(per_atom, "NonpolarEnergy").sum() - column(table, "NonpolarEnergy")[0], 1e-9


@oracle("Poisson Boltzmann")
def poisson_boltzmann(draw):
    """Born's ion, with or without salt: solvation energy, potential outside, induced charge.
    Tolerance: second order in the spacing over the radius, (h / R)^2, at a spacing of a fifth to a seventh of R."""
    radius = draw.between(2.0, 4.0)
    h = radius / draw.between(5.0, 7.0)
    image, center = sphere_distance(draw, radius, h, 3.0 * h)
    charge = draw.between(0.2, 3.0) * draw.choice([-1, 1])
    solute, solvent = draw.between(1.0, 4.0), draw.between(40.0, 80.0)
    salt, ion, kelvin = draw.choice([0.0, draw.between(0.05, 0.3)]), draw.between(0.0, 2.0), 298.15
    data = atoms(draw, center[None], 0.5 * radius, Charge=charge)
    filter_ = settle(isthmus.vtkPoissonBoltzmann(), [data, image], Level=0.0, InsideIsHigher=False,
                     SoluteDielectric=solute, SolventDielectric=solvent, IonicStrength=salt, IonRadius=ion,
                     Padding=2.0 * radius)
    output = filter_.GetOutput()
    kt = 8.314462618e-3 / 4.184 * kelvin
    length = COULOMB / kt  # Bjerrum's in vacuum
    kappa = numpy.sqrt(8 * numpy.pi * length / solvent * salt * 6.02214076e-4)
    closest = radius + ion
    energy = COULOMB * charge**2 / 2 * ((1 / solvent - 1 / solute) / radius
                                        - kappa / (solvent * (1 + kappa * closest)))
    share = (h / radius)**2
    yield "SolvationEnergy", field(output, "SolvationEnergy") / energy - 1, share
    if salt:
        yield "DebyeLength", field(output, "DebyeLength") * kappa - 1, 1e-4
    surface = filter_.GetOutputDataObject(1)
    at = length * charge / solvent * (1 / radius - kappa / (1 + kappa * closest))
    yield "Potential at the surface", array(surface.GetPointData(), "Potential") / (length * charge / radius) - \
        at / (length * charge / radius), share
    slope = length * charge / (solvent * radius**2)
    yield "NormalField", array(surface.GetPointData(), "NormalField") / slope - 1, 4 * share
    normals = points_of(surface) - center
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    along = (array(surface.GetPointData(), "Normals") * normals).sum(1)
    yield "Normals", along - 1, share


if __name__ == "__main__":
    main()
