"""Measures how much the potential of a protein depends on the grid and on the protein's orientation in it.

Usage: pvpython evaluate_electrostatics.py FILE.pqr [--surfaces NAMES] [--rotations NUMBER] [--apbs]

For each of the surfaces gaussian, flow and ses (default: all three): solvation energies at 0.5 and
0.25 angstrom; at the outside nodes common to both grids, the quantiles of the difference of the potentials in kT/e,
and the share within 0.5; the spread of the energy over random rotations of the molecule at 0.5 angstrom. --apbs:
the same rotations with APBS (srfm mol, two solutions each), which uses its own surface. Prints Markdown.
"""

import argparse
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import apbs_solvation
import study_paths  # noqa: F401 (before isthmus)
import isthmus
from solvation_energies import molecule_of, read

DECAY = 2.0  # of the Gaussians
SURFACES = ("gaussian", "flow", "ses")
QUANTILES = (0.99, 0.999, 0.9999, 1.0)


def solve(atoms, surface, spacing):
    """The filter after solving, with the surface made on a grid of the same spacing."""
    solver = isthmus.vtkPoissonBoltzmann()
    solver.SetInputData(0, atoms)
    if surface == "gaussian":
        source = isthmus.vtkMolecularDensity()
        source.SetDecay(DECAY)
        source.SetPadding(3.0, 3.0, 3.0)
        port = 0
        solver.SetLevel(1.0)
    else:
        source = isthmus.vtkMolecularFlowSurface()
        if surface == "ses":
            source.SetMethod(isthmus.vtkMolecularFlowSurface.SolventExcluded)
            source.SetProbeRadius(1.4)
        port = 1
        solver.SetLevel(0.0)
        solver.SetInsideIsHigher(False)
    source.SetInputData(atoms)
    source.SetSpacing(spacing)
    source.Update()
    image = source.GetOutputDataObject(port)
    image.GetPointData().SetActiveScalars("Density" if surface == "gaussian" else "SignedDistance")
    solver.SetInputData(1, image)
    solver.Update()
    return solver


def energy(solver):
    return solver.GetOutput().GetFieldData().GetArray("SolvationEnergy").GetValue(0)


def grid(solver):
    """Origin, potential and side as arrays [k, j, i]."""
    image = solver.GetOutput()
    shape = image.GetDimensions()[::-1]
    extent = image.GetExtent()
    origin = [image.GetOrigin()[a] + extent[2 * a] * image.GetSpacing()[a] for a in range(3)]
    data = image.GetPointData()
    return (numpy.array(origin), vtk_to_numpy(data.GetArray("Potential")).reshape(shape),
            vtk_to_numpy(data.GetArray("Side")).reshape(shape))


def differences(coarse, fine):
    """|potentials' difference| at nodes outside in both, the fine grid having half the spacing; and
    their places."""
    start, potential, side = grid(coarse)
    other_start, other, other_side = grid(fine)
    h = coarse.GetOutput().GetSpacing()[0]
    shift = (start - other_start) / (0.5 * h)
    step = numpy.rint(shift).astype(int)
    if numpy.abs(shift - step).max() > 1e-3:
        raise RuntimeError("the two grids have no nodes in common")
    picked = []
    for a in range(3):
        i = 2 * numpy.arange(potential.shape[2 - a]) + step[a]
        picked.append(numpy.flatnonzero((i >= 0) & (i < other.shape[2 - a])))
    here = numpy.ix_(picked[2], picked[1], picked[0])
    there = numpy.ix_(*(2 * picked[a] + step[a] for a in (2, 1, 0)))
    both = (side[here] == 0) & (other_side[there] == 0)
    where = numpy.argwhere(both)
    nodes = numpy.stack([picked[2 - a][where[:, a]] for a in (2, 1, 0)], axis=1)
    return numpy.abs(potential[here] - other[there])[both], start + h * nodes


def random_rotation(generator):
    q = generator.normal(size=4)
    w, x, y, z = q / numpy.linalg.norm(q)
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def apbs_energy(positions, charges, radii, h=0.5, solute=2.0, solvent=80.0, kelvin=298.15, salt=0.0):
    """kcal/mol on APBS' own surface."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    sides = (high - low + 2.0 * 12.0) / h
    counts = [int(numpy.ceil(side / 32.0)) * 32 + 1 for side in sides]
    pqr = "".join("ATOM %d X MOL 1 %.4f %.4f %.4f %.4f %.4f\n" % (i + 1, *x, q, r)
                  for i, (x, q, r) in enumerate(zip(positions, charges, radii)))
    center = "{} {} {}".format(*(low + high) / 2.0)
    return apbs_solvation.energy(
        pqr, apbs_solvation.input_text(counts, h, center, solute, solvent, kelvin, salt))


def drift(energies):
    """The largest deviation from the mean, relative to the mean."""
    energies = numpy.array(energies)
    return numpy.abs(energies / energies.mean() - 1.0).max()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=Path)
    parser.add_argument("--surfaces", nargs="*", choices=SURFACES, default=SURFACES)
    parser.add_argument("--rotations", type=int, default=10)
    parser.add_argument("--apbs", action="store_true")
    options = parser.parse_args()
    positions, charges, radii = read(options.file)
    generator = numpy.random.default_rng(2026)
    turned = [(positions - positions.mean(axis=0)) @ random_rotation(generator).T
              for _ in range(options.rotations)]
    print("| surface | energy at 0.5, kcal/mol | at 0.25 | difference | outside nodes: "
          + ", ".join(f"{100 * q:g} %" for q in QUANTILES) + " within, kT/e | within 0.5 | drift by rotation |")
    print("|---|---|---|---|---|---|---|")
    for surface in options.surfaces:
        atoms = molecule_of(positions, charges, radii)
        coarse, fine = solve(atoms, surface, 0.5), solve(atoms, surface, 0.25)
        apart, _ = differences(coarse, fine)
        energies = [energy(solve(molecule_of(x, charges, radii), surface, 0.5)) for x in turned]
        print(f"| {surface} | {energy(coarse):.2f} | {energy(fine):.2f} "
              f"| {100 * abs(energy(coarse) / energy(fine) - 1.0):.3f} % | "
              + ", ".join(f"{numpy.quantile(apart, q):.2f}" for q in QUANTILES)
              + f" | {100 * (apart <= 0.5).mean():.3f} %"
              + (f" | {100 * drift(energies):.3f} % |" if turned else " | |"), flush=True)
    if options.apbs:
        energies = [apbs_energy(x, charges, radii) for x in turned]
        print(f"| APBS' own | {numpy.mean(energies):.2f} | | | | | {100 * drift(energies):.3f} % |")


if __name__ == "__main__":
    main()
