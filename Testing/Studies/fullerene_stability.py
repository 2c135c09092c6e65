"""The fullerene experiment of the thesis (Figs. 6.12 to 6.15) for folders of molecules.

Usage: pvpython fullerene_stability.py OUTPUT FOLDER... [--energies ENERGIES.csv] [--grid] [--growth]

Each .xyz and .cjson file of the folders becomes a row of OUTPUT/stability.csv (vtkFullereneStability, exact alpha
complex), together with its number of pairs of adjacent pentagons. With --energies (a CSV whose first column is a
file's name without its ending, and whose further columns are numbers), each number is plotted and correlated
against the indicator, for each size with at least five isomers and for the whole series. --grid: the integrals on
grids of decreasing spacing, compared with the exact ones (Figs. 6.13, 6.14). --growth: the surface of the first
molecule at increasing distances, as pictures growth_*.png (Fig. 6.12).
"""

import csv
import json
import math
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
from matplotlib import pyplot
import numpy
from paraview import simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

COLUMNS = ("Atoms", "Bars", "Integral", "FilteredIntegral", "Cavity", "BoxLength",
           "IntegralPerAtom", "FilteredIntegralPerAtom", "FilteredIntegralPerBoxLength", "EnergyProxy")
SPACINGS = (0.4, 0.3, 0.2, 0.15, 0.1, 0.075)


def read_atoms(path):
    """Positions of the atoms, n x 3."""
    if path.suffix == ".cjson":
        return numpy.array(json.loads(path.read_text())["atoms"]["coords"]["3d"]).reshape(-1, 3)
    lines = path.read_text().splitlines()
    count = int(lines[0].split()[0])
    return numpy.array([[float(word) for word in line.split()[1:4]] for line in lines[2:2 + count]])


def source_of(atoms):
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for atom in atoms:
        points.InsertNextPoint(atom)
    molecule = vtkPolyData()
    molecule.SetPoints(points)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(molecule)
    return source


def stability_of(atoms, **settings):
    """The row of vtkFullereneStability, as a dictionary."""
    source = source_of(atoms)
    proxy = simple.FullereneStability(Input=source, **settings)
    proxy.UpdatePipeline()
    table = proxy.GetClientSideObject().GetOutputDataObject(0)
    row = {name: table.GetColumnByName(name).GetValue(0) for name in COLUMNS}
    simple.Delete(proxy)
    simple.Delete(source)
    return row


def pentagon_adjacencies(atoms):
    """The number of pairs of pentagons with a common bond, which the isolated pentagon rule (IPR) is based on."""
    distance = numpy.linalg.norm(atoms[:, None] - atoms[None], axis=2)
    numpy.fill_diagonal(distance, math.inf)
    nearest = numpy.argsort(distance, axis=1)[:, :3]
    bonds = [set(row) for row in nearest.tolist()]
    pentagons = set()
    for a in range(len(atoms)):
        for b in bonds[a]:
            for c in bonds[b] - {a}:
                for d in bonds[c] - {a, b}:
                    for e in (bonds[d] & bonds[a]) - {b, c}:
                        pentagons.add(frozenset((a, b, c, d, e)))
    pentagons = list(pentagons)
    return sum(len(p & q) == 2 for i, p in enumerate(pentagons) for q in pentagons[:i])


def read_energies(path):
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    name = next(iter(rows[0]))
    columns = [key for key in rows[0] if key not in (name, "atoms")]
    return {row[name]: {key: float(row[key]) for key in columns} for row in rows}, columns


def correlate(rows, column, output):
    """Prints correlations by size and draws a plot for each size."""
    sizes = sorted({row["Atoms"] for row in rows})
    isomers = {size: [row for row in rows if row["Atoms"] == size] for size in sizes}
    report = []
    for size, group in isomers.items():
        if len(group) < 5:
            continue
        energy = numpy.array([row[column] for row in group])
        energy = 627.5095 * (energy - energy.min())  # kcal/mol, where the column is in hartree
        figure, axes = pyplot.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
        for axis, name in zip(axes, ("FilteredIntegral", "Cavity", "PentagonAdjacencies")):
            x = numpy.array([row[name] for row in group])
            r = numpy.corrcoef(x, energy)[0, 1] if x.std() > 0 and energy.std() > 0 else math.nan
            report.append(f"C{size} ({len(group)} isomers), {name} against {column}: r = {r:+.3f}")
            axis.plot(x, energy, "o", color="#2161b3")
            axis.set(xlabel=name, ylabel=f"{column}, relative (kcal/mol)", title=f"C{size}: r = {r:+.3f}")
        figure.savefig(output / f"C{size}_{column}.png", dpi=110)
        pyplot.close(figure)
    per_atom = numpy.array([row[column] / row["Atoms"] for row in rows])
    proxy = numpy.array([row["EnergyProxy"] for row in rows])
    inverse = 1.0 / numpy.array([row["Atoms"] for row in rows])
    if len(sizes) > 3:
        def rest(x):
            return x - numpy.polyval(numpy.polyfit(inverse, x, 1), inverse)
        report.append(f"All {len(rows)} molecules, EnergyProxy against {column} per atom: "
                      f"r = {numpy.corrcoef(proxy, per_atom)[0, 1]:+.3f}; 1/Atoms against it: "
                      f"r = {numpy.corrcoef(inverse, per_atom)[0, 1]:+.3f}; EnergyProxy with 1/Atoms "
                      f"taken out: r = {numpy.corrcoef(rest(proxy), rest(per_atom))[0, 1]:+.3f}")
        figure, axis = pyplot.subplots(figsize=(6, 4.5), constrained_layout=True)
        axis.plot(1.0 / inverse, proxy, "o", color="#2161b3", label="EnergyProxy (Å)")
        other = axis.twinx()
        other.plot(1.0 / inverse, per_atom, "x", color="#d3171a", label=f"{column} per atom")
        axis.set(xlabel="atoms", ylabel="EnergyProxy (Å), dots")
        other.set_ylabel(f"{column} per atom, crosses")
        figure.savefig(output / f"series_{column}.png", dpi=110)
        pyplot.close(figure)
    return report


