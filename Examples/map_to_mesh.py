"""From a density map to a surface with well-shaped triangles and the tetrahedra inside it.

Usage: pvpython map_to_mesh.py MAP FOLDER LEVEL. Denoises as map_to_curvature.py does, takes the level
set by marching cubes and by Delaunay refinement, and fills the latter with tetrahedra. Writes
surface_delaunay.vtp, tetrahedra.vtu, angles.png (both histograms of angles, as Fig. 4.5 of the
thesis), cutaway.png and mesh.txt. Prints its steps to standard error and the ranges of the angles
to standard output.
"""

import sys
from pathlib import Path

from paraview import servermanager, simple

sys.path.insert(0, str(Path(__file__).resolve().parent))
from isthmus_plugin import look  # noqa: E402, there once paraview.simple has loaded the plugin
import map_to_curvature  # noqa: E402
from map_to_curvature import (  # noqa: E402
    INK, look_along, points_of, set_properties, show_colour_bar, symmetry_axis)
from step_lines import step  # noqa: E402

BINS = 18  # of 10 degrees
BAR = 40  # characters
COLOURS = {"Marching cubes": (0.62, 0.66, 0.72), "Delaunay": (0.13, 0.47, 0.71)}


def build_meshes(path, level):
    """Both surfaces of the denoised map, and the tetrahedra inside the Delaunay one."""
    reader, denoised = map_to_curvature.open_denoised(path)
    map_to_curvature.run_denoising(reader, denoised)
    contour = map_to_curvature.isosurface(denoised, level)
    delaunay = simple.DelaunayIsosurface(
        registrationName="DelaunayIsosurface", Input=denoised, Level=level)
    with step("Delaunay surface", delaunay) as this:
        delaunay.UpdatePipeline()
        this.facts.append(f"{delaunay.GetDataInformation().GetNumberOfCells()} triangles")
    tetrahedra = simple.TetrahedralMesher(registrationName="Tetrahedra", Input=delaunay)
    with step("Tetrahedra", tetrahedra) as this:
        tetrahedra.UpdatePipeline()
        this.facts.append(f"{tetrahedra.GetDataInformation().GetNumberOfCells()} tetrahedra")
        unmet = unmet_bounds(tetrahedra)
        if this.take_warnings(tetrahedra, unmet):
            this.facts.append(unmet.split(": ")[1].split(". ")[0])
    return {"Marching cubes": contour, "Delaunay": delaunay}, tetrahedra


def unmet_bounds(tetrahedra):
    """The filter's message about tetrahedra that exceed its bounds; "" if there are none."""
    array = servermanager.Fetch(tetrahedra).GetFieldData().GetAbstractArray("UnmetBounds")
    return array.GetValue(0) if array else ""


def quality(mesh):
    return simple.MeshQualityReport(Input=mesh, NumberOfBins=BINS)


def fractions(report):
    """Share of all angles in each bin."""
    column = servermanager.Fetch(report, idx=1).GetColumnByName("Fraction")
    return [column.GetValue(i) for i in range(column.GetNumberOfTuples())]


def summary(report):
    return servermanager.Fetch(report).GetFieldData().GetAbstractArray("QualitySummary").GetValue(0)


def side_by_side(histograms):
    """The histograms of the triangles' angles as text, one column each."""
    width = BAR + 9
    lines = ["Angles of the triangles, in degrees, and their share",
             " " * 12 + "".join(f"{name:<{width}}" for name in histograms)]
    top = max(max(shares) for shares in histograms.values())
    for i in range(BINS):
        cells = (f"{100 * shares[i]:5.1f} % {'#' * round(BAR * shares[i] / top):<{width - 8}}"
                 for shares in histograms.values())
        lines.append(f"{180 // BINS * i:>4} - {180 // BINS * (i + 1):<5}" + "".join(cells))
    return lines


def angle_picture(reports, picture):
    """The same histograms as two bar charts with the same scale."""
    layout = simple.CreateLayout("Angles")
    layout.SplitHorizontal(0, 0.5)
    top = 1.1 * max(max(fractions(report)) for report in reports.values())
    for cell, (name, report) in zip((1, 2), reports.items()):
        view = simple.CreateView("XYBarChartView")
        layout.AssignView(cell, view)
        set_properties(
            view, ChartTitle=name, BottomAxisTitle="Angle (degrees)", LeftAxisTitle="Share of angles",
            LeftAxisUseCustomRange=1, LeftAxisRangeMinimum=0.0, LeftAxisRangeMaximum=top,
            BottomAxisUseCustomRange=1, BottomAxisRangeMinimum=0.0, BottomAxisRangeMaximum=180.0,
            ShowLegend=0)
        display = simple.Show(simple.OutputPort(report, 1), view, "XYBarChartRepresentation")
        set_properties(
            display, UseIndexForXAxis=0, XArrayName="Angle", SeriesVisibility=["Fraction"],
            SeriesColor=["Fraction", *map(str, COLOURS[name])])
    simple.SaveScreenshot(str(picture), layout, ImageResolution=[1600, 700])


def cutaway_picture(surface, report, picture):
    """The tetrahedra on one side of a plane, uncut, coloured by their smallest dihedral angle.

    The plane contains the axis of symmetry, so that a channel along it is visible.
    """
    points = points_of(servermanager.Fetch(surface))
    axis, across = symmetry_axis(points)
    clip = simple.Clip(
        Input=report, ClipType="Plane", Crinkleclip=1, Scalars=["CELLS", "SmallestAngle"])
    set_properties(clip.ClipType, Origin=(points.min(axis=0) + points.max(axis=0)) / 2, Normal=across)
    view = simple.CreateView("RenderView")
    simple.CreateLayout("Cutaway").AssignView(0, view)
    display = simple.Show(clip, view)
    display.SetRepresentationType("Surface With Edges")
    display.EdgeColor = INK
    simple.ColorBy(display, ("CELLS", "SmallestAngle"))
    table = simple.GetColorTransferFunction("SmallestAngle")
    table.ApplyPreset(look.SEQUENTIAL, True)
    table.RescaleTransferFunction(0.0, 60.0)
    show_colour_bar(table, view, "Smallest dihedral angle (degrees)", (0.0, 60.0), ".0f")
    set_properties(view, ViewSize=[1200, 1100], **look_along(points, across, axis))
    simple.SaveScreenshot(str(picture), view, ImageResolution=[1200, 1100])


def main(path, folder, level):
    surfaces, tetrahedra = build_meshes(path, level)
    reports = {name: quality(surface) for name, surface in surfaces.items()}
    inside = quality(tetrahedra)
    histograms = side_by_side({name: fractions(report) for name, report in reports.items()})
    ranges = [f"{name}: {summary(report)}" for name, report in reports.items()]
    ranges.append(f"Tetrahedra: {summary(inside)}")
    (folder / "mesh.txt").write_text("\n".join(histograms + ranges) + "\n")
    simple.SaveData(
        str(folder / "surface_delaunay.vtp"), proxy=surfaces["Delaunay"], DataMode="Binary")
    simple.SaveData(str(folder / "tetrahedra.vtu"), proxy=tetrahedra, DataMode="Binary")
    with step("Pictures") as this:
        angle_picture(reports, folder / "angles.png")
        cutaway_picture(surfaces["Delaunay"], inside, folder / "cutaway.png")
        this.facts.append("angles.png and cutaway.png")
    print("\n".join(ranges))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        print(__doc__)
        sys.exit(not {"-h", "--help"} & set(sys.argv[1:]))
    main(Path(sys.argv[1]), Path(sys.argv[2]), float(sys.argv[3]))
