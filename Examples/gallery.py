"""Recreates the pictures of Examples/README.md, one for each pipeline of the toolbar.

Usage: pvpython gallery.py [FOLDER]. FOLDER: where the pictures go (the repository's are in Examples/gallery);
default: a temporary folder, which is printed. Reads the data from $ISTHMUS_DATA_DIR, else from ../shared/data
beside the clone.
"""

import os
import subprocess
import sys
from pathlib import Path

from paraview import simple

sys.path.insert(0, str(Path(__file__).resolve().parent))
import electrostatics  # noqa: E402
from isthmus_plugin import pipelines  # noqa: E402, there once paraview.simple has loaded the plugin
from output_folder import output_folder  # noqa: E402

HERE = Path(__file__).resolve().parent
SCENES = (
    ("map_to_surface", "maps/emd_5043.map", (0.2, -0.4, 1.0)),
    ("map_to_curvature", "maps/emd_5170.map", (0.0, -1.0, 0.4)),
    ("map_to_loops", "maps/emd_1832.map", (0.0, 0.0, 1.0)),
    ("protein_to_surface", "molecules/1crn_apbs.pqr", (0.0, 0.0, 1.0)),
    ("protein_to_sites", "molecules/1hew/1hew.pqr", (0.3, 0.2, -1.0)),
    ("surface_to_loops", "surfaces/torus.obj", (0.3, 1.0, 0.6)),
    ("protein_to_pockets", "molecules/1hew.pdb", (0.0, 0.0, 1.0)),
    ("protein_to_pores", "molecules/channels/1grm_hole_example.pdb", (1.0, 0.0, 0.0)),
)
# What the window shows first: of an opened file, or of a button.
FIRST = (
    ("first_map", "maps/emd_5043.map", None),
    ("first_protein", "molecules/1hew.pdb", None),
    ("first_loops", "maps/emd_1832.map", "map_to_loops"),
    ("first_pockets", "molecules/1hew.pdb", "protein_to_pockets"),
    ("first_pores", "molecules/channels/1grm_hole_example.pdb", "protein_to_pores"),
    ("first_potential", "molecules/1hew/1hew.pqr", "protein_to_sites"),
)


def data_folder():
    for folder in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), HERE.parents[1] / "shared" / "data")):
        if Path(folder).is_dir():
            return Path(folder)
    sys.exit("There is no shared data: set ISTHMUS_DATA_DIR.")


def view_of(function, path, direction):
    """A view of the result of the pipeline function for the file, seen from direction."""
    source = simple.OpenDataFile(str(path))
    view = simple.CreateView("RenderView")
    view.ViewSize = [900, 640]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    proxies = getattr(pipelines, function)(source)
    display = pipelines.show(*proxies, view=view)
    if display.LookupTable is not None and display.ColorArrayName[1]:
        bar = simple.GetScalarBar(display.LookupTable, view)
        bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    focus = view.CameraFocalPoint
    view.CameraPosition = [f + 300 * d for f, d in zip(focus, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(1.2)
    return view


def scene(function, path, direction, picture):
    view = view_of(function, path, direction)
    simple.SaveScreenshot(str(picture), view, ImageResolution=[900, 640])
    # 128 colours keep a picture below 200 KB; without ImageMagick it is larger.
    subprocess.run(["convert", str(picture), "-colors", "128", str(picture)], check=False)
    simple.Delete(view)


def flow_surfaces(path, picture):
    """Fine, coarse and solvent-excluded surfaces of a molecule, side by side with the same camera."""
    atoms = simple.OpenDataFile(str(path))
    layout = simple.CreateLayout("Flow surfaces")
    layout.SplitHorizontal(0, 1.0 / 3.0)
    layout.SplitHorizontal(2, 0.5)
    camera = None
    for hint, properties in ((1, {"Preset": "Fine"}), (5, {"Preset": "Coarse"}),
                             (6, {"Method": "Solvent Excluded", "ProbeRadius": 1.4})):
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view, layout, hint)
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        view.OrientationAxesVisibility = 0
        display = simple.Show(simple.MolecularFlowSurface(Input=atoms, **properties), view)
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = [0.62, 0.72, 0.86]
        text = simple.Text(Text=properties.get("Preset", "Solvent-excluded, probe 1.4"))
        simple.Show(text, view).Color = [0.0, 0.0, 0.0]
        simple.ResetCamera(view)
        simple.GetActiveCamera().Zoom(1.3)
        camera = camera or view
        view.CameraPosition, view.CameraFocalPoint = camera.CameraPosition, camera.CameraFocalPoint
    simple.SaveScreenshot(str(picture), layout, ImageResolution=[1050, 380])
    subprocess.run(["convert", str(picture), "-colors", "128", str(picture)], check=False)


def first_sight(function, path, picture):
    """What the window shows on white and on black, side by side."""
    halves = []
    for palette in ("WhiteBackground", "BlackBackground"):
        simple.LoadPalette(palette)
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view, simple.CreateLayout())
        view.ViewSize = [560, 420]
        simple.SetActiveView(view)
        source = simple.OpenDataFile(str(path))
        simple.SetActiveSource(source)
        if function:
            pipelines.run(function)
        else:
            pipelines.first_values(source.GetGlobalID())
            display = simple.Show(source, view)
            simple.ResetCamera(view)
            pipelines.first_look(display.GetGlobalID())
        if function == "protein_to_sites":  # the potential is in the second view
            view = next(each for each in simple.GetViews() if each != view and each.SMProxy.GetXMLName() == "RenderView")
            view.ViewSize = [560, 420]
        halves.append(f"{picture}.{palette}.png")
        simple.SaveScreenshot(halves[-1], view, ImageResolution=[560, 420])
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
        for each in list(simple.GetViews()):
            simple.Delete(each)
    subprocess.run(["convert", *halves, "+append", "-colors", "128", str(picture)], check=True)
    for half in halves:
        os.remove(half)
    simple.LoadPalette("WhiteBackground")


def main(folder):
    data = data_folder()
    for name, path, function in FIRST:
        first_sight(function, data / path, folder / f"{name}.png")
        print(folder / f"{name}.png")
    for function, path, direction in SCENES:
        scene(function, data / path, direction, folder / f"{function}.png")
        print(folder / f"{function}.png")
    electrostatics.pictures(data / "molecules/1hew/1hew.pqr", 0.15, (0.3, 0.2, -1.0),
                            [folder / "isopotentials.png", folder / "field_lines.png"])
    flow_surfaces(data / "molecules/1hew.pdb", folder / "flow_surfaces.png")
    print(folder / "flow_surfaces.png")


if __name__ == "__main__":
    if {"-h", "--help"} & set(sys.argv[1:]):
        print(__doc__)
        sys.exit()
    main(output_folder(sys.argv[1] if len(sys.argv) > 1 else None))
