"""Likely binding sites of a protein: its pockets, ranked with polarized curvature. The picture resembles Fig. 5.9
of the thesis: the electrostatic potential on the surface above, the polarized curvature below, the ligand (if there
is one) as sticks.

Usage: pvpython binding_sites.py PROTEIN [POTENTIAL] [--ligand NAME] [--surface FILE]
                                 [--decay NUMBER] [--output FOLDER]

PROTEIN    PDB file (.pdb, .ent, plain or .gz). Its ligand, the residue NAME or else the largest HETATM residue that
is not part of a chain, is removed before the computation. POTENTIAL  OpenDX file in kT/e (.dx, .dx.gz). Without it,
pdb2pqr assigns charges, and the filter Poisson Boltzmann computes the potential at the surface, with 0.15 mol/l of
salt. FILE surface to use instead of the protein's Gaussian surface: MSMS .vert (with its .face), or
           anything else that ParaView reads as triangles.
NUMBER     decay of the Gaussians of the surface: smaller is coarser. Default: 1.2.
FOLDER for the picture, the table and the charges (.pqr). Default: a
           temporary folder, which is printed.
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy
from paraview import simple

sys.path.insert(0, str(Path(__file__).resolve().parent))
import find_isthmus  # noqa: E402,F401 (before isthmus)
import apbs_potential  # noqa: E402
import site_pipeline  # noqa: E402
from output_folder import output_folder  # noqa: E402

import isthmus  # noqa: E402
from isthmus import look  # noqa: E402


def arguments(description=__doc__):
    parser = argparse.ArgumentParser(description=description,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("protein", type=Path)
    parser.add_argument("potential", type=Path, nargs="?")
    parser.add_argument("--ligand")
    parser.add_argument("--surface", type=Path)
    parser.add_argument("--decay", type=float, default=site_pipeline.DECAY)
    parser.add_argument("--output", type=Path)
    options = parser.parse_args()
    options.output = output_folder(options.output)
    return options


def charged_atoms(protein, folder, name):
    """PQR file of the protein by pdb2pqr, None without it."""
    if not apbs_potential.programs()[0]:
        return None
    pqr, removed, dropped = apbs_potential.charges(protein, folder, name)
    print("Charges and radii by pdb2pqr (AMBER), without the ligand.")
    if removed:
        print("  Removed, since pdb2pqr can't build them: " + ", ".join(removed))
    if dropped:
        print("  Not in its force field, left out: " + ", ".join(dropped))
    return pqr


def heavy_atoms(protein, folder, name):
    """PDB file of the heavy atoms of the protein."""
    path = Path(folder) / f"{name}_heavy.pdb"
    path.write_text("".join(line for line in protein if apbs_potential.is_heavy(line)) + "END\n")
    return path


def given_surface(path):
    source = simple.OpenDataFile(str(path))
    return simple.servermanager.Fetch(simple.Triangulate(Input=simple.ExtractSurface(Input=source)))


def make_surface(options, molecule, scale):
    if not options.surface:
        atoms = site_pipeline.read_atoms(molecule)
        image = site_pipeline.density(atoms, options.decay, scale=scale)
        return site_pipeline.outer_surface(image)
    curvature = isthmus.vtkSurfaceCurvature()
    curvature.SetInputData(given_surface(options.surface))
    curvature.SetMethod(isthmus.vtkSurfaceCurvature.NormalFit)
    curvature.SetRadius(1.5)
    curvature.Update()
    return curvature.GetOutput()


def table_text(rows, ligand):
    """The ten best sites as text."""
    head = f"{'rank':>4} {'class':>5} {'score':>8} {'area':>7} {'depth':>6} {'potential':>9}"
    head += "   center" + " " * 20 + ("to ligand" if ligand is not None else "")
    lines = [head]
    for row in rows[:10]:
        place = site_pipeline.center(row)
        line = (
            f"{row['Rank']:4.0f} {row['SiteClass']:5.0f} {row['Score']:8.1f} {row['Area']:7.1f} "
            f"{row['MeanDepth']:6.2f} {row['MeanPotential']:9.2f}   "
            f"({place[0]:7.2f} {place[1]:7.2f} {place[2]:7.2f})"
        )
        if ligand is not None:
            line += f" {site_pipeline.distance_to(ligand, place):10.2f}"
        lines.append(line)
    for row in rows[:3]:
        lines.append(f"residues of site {row['Rank']:.0f} (atoms within 4 A): {row.get('Residues', '')}")
    lines.append(
        "score: room x burial x root of |potential x kappa_2|; area of the surface there: A^2; "
        "depth of the center: A below the convex hull;"
        "\npotential: kT/e; class 2 (4): site for a negatively (positively) charged small ligand"
    )
    if ligand is not None:
        lines.append("to ligand: distance of the center from the ligand's nearest heavy atom, A")
    return "\n".join(lines)


def write_csv(rows, path):
    names = ["Rank", "Score", "SiteClass", "Class", "Residues", "Volume", "Area", "MeanDepth",
             "MeanPotential", "CenterX", "CenterY", "CenterZ", "Points"]
    with open(path, "w", newline="") as file:
        table = csv.DictWriter(file, [name for name in names if name in rows[0]], extrasaction="ignore")
        table.writeheader()
        table.writerows(rows)


def producer(data):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


def show_surface(surface, view, array, title, limit):
    display = simple.Show(surface, view)
    simple.ColorBy(display, ("POINTS", array))
    colours = simple.GetColorTransferFunction(array)
    colours.ApplyPreset("Cool to Warm", True)
    # Positive blue, negative red, as chemists draw potentials.
    colours.InvertTransferFunction()
    colours.RescaleTransferFunction(-limit, limit)
    colours.NanColor = [1.0, 0.9, 0.3]
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize = bar.LabelFontSize = 16
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Lower Center"
    bar.ScalarBarLength, bar.ScalarBarThickness = 0.4, 12
    bar.RangeLabelFormat = bar.LabelFormat = look.number_format(bar, ".1f")
    display.SetScalarBarVisibility(view, True)


def show_ligand(path, views):
    atoms = simple.OpenDataFile(str(path))
    sticks = simple.Tube(Input=atoms, Radius=0.25, NumberofSides=12)
    balls = simple.Glyph(Input=atoms, GlyphType="Sphere", ScaleFactor=0.7, GlyphMode="All Points")
    for view in views:
        for part in (sticks, balls):
            display = simple.Show(part, view)
            display.ColorArrayName = ["POINTS", ""]
            display.AmbientColor = display.DiffuseColor = [0.1, 0.65, 0.15]
            display.Specular = 0.3


def show_best(source, view):
    """Rims of the three best sites, in black."""
    best = simple.Calculator(Input=source, ResultArrayName="Best")
    best.Function = "if(BindingSite > 0, if(BindingSite < 4, 1, 0), 0)"
    rims = simple.Contour(Input=best, ContourBy=["POINTS", "Best"], Isosurfaces=[0.5])
    display = simple.Show(simple.Tube(Input=rims, Radius=0.2), view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.0, 0.0, 0.0]


def picture(surface, target, ligand_file, path):
    """The potential above and the polarized curvature below, both seen from the side of target."""
    source = producer(surface)
    layout = simple.CreateLayout()
    layout.SetSize(900, 1400)
    layout.SplitVertical(0, 0.5)
    views = []
    for cell in (1, 2):
        view = simple.CreateView("RenderView")
        layout.AssignView(cell, view)
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        view.OrientationAxesVisibility = 0
        views.append(view)
    show_surface(source, views[0], "Potential", "potential (kT/e)", 5.0)
    title = "potential x kappa_2 (kT/(e A)); rims: the best sites"
    show_surface(source, views[1], "PolarizedCurvature", title, 3.0)
    if ligand_file:
        show_ligand(ligand_file, views[:1])
    show_best(source, views[1])
    points = site_pipeline.points_of(surface)
    middle, extent = points.mean(axis=0), numpy.ptp(points, axis=0).max()
    outwards = target - middle
    outwards /= numpy.linalg.norm(outwards)
    up = numpy.cross(outwards, [1.0, 0.0, 0.0] if abs(outwards[0]) < 0.9 else [0.0, 1.0, 0.0])
    for view in views:
        view.CameraFocalPoint = list(middle)
        view.CameraPosition = list(middle + 3.0 * extent * outwards)
        view.CameraViewUp = list(up)
        view.CameraParallelProjection = 1
        view.CameraParallelScale = 0.66 * extent
    simple.SaveScreenshot(
        str(path), layout, ImageResolution=[900, 1400], FontScaling="Do not scale fonts"
    )


def prepare(options, folder):
    """The surface with polarized curvature, the PDB lines of the ligand, and the protein's name."""
    apbs_potential.require_atoms(options.protein)
    name = options.protein.name.split(".")[0]
    protein, ligand, ligand_name = apbs_potential.split(options.protein, options.ligand)
    if options.ligand and not ligand:
        sys.exit(f"{options.protein} has no residue {options.ligand}.")
    print(f"Ligand: {ligand_name}, {len(ligand)} heavy atoms." if ligand else "No ligand found.")
    molecule = pqr = charged_atoms(protein, folder, name)
    if options.potential is None and not pqr:
        sys.exit("No potential is given, and pdb2pqr, which assigns charges, is not installed: pass an OpenDX file, "
                 "or install pdb2pqr (Debian: pdb2pqr).")
    scale = 1.0
    if not pqr:
        scale = site_pipeline.WITHOUT_HYDROGENS
        print(f"pdb2pqr is not installed: heavy atoms, Bondi's radii x {scale}, make the surface.")
        molecule = heavy_atoms(protein, folder, name)
    bare = make_surface(options, molecule, scale)
    if options.potential:
        surface = site_pipeline.polarized(bare, site_pipeline.read_potential(options.potential))
    else:
        surface = site_pipeline.polarized(
            site_pipeline.with_potential(bare, site_pipeline.read_atoms(pqr)))
    return surface, ligand, name, site_pipeline.read_atoms(heavy_atoms(protein, folder, name))


def main():
    options = arguments()
    folder = options.output
    surface, ligand, name, atoms = prepare(options, folder)
    surface, rows = site_pipeline.sites(surface, atoms)
    if not rows:
        sys.exit("No site was found.")
    positions = [apbs_potential.position_of(line) for line in ligand] or None
    text = table_text(rows, positions)
    print(text)
    (options.output / f"{name}_sites.txt").write_text(text + "\n")
    write_csv(rows, options.output / f"{name}_sites.csv")
    ligand_file = None
    if ligand:
        ligand_file = folder / f"{name}_ligand.pdb"
        ligand_file.write_text("".join(ligand) + "END\n")
    target = numpy.mean(positions, axis=0) if ligand else site_pipeline.center(rows[0])
    picture(surface, target, ligand_file, options.output / f"{name}_sites.png")
    print(f"Picture and table: {options.output}")


if __name__ == "__main__":
    main()
