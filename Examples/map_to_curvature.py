"""From a density map to a surface coloured by its curvature: the main job of Isthmus.

Usage: pvpython map_to_curvature.py MAP OUTPUT_FOLDER [LEVEL]. Writes curvature.png (six descriptors
side by side), denoising.png (the surface without and with denoising), surface.vtp, report.json,
report.txt and pipeline.pvsm, which ParaView opens. Prints its steps to standard error and the
numbers to standard output.
Without LEVEL, the surface is drawn at the automatic level of Map Surface: recommended, or else estimated.
"""

import re
import sys
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from isthmus_plugin import look  # noqa: E402, there once paraview.simple has loaded the plugin
import surface_report  # noqa: E402
from step_lines import step  # noqa: E402

# Array, title of its colour bar, colours, and where the range comes from: "signed" is symmetric
# about zero, so that white is flat; "unsigned" starts at zero; else the array's whole range.
DESCRIPTORS = (
    ("GaussianCurvature", "Gaussian curvature (1/Å²)", "Cool to Warm (Extended)", "signed"),
    ("MeanCurvature", "Mean curvature (1/Å)", "Cool to Warm (Extended)", "signed"),
    ("MaximumCurvature", "Maximum curvature (1/Å)", "Cool to Warm (Extended)", "signed"),
    ("MinimumCurvature", "Minimum curvature (1/Å)", "Cool to Warm (Extended)", "signed"),
    ("ShapeIndex", "Shape index", "Cool to Warm (Extended)", (-1.0, 1.0)),
    ("Curvedness", "Curvedness (1/Å)", look.SEQUENTIAL, "unsigned"),
)
BACKGROUND = [1.0, 1.0, 1.0]
INK = [0.1, 0.1, 0.1]


def denoise(volume, **options):
    return simple.DenoiseMap(Input=volume, Scalars=["POINTS", "Density"], MaskInvalid=1, **options)


def open_denoised(path):
    """Reader and denoised volume of a map."""
    reader = simple.OpenDataFile(str(path))
    return reader, denoise(reader, registrationName="Denoised")


def isosurface(volume, level, **options):
    return simple.Contour(
        Input=volume, ContourBy=["POINTS", "Density"], Isosurfaces=[level], ComputeScalars=0,
        **options)


def read_map(reader):
    """The map of a reader, as a step."""
    with step("Reading", reader) as this:
        reader.UpdatePipeline()
        image = servermanager.Fetch(reader)
        low, high = image.GetScalarRange()
        this.facts += [f"{' x '.join(map(str, image.GetDimensions()))} nodes", f"values {low:.4g} to {high:.4g}"]
    return image


def run_denoising(reader, denoised):
    """The denoised map, as a step; returns the noise levels of both maps."""
    with step("Denoising", reader, denoised) as this:
        denoised.UpdatePipeline()
        noise = dict(zip(("map", "map, denoised"), noise_levels(denoised)))
        this.facts.append("noise {:.2g} to {:.2g}".format(*noise.values()))
        # Why nothing was removed, in the first words of the filter's warning.
        this.facts += [re.split("[.:,] ", text)[0].lower() for text in this.take_warnings(denoised)]
    return noise


def chosen_level(reader, level):
    """The level of the surface and its source, as Map Surface chooses it."""
    surface = simple.MapSurface(Input=reader)
    if level is not None:
        surface.Level = level
    fields = servermanager.Fetch(surface).GetFieldData()
    return {"value": fields.GetArray("Level").GetValue(0), "source": fields.GetAbstractArray("LevelSource").GetValue(0)}


def run_curvature(image, denoised, level):
    """The surface and its curvature, as a step: the filter, and its output."""
    surface = isosurface(denoised, level, registrationName="Isosurface", ComputeNormals=1)
    curvature = simple.HessianCurvature(
        registrationName="HessianCurvature", Input=denoised, Surface=surface)
    with step("Surface and curvature", surface, curvature) as this:
        curvature.UpdatePipeline()
        data = servermanager.Fetch(curvature)
        this.facts.append(f"{data.GetNumberOfPolys()} triangles")
    if data.GetNumberOfPolys() == 0:
        sys.exit("There is no surface at level {:g}: the map's values are between {:g} and {:g}.".format(
            level, *image.GetScalarRange()))
    return curvature, data


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def symmetry_axis(points):
    """The principal axis of the points whose variance differs most from the other two, and one perpendicular to it.

    For a ring-shaped assembly this is the axis of symmetry, which is the best viewing direction.
    """
    variances, axes = numpy.linalg.eigh(numpy.cov((points - points.mean(axis=0)).T))
    single = 0 if variances[1] - variances[0] > variances[2] - variances[1] else 2
    return axes[:, single], axes[:, 1]


