"""Makes those pictures of the guide's filter pages that are not in the gallery: one scene for each filter.

Usage: pvpython pictures.py [FOLDER [NAME...]]. FOLDER: output folder; default: filters/ beside this file.
NAME: only these (SurfaceCurvature, ...). Reads the data from $ISTHMUS_DATA_DIR, else from ../shared/data beside the
clone.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from isthmus_plugin import look, pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import molecule_views as molecules

HERE = Path(__file__).resolve().parent
SIZE = [720, 480]
INK, BLUE, VERMILION = [0.10, 0.10, 0.12], [0.62, 0.72, 0.86], [0.84, 0.37, 0.0]


def data(relative):
    for folder in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), HERE.parents[1] / "shared" / "data")):
        if (Path(folder) / relative).exists():
            return simple.OpenDataFile(str(Path(folder) / relative))
    sys.exit(f"There is no {relative}: set ISTHMUS_DATA_DIR.")


def plain(source, view, colour=BLUE, opacity=1.0):
    display = simple.Show(source, view)
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.EdgeColor = INK
    display.Opacity = opacity
    return display


def coloured(source, view, association, array, title, symmetric=None, preset=None):
    """Colours by an array; with symmetric, the range is from -symmetric to symmetric."""
    display = simple.Show(source, view)
    simple.ColorBy(display, (association, array))
    table = simple.GetColorTransferFunction(array)
    table.ApplyPreset(preset or ("Cool to Warm" if symmetric else look.SEQUENTIAL), True)
    if symmetric:
        table.RescaleTransferFunction(-symmetric, symmetric)
    else:
        display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = INK
    return display


def text(words, view):
    shown = simple.Show(simple.Text(Text=words), view)
    shown.Color = INK
    shown.FontSize = 16
    return shown


def slice_of(source):
    source.UpdatePipeline()
    bounds = source.GetDataInformation().GetBounds()
    cut = simple.Slice(Input=source, SliceType="Plane")
    cut.SliceType.Origin = [(bounds[i] + bounds[i + 1]) / 2.0 for i in (0, 2, 4)]
    return cut


def surface_curvature(view):
    surface = data("surfaces/Kitten.off")
    curvature = simple.SurfaceCurvature(Input=surface, Method="Normal fit", Radius=0.05)
    display = pipelines.show(curvature, view=view)
    bar = simple.GetScalarBar(display.LookupTable, view)
    bar.TitleColor = bar.LabelColor = INK
    return 1.0, -0.2, 0.3


def scalar_regions(view):
    volume = data("maps/emd_5170.map")
    surface = simple.MapSurface(Input=volume)
    curvature = simple.CurvatureOnSurface(Input=surface, Volume=volume, Scale=4)
    regions = simple.ScalarRegions(Input=curvature, Scalars=["POINTS", "MeanCurvature"], Thresholds=[-0.03, 0.06])
    display = simple.Show(regions, view)
    simple.ColorBy(display, ("POINTS", "ToonColor"))
    display.MapScalars = 0
    return 0.0, -1.0, 0.4


def high_order_diffusion(view):
    """Three slices side by side: a map with noise of its own strength, and two diffusions of it."""
    image = servermanager.Fetch(data("maps/emd_5043.map"))
    values = vtk_to_numpy(image.GetPointData().GetArray("Density"))
    noise = numpy.random.default_rng(1).normal(0.0, 1.5 * values.std(), values.size)
    noisy = numpy_to_vtk((values + noise).astype(numpy.float32), deep=True)
    noisy.SetName("Density")
    image.GetPointData().SetScalars(noisy)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    edges = simple.HighOrderDiffusion(Input=source, Order=0, PreSmoothing=1.5, Time=3)
    linear = simple.HighOrderDiffusion(Input=source, Order=2, EdgeStopping="None", Time=6)
    width = image.GetDimensions()[2] * image.GetSpacing()[2]
    for column, volume in enumerate((source, edges, linear)):
        moved = simple.Transform(Input=slice_of(volume), Transform="Transform")
        moved.Transform.Translate = [0, 0, -1.05 * width * column]
        display = coloured(moved, view, "POINTS", "Density", "density", preset="Grayscale")
        display.SetScalarBarVisibility(view, False)
    low, high = values.mean() - 2 * values.std(), values.mean() + 4 * values.std()
    simple.GetColorTransferFunction("Density").RescaleTransferFunction(low, high)
    return 1.0, 0.0, 0.0


def diffusion_high_pass(view):
    detail = simple.DiffusionHighPass(Input=data("maps/emd_5043.map"))
    cut = slice_of(detail)
    coloured(cut, view, "POINTS", "HighPass", "high-pass", symmetric=1.0)
    return 1.0, 0.0, 0.0


def pde_transform(view):
    modes = simple.PDETransform(Input=data("maps/emd_5043.map"))
    coloured(slice_of(modes), view, "POINTS", "Mode2", "mode 2", symmetric=0.5)
    return 1.0, 0.0, 0.0


def dual_contouring(view):
    surface = data("surfaces/fandisk.off")
    surface.UpdatePipeline()
    low, high = surface.GetDataInformation().GetBounds()[:2]
    contour = simple.DualContouring(Input=surface, Spacing=(high - low) / 40)
    plain(contour, view).Representation = "Surface With Edges"
    return -0.7, 0.5, 1.0


def surface_measures(view):
    measures = simple.SurfaceMeasures(Input=data("surfaces/fertility.off"))
    measures.UpdatePipeline()
    plain(measures, view)
    values = [measures.FieldData[name].GetRange()[0] for name in ("Area", "Volume", "Genus", "Components")]
    text("area %.4g   volume %.4g   genus %d   components %d" % tuple(values), view)
    return 0.2, 0.3, 1.0


def surface_to_grid(view):
    surface = data("surfaces/Kitten.off")
    surface.UpdatePipeline()
    low, high = surface.GetDataInformation().GetBounds()[:2]
    grid = simple.SurfaceToGrid(Input=surface, Spacing=(high - low) / 24, ExactEverywhere=1)
    coloured(slice_of(grid), view, "POINTS", "SignedDistance", "signed distance",
             symmetric=(high - low) / 3)
    points = plain(simple.OutputPort(grid, 1), view, INK)
    points.SetRepresentationType("Points")
    points.PointSize = 3
    return 1.0, 0.3, 0.4


def cell_incidence(view):
    volume = simple.MolecularDensity(Input=data("molecules/1crn_apbs.pqr"), Spacing=1.5)
    mesh = simple.IsosurfaceStuffing(Input=volume, Level=1.0)
    half = simple.TetCutaway(Input=mesh, StopRule="Plane")
    incidence = simple.CellIncidence(Input=simple.OutputPort(half, 1))
    display = coloured(incidence, view, "CELLS", "OnBoundary", "on boundary")
    display.LineWidth = 1.5
    return 0.5, 0.3, 1.0


def handle_filling(view):
    filled = simple.HandleFilling(Input=data("surfaces/3holes.off"), FillHandlesBelow=0.2)
    filled.UpdatePipeline()
    display = coloured(filled, view, "CELLS", "Filling", "filling")
    simple.GetColorTransferFunction("Filling").RGBPoints = [0.0, *BLUE, 0.5, *BLUE, 0.51, *VERMILION, 9.0, *VERMILION]
    display.SetScalarBarVisibility(view, False)
    return 0.2, 0.3, 1.0


def offset_surface(view):
    surface = data("surfaces/3holes.off")
    plain(surface, view, BLUE, 0.35)
    surface.UpdatePipeline()
    low, high = surface.GetDataInformation().GetBounds()[:2]
    plain(simple.OffsetSurface(Input=surface, Distance=0.04 * (high - low), Side="Inside"), view, VERMILION)
    return 0.2, 0.3, 1.0


def nonpolar_solvation(view):
    atoms = data("molecules/1crn_apbs.pqr")
    flow = simple.MolecularFlowSurface(Input=atoms, Spacing=0.7)
    energy = simple.NonpolarSolvation(Input=atoms, Volume=simple.OutputPort(flow, 1))
    coloured(spheres(energy), view, "POINTS", "NonpolarEnergy", "nonpolar energy, kcal/mol", symmetric=1.0)
    return 0.0, 0.0, 1.0


def feature_tracks(view):
    """Pockets of lysozyme while its two halves move against each other, in an artificial trajectory."""
    folder = os.environ.get("ISTHMUS_DATA_DIR") or str(HERE.parents[1] / "shared" / "data")
    lines = [line for line in (Path(folder) / "molecules/1hew.pdb").read_text().split("\n")
             if line.startswith("ATOM") and line[16] in " A"]
    places = numpy.array([[float(line[i:i + 8]) for i in (30, 38, 46)] for line in lines])
    side = numpy.tanh((places - places.mean(axis=0)) @ numpy.array([0.3, 0.9, 0.3]) / 8.0)
    models = []
    for frame in range(8):
        moved = places + numpy.outer(side, [1.2, 0.4, -0.4]) * numpy.sin(frame * numpy.pi / 4.0)
        models.append(f"MODEL     {frame + 1:4d}")
        models += [line[:30] + "".join(f"{x:8.3f}" for x in place) + line[54:]
                   for line, place in zip(lines, moved)]
        models.append("ENDMDL")
    with tempfile.NamedTemporaryFile("w", suffix=".pdb", delete=False) as file:
        file.write("\n".join([*models, "END", ""]))
    atoms = simple.OpenDataFile(file.name)
    pockets = simple.MolecularPockets(Input=atoms)
    tracks = simple.FeatureTracks(Input=simple.OutputPort(pockets, 1), MaximumDistance=5)
    tubes = simple.Tube(Input=simple.OutputPort(tracks, 2), Radius=0.35)
    coloured(tubes, view, "POINTS", "Track", "track")
    plain(atoms, view, [0.7, 0.7, 0.75])
    view.Update()
    os.unlink(file.name)
    return 0.0, 0.0, 1.0


def spheres(atoms):
    balls = simple.Glyph(Input=atoms, GlyphType="Sphere", ScaleArray=["POINTS", "Radius"], ScaleFactor=2.0,
                         GlyphMode="All Points")
    balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 16
    return balls


def atom_selection(view):
    atoms = data("molecules/complexes/3pa3.pdb.gz")
    plain(simple.AtomSelection(Input=atoms), view, [0.6, 0.6, 0.65])
    plain(spheres(simple.AtomSelection(Input=atoms, IncludeChains=0, IncludeLigands=1)), view, VERMILION)
    return 0.0, 0.0, 1.0


def force_field_charges(view):
    charged = simple.ForceFieldCharges(Input=data("molecules/1ubq.pdb"))
    coloured(spheres(charged), view, "POINTS", "Charge", "charge, e", symmetric=0.8)
    simple.GetColorTransferFunction("Charge").InvertTransferFunction()  # red is negative everywhere
    return 0.0, 0.0, 1.0


def molecule_cartoon(view):
    display = molecules.show(simple.MoleculeCartoon(data("molecules/1hew.pdb")), view)
    bar = simple.GetScalarBar(display.LookupTable, view)
    bar.TitleColor = bar.LabelColor = INK
    return 0.0, 0.2, 1.0


SCENES = {
    "AtomSelection": atom_selection, "MoleculeCartoon": molecule_cartoon, "ForceFieldCharges": force_field_charges,
    "SurfaceCurvature": surface_curvature, "ScalarRegions": scalar_regions,
    "HighOrderDiffusion": high_order_diffusion, "DiffusionHighPass": diffusion_high_pass,
    "PDETransform": pde_transform, "DualContouring": dual_contouring,
    "SurfaceMeasures": surface_measures, "SurfaceToGrid": surface_to_grid, "CellIncidence": cell_incidence,
    "HandleFilling": handle_filling, "OffsetSurface": offset_surface, "NonpolarSolvation": nonpolar_solvation,
    "FeatureTracks": feature_tracks}

def trajectory_loops(picture):
    """The view and the chart of the button, on the ring of the tests."""
    sys.path.insert(0, str(HERE.parent / "Testing" / "Python"))
    import ring_models

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "ring.pdb"
        ring_models.write(path, 12)
        made = pipelines.trajectory_to_loops(simple.OpenDataFile(str(path)))
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view=view)
        pipelines.show(*made, view=view, tables=True)
        chart = next(each for each in simple.GetViews() if each.SMProxy.GetXMLName() == "XYChartView")
        view.UseColorPaletteForBackground, view.Background, view.OrientationAxesVisibility = 0, [1.0, 1.0, 1.0], 0
        for display in view.Representations:
            if hasattr(display, "TitleColor"):
                display.TitleColor = display.LabelColor = INK
                display.TitleFontSize = display.LabelFontSize = 12
            elif hasattr(display, "Color"):
                display.Color = INK
        chart.ChartTitleFontSize, chart.LegendFontSize = 13, 10
        for axis in ("Left", "Bottom"):
            setattr(chart, f"{axis}AxisTitleFontSize", 12)
            setattr(chart, f"{axis}AxisLabelFontSize", 10)
        simple.SaveScreenshot(str(picture), simple.GetLayout(view), ImageResolution=[960, 480],
                              FontScaling="Do not scale fonts")
        simple.Delete(chart)
        simple.Delete(view)


PICTURES = {"TrajectoryLoops": trajectory_loops}  # of more than one view

TALL = ("ScalarRegions", "SurfaceCurvature", "SurfaceToGrid")


def make(name, picture):
    if name in PICTURES:
        PICTURES[name](picture)
    else:
        make_scene(name, picture)
    # 128 colours keep a picture small; without ImageMagick it is larger.
    subprocess.run(["convert", str(picture), "-colors", "128", str(picture)], check=False)
    for source in list(simple.GetSources().values()):
        simple.Delete(source)


def make_scene(name, picture):
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    direction = SCENES[name](view)
    simple.ResetCamera(view)
    view.CameraPosition = [f + 300 * d for f, d in zip(view.CameraFocalPoint, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(1.1 if name in TALL else 1.4)
    simple.SaveScreenshot(str(picture), view, ImageResolution=SIZE)
    simple.Delete(view)


def main():
    if "--help" in sys.argv:
        print(__doc__)
        return
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else HERE / "filters"
    folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[2:] or [*SCENES, *PICTURES]:
        make(name, folder / f"{name}.png")
        print(folder / f"{name}.png", flush=True)


if __name__ == "__main__":
    main()
