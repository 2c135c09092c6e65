"""The electrostatic potential of a molecule: pictures of its surface, isopotential surfaces, field lines.

Usage: pvpython electrostatics.py FILE.pqr [--salt MOL] [--direction X Y Z] [--output FOLDER]

FILE.pqr         the molecule, with charges and radii.
--salt MOL       ionic strength in mol/l. Default: 0.15.
--direction      where the camera stands, from the molecule's middle. Default: 0.3 0.2 -1.
--output FOLDER  where isopotentials.png and field_lines.png go; default: a temporary folder, which is printed.

The surface is coloured from -5 (red) to 5 (blue) kT/e. Isopotential surfaces at -1 and 1 kT/e; field lines begin
near the surface, run in both directions and are coloured by the potential.
"""

import argparse
import math
import subprocess
from pathlib import Path

from paraview import simple

import find_isthmus  # noqa: F401 (before isthmus)
from output_folder import output_folder

LEVEL = 1.0  # kT/e, of the isopotential surfaces
RANGE = 5.0  # kT/e, of the colours
LINES = 260
IMAGE, SURFACE = 0, 1  # the filter's ports


def new_view():
    view = simple.CreateView("RenderView")
    view.ViewSize = [900, 640]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    return view


def colour(display, view):
    simple.ColorBy(display, ("POINTS", "Potential"))
    table = simple.GetColorTransferFunction("Potential")
    table.RGBPoints = [-RANGE, 0.8, 0.1, 0.1, 0.0, 1.0, 1.0, 1.0, RANGE, 0.1, 0.2, 0.8]
    display.SetScalarBarVisibility(view, True)
    legend = simple.GetScalarBar(table, view)
    legend.Title, legend.ComponentTitle = "potential (kT/e)", ""
    legend.TitleColor = legend.LabelColor = [0.1, 0.1, 0.1]


def save(view, direction, zoom, path):
    focus = view.CameraFocalPoint
    view.CameraPosition = [f + 300.0 * d for f, d in zip(focus, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)
    path.parent.mkdir(parents=True, exist_ok=True)
    simple.SaveScreenshot(str(path), view, ImageResolution=[900, 640])
    # 128 colours keep a picture below 200 KB; without ImageMagick it is larger.
    subprocess.run(["convert", str(path), "-colors", "128", str(path)], check=False)
    simple.Delete(view)
    print(path)


def isopotentials(solver, direction, path):
    view = new_view()
    colour(simple.Show(simple.OutputPort(solver, SURFACE), view), view)
    for value, shade in ((-LEVEL, [0.85, 0.25, 0.25]), (LEVEL, [0.25, 0.35, 0.9])):
        level = simple.Contour(Input=simple.OutputPort(solver, IMAGE),
                               ContourBy=["POINTS", "Potential"], Isosurfaces=[value])
        shown = simple.Show(level, view)
        simple.ColorBy(shown, None)
        shown.DiffuseColor = shown.AmbientColor = shade
        shown.Opacity = 0.25
    save(view, direction, 1.35, path)


def field_lines(solver, direction, path):
    """Field lines of the negative gradient of the potential, computed outside the surface only."""
    view = new_view()
    colour(simple.Show(simple.OutputPort(solver, SURFACE), view), view)
    outside = simple.Threshold(Input=simple.OutputPort(solver, IMAGE), Scalars=["POINTS", "Side"],
                               LowerThreshold=0.0, UpperThreshold=0.0, ThresholdMethod="Between")
    field = simple.Gradient(Input=outside, ScalarArray=["POINTS", "Potential"],
                            ResultArrayName="Gradient")
    low, high = (simple.OutputPort(solver, SURFACE).GetDataInformation().GetBounds()[i::2] for i in (0, 1))
    middle = [(a + b) / 2.0 for a, b in zip(low, high)]
    lines = simple.StreamTracer(Input=field, Vectors=["POINTS", "Gradient"],
                                SeedType="Point Cloud", IntegrationDirection="BOTH",
                                MaximumStreamlineLength=2.0 * math.dist(low, high))
    lines.SeedType.Center = middle
    lines.SeedType.Radius = 0.5 * math.dist(low, high)
    lines.SeedType.NumberOfPoints = LINES
    colour(simple.Show(simple.Tube(Input=lines, Radius=0.12), view), view)
    save(view, direction, 1.2, path)


def pictures(path, salt, direction, names):
    """Makes both pictures of a molecule; names are their paths."""
    solver = simple.PoissonBoltzmann(Input=simple.OpenDataFile(str(path)), IonicStrength=salt)
    solver.UpdatePipeline()
    isopotentials(solver, direction, names[0])
    field_lines(solver, direction, names[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("molecule", type=Path)
    parser.add_argument("--salt", type=float, default=0.15)
    parser.add_argument("--direction", type=float, nargs=3, default=(0.3, 0.2, -1.0))
    parser.add_argument("--output", type=Path)
    chosen = parser.parse_args()
    folder = output_folder(chosen.output)
    names = [folder / name for name in ("isopotentials.png", "field_lines.png")]
    pictures(chosen.molecule, chosen.salt, chosen.direction, names)
    print(*names, sep="\n")


if __name__ == "__main__":
    main()