def set_properties(proxy, **properties):
    for name, value in properties.items():
        setattr(proxy, name, value)


def colour_range(values, kind):
    """Range of a colour bar without the outermost 2 % of the values."""
    if isinstance(kind, tuple):
        return kind
    low, high = numpy.percentile(values, (2, 98))
    if kind == "signed":
        high = max(abs(low), abs(high))
    return (-high if kind == "signed" else 0.0), max(high, 1e-12)


def show_colour_bar(table, view, title, limits, labels=".2g"):
    """A colour bar below the picture, labelled at its ends and middle, with a title."""
    low, high = limits
    bar = simple.GetScalarBar(table, view)
    set_properties(
        bar, Title=title, ComponentTitle="", Visibility=1,
        TitleColor=INK, LabelColor=INK, TitleFontSize=15, LabelFontSize=13, ScalarBarLength=0.6,
        ScalarBarThickness=12, WindowLocation="Any Location", Orientation="Horizontal",
        Position=[0.2, 0.02], AddRangeLabels=0, UseCustomLabels=1,
        CustomLabels=[low, (low + high) / 2, high], AutomaticLabelFormat=0, LabelFormat=look.number_format(bar,
        labels))


def show_descriptor(view, curvature, values, descriptor):
    """The surface in `view`, coloured by one descriptor, with its colour bar."""
    array, title, colours, kind = descriptor
    display = simple.Show(curvature, view)
    simple.ColorBy(display, ("POINTS", array))
    table = simple.GetColorTransferFunction(array)
    table.ApplyPreset(colours, True)
    # Each further Show() colours by the mean curvature first, and would stretch its range.
    table.AutomaticRescaleRangeMode = "Never"
    low, high = colour_range(values, kind)
    table.RescaleTransferFunction(low, high)
    show_colour_bar(table, view, title, (low, high))


def three_by_two(layout):
    """Splits a layout; its six cells row by row, as ParaView numbers them (children of c: 2c+1, 2c+2)."""
    layout.SplitVertical(0, 0.5)
    rows = []
    for row in (1, 2):
        layout.SplitHorizontal(row, 1 / 3)
        right = 2 * row + 2
        layout.SplitHorizontal(right, 0.5)
        rows += [2 * row + 1, 2 * right + 1, 2 * right + 2]
    return rows


def look_along(points, direction, up, colour_bar=True):
    """Properties of a view of the points along `direction`, with room for a colour bar below."""
    center = (points.min(axis=0) + points.max(axis=0)) / 2
    radius = numpy.linalg.norm(numpy.cross(points - center, direction), axis=1).max()
    if colour_bar:
        center = center - 0.2 * radius * up
    return dict(
        UseColorPaletteForBackground=0, Background=BACKGROUND, OrientationAxesVisibility=0,
        CameraFocalPoint=center, CameraPosition=center + 9 * radius * direction, CameraViewUp=up,
        CameraParallelProjection=1, CameraParallelScale=(1.3 if colour_bar else 1.15) * radius)


def six_views(curvature, data):
    """One layout with a view for each descriptor, three by two, all from the same direction."""
    points = points_of(data)
    camera = look_along(points, *symmetry_axis(points))
    layout = simple.CreateLayout("Curvature")
    for cell, descriptor in zip(three_by_two(layout), DESCRIPTORS):
        view = simple.CreateView("RenderView")
        layout.AssignView(cell, view)
        values = vtk_to_numpy(data.GetPointData().GetArray(descriptor[0]))
        show_descriptor(view, curvature, values, descriptor)
        set_properties(view, **camera)
    return layout