def grid_study(names_and_atoms, output):
    """Integrals with and without filter on successively finer grids, with the exact value."""
    figure, axes = pyplot.subplots(1, 2, figsize=(11, 4.5), constrained_layout=True)
    for name, atoms in names_and_atoms:
        exact = stability_of(atoms)
        grids = [stability_of(atoms, Method="Grid", Spacing=h) for h in SPACINGS]
        for axis, column in zip(axes, ("Integral", "FilteredIntegral")):
            line, = axis.plot(SPACINGS, [row[column] / exact[column] for row in grids], "o-", label=name)
        for h, row in zip(SPACINGS, grids):
            print(f"{name}, spacing {h}: Integral {row['Integral']:.3f}, filtered "
                  f"{row['FilteredIntegral']:.3f}, {row['Bars']} bars; exact {exact['Integral']:.4f}, "
                  f"{exact['FilteredIntegral']:.4f}, {exact['Bars']}")
    for axis, title in zip(axes, ("all bars", "bars of at least 0.2 Å")):
        axis.axhline(1.0, color="grey", linewidth=0.8)
        axis.set(xlabel="spacing (Å)", ylabel="integral of beta_1 over the exact one", title=title,
                 ylim=(0.75, 1.25))
        axis.invert_xaxis()
        axis.legend()
    figure.savefig(output / "grid.png", dpi=110)
    pyplot.close(figure)


def growth(atoms, output):
    """The surface of the union of balls at growing radii."""
    from paraview.simple import Contour, CreateView, MolecularDensity, SaveScreenshot, Show
    source = source_of(atoms)
    # Balls of one radius: the union of balls of radius r is where the distance is at most r.
    radii = simple.Calculator(Input=source, ResultArrayName="Radius", Function="1")
    balls = MolecularDensity(Input=radii, Form="Gaussian Sum", Decay=40.0, Spacing=0.12)
    view = CreateView("RenderView")
    view.ViewSize = [500, 500]
    surface = Contour(Input=balls, ContourBy=["POINTS", "Density"], Isosurfaces=[1.0])
    shown = Show(surface, view)
    shown.DiffuseColor = [0.13, 0.38, 0.70]
    for frame, radius in enumerate(numpy.linspace(0.5, 1.5, 11)):
        balls.RadiusScale = radius
        if frame == 0:
            simple.ResetCamera(view)
            view.GetActiveCamera().Dolly(0.8)
        SaveScreenshot(str(output / f"growth_{frame:02d}.png"), view)


def main(arguments):
    if {"-h", "--help"} & set(arguments):
        print(__doc__)
        return
    options = [word for word in arguments if word in ("--grid", "--growth")]
    arguments = [word for word in arguments if word not in options]
    energies = None
    if "--energies" in arguments:
        at = arguments.index("--energies")
        energies = arguments[at + 1]
        del arguments[at:at + 2]
    if len(arguments) < 2:
        sys.exit(__doc__)
    output = Path(arguments[0])
    output.mkdir(parents=True, exist_ok=True)
    paths = sorted(path for folder in arguments[1:] for path in Path(folder).iterdir()
                   if path.suffix in (".xyz", ".cjson"))
    if not paths:
        sys.exit("No .xyz or .cjson file in " + ", ".join(arguments[1:]))
    rows = []
    for path in paths:
        atoms = read_atoms(path)
        rows.append({"Molecule": path.stem, **stability_of(atoms),
                     "PentagonAdjacencies": pentagon_adjacencies(atoms)})
    columns = []
    if energies:
        known, columns = read_energies(energies)
        for row in rows:
            row.update(known.get(row["Molecule"], {}))
    with open(output / "stability.csv", "w", newline="") as file:
        writer = csv.DictWriter(file, ["Molecule", *COLUMNS, "PentagonAdjacencies", *columns], restval="")
        writer.writeheader()
        writer.writerows(rows)
    print(f"{len(rows)} molecules in {output / 'stability.csv'}")
    report = []
    for column in columns:
        report += correlate([row for row in rows if column in row], column, output)
    if report:
        print("\n".join(report))
        (output / "correlations.txt").write_text("\n".join(report) + "\n")
    if "--grid" in options:
        chosen = [path for path in paths if path.stem in ("C20-Ih", "C60_Ih-ANGS")] or paths[:2]
        grid_study([(path.stem, read_atoms(path)) for path in chosen], output)
    if "--growth" in options:
        chosen = [path for path in paths if path.stem.startswith("C60")] or paths
        growth(read_atoms(chosen[0]), output)


if __name__ == "__main__":
    main(sys.argv[1:])