def noise_levels(denoised):
    """Standard deviation of the noise that Denoise Map found in its input, and of the remaining noise, estimated from the gain in
    dB."""
    level, gain = (denoised.FieldData[name].GetRange(0)[0] for name in ("NoiseLevel", "EstimatedGain"))
    return level, level * 10 ** (-gain / 20)


def with_added_noise(image, deviation):
    """The map with added Gaussian noise of known deviation, to demonstrate denoising on any map."""
    noisy = image.NewInstance()
    noisy.CopyStructure(image)
    density = vtk_to_numpy(image.GetPointData().GetArray("Density")).astype(numpy.float32)
    noise = numpy.random.default_rng(1).normal(0.0, deviation, density.size).astype(numpy.float32)
    array = numpy_to_vtk(density + noise, deep=True)
    array.SetName("Density")
    noisy.GetPointData().SetScalars(array)
    source = simple.TrivialProducer(registrationName="With added noise")
    source.GetClientSideObject().SetOutput(noisy)
    return source


def show_level(volume, level, caption, camera, view):
    """The isosurface of a volume in one colour, with a line above it."""
    display = simple.Show(isosurface(volume, level), view)
    set_properties(
        display, ColorArrayName=["POINTS", ""], DiffuseColor=[0.75, 0.8, 0.88],
        AmbientColor=[0.75, 0.8, 0.88])
    text = simple.Show(simple.Text(Text=caption), view)
    set_properties(text, Color=INK, FontSize=14, WindowLocation="Upper Center")
    set_properties(view, **camera)


def before_and_after(reader, denoised, image, level, data, noise):
    """One layout of isosurfaces with the same level and camera: above, the map without and with denoising; below,
    the same for the map with added noise as strong as the map itself. `noise`: levels of noise of the first two.
    Returns those of all four as well."""
    noisy = with_added_noise(image, float(numpy.nanstd(vtk_to_numpy(
        image.GetPointData().GetArray("Density")))))
    points = points_of(data)
    camera = look_along(points, *symmetry_axis(points), colour_bar=False)
    cleared = denoise(noisy)
    cleared.UpdatePipeline()
    volumes = {"map": reader, "map, denoised": denoised, "noise added": noisy, "noise added, denoised": cleared}
    noise = {**noise, **dict(zip(("noise added", "noise added, denoised"), noise_levels(cleared)))}
    layout = simple.CreateLayout("Denoising")
    layout.SplitVertical(0, 0.5)
    layout.SplitHorizontal(1, 0.5)
    layout.SplitHorizontal(2, 0.5)
    for cell, (name, volume) in zip((3, 4, 5, 6), volumes.items()):
        view = simple.CreateView("RenderView")
        layout.AssignView(cell, view)
        caption = f"{name[0].upper()}{name[1:]}: noise {noise[name]:.2g}"
        show_level(volume, level, caption, camera, view)
    return layout, noise


def main(path, folder, level):
    folder.mkdir(parents=True, exist_ok=True)
    reader, denoised = open_denoised(path)
    image = read_map(reader)
    noise = run_denoising(reader, denoised)
    level = chosen_level(reader, level)
    curvature, data = run_curvature(image, denoised, level["value"])
    # Not as raw appended data, the default: VTK 9.2 with the expat of Debian 12's security updates
    # stumbles over some of those files, depending on where in the file they begin.
    simple.SaveData(str(folder / "surface.vtp"), proxy=curvature, DataMode="Binary")
    with step("Pictures") as this:
        layout = six_views(curvature, data)
        simple.SaveScreenshot(str(folder / "curvature.png"), layout, ImageResolution=[1800, 1200])
        simple.SaveState(str(folder / "pipeline.pvsm"))
        layout, noise = before_and_after(reader, denoised, image, level["value"], data, noise)
        simple.SaveScreenshot(str(folder / "denoising.png"), layout, ImageResolution=[1400, 1400])
        this.facts.append("curvature.png and denoising.png")
    surface_report.write(path, image, level, noise, data, [row[0] for row in DESCRIPTORS], folder)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        print(__doc__)
        sys.exit(not {"-h", "--help"} & set(sys.argv[1:]))
    main(Path(sys.argv[1]), Path(sys.argv[2]), float(sys.argv[3]) if len(sys.argv) > 3 else None)
