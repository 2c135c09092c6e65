"""Shows where a protein's surface is concave and where it is charged: toon shading, areas between thresholds and
histograms of minimum curvature and potential, as Tables 4.6 to 4.8 and Figs. 4.26 to 4.30 of the
thesis.

Usage: pvpython surface_regions.py PROTEIN [POTENTIAL] [the options of binding_sites.py]

Red is below the lower threshold, blue above the upper one. --decay 0.3 gives a coarse surface, on
which concave regions are clefts and not grooves between atoms.
"""

import sys
from pathlib import Path

from paraview import simple

sys.path.insert(0, str(Path(__file__).resolve().parent))
import binding_sites  # noqa: E402

import isthmus  # noqa: E402

CURVATURES = ((-0.2, 0.15), (-0.15, 0.15), (-0.1, 0.15), (-0.05, 0.15), (0.0, 0.15), (0.0, 0.1),
              (0.0, 0.05))
POTENTIALS = ((-2.0, 5.0), (-1.0, 5.0), (0.0, 5.0), (0.0, 4.0), (0.0, 3.0), (0.0, 2.0), (0.0, 1.0))
JOINT = ((-0.1, 0.1), (-1.0, 2.0))


def regions(surface, array, thresholds, second=None, second_thresholds=()):
    """vtkScalarRegions for one array, or two."""
    finder = isthmus.vtkScalarRegions()
    finder.SetInputData(surface)
    finder.SetInputArrayToProcess(0, 0, 0, 0, array)
    for i, value in enumerate(thresholds):
        finder.SetThreshold(i, value)
    if second:
        finder.UseSecondScalarOn()
        finder.SetInputArrayToProcess(1, 0, 0, 0, second)
        for i, value in enumerate(second_thresholds):
            finder.SetSecondThreshold(i, value)
    finder.Update()
    return finder


def column(table, name):
    return [table.GetValueByName(row, name).ToDouble() for row in range(table.GetNumberOfRows())]


def area_table(surface, array, unit, pairs):
    """Areas below, between and above each pair of thresholds."""
    lines = [f"{array} ({unit}): areas (A^2)"]
    lines += [f"{'thresholds':>16} {'below':>9} {'between':>9} {'above':>9}"]
    for pair in pairs:
        areas = column(regions(surface, array, pair).GetRegionTable(), "Area")
        lines.append(f"{pair[0]:7g}, {pair[1]:7g} " + " ".join(f"{area:9.1f}" for area in areas))
    return lines


def joint_table(surface):
    """Areas of each region of the curvature (rows) within each of the potential (columns)."""
    table = regions(surface, "MinimumCurvature", JOINT[0], "Potential", JOINT[1]).GetRegionTable()
    names = [table.GetColumnName(c) for c in range(table.GetNumberOfColumns())]
    columns = [name for name in names if name.startswith("Potential")]
    lines = ["areas (A^2) by both", " " * 24 + " ".join(f"{name:>20}" for name in columns)]
    for row, (low, high) in enumerate(zip(column(table, "From"), column(table, "To"))):
        cells = " ".join(f"{column(table, name)[row]:20.1f}" for name in columns)
        lines.append(f"kappa_2 {low:7g} .. {high:5g} {cells}")
    return lines


def show_toon(finder, view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    display = simple.Show(binding_sites.producer(finder.GetOutput()), view)
    simple.ColorBy(display, ("POINTS", "ToonColor"))
    display.MapScalars = 0
    simple.ResetCamera(view)


def show_histogram(finder, view, title):
    table = binding_sites.producer(finder.GetHistogram())
    display = simple.Show(table, view, "XYBarChartRepresentation")
    display.UseIndexForXAxis = 0
    display.XArrayName = "Value"
    display.SeriesVisibility = ["Area"]
    view.ChartTitle, view.ShowLegend = "", 0
    view.BottomAxisTitle, view.LeftAxisTitle = title, "area (A^2)"


def picture(finders, titles, path):
    """One row per array: toon shading on the left, histogram on the right."""
    layout = simple.CreateLayout()
    layout.SetSize(1200, 1000)
    rows = layout.SplitVertical(0, 0.5)
    for finder, title, cell in zip(finders, titles, (rows, rows + 1)):
        left = layout.SplitHorizontal(cell, 0.5)
        toon, chart = simple.CreateView("RenderView"), simple.CreateView("XYBarChartView")
        layout.AssignView(left, toon)
        layout.AssignView(left + 1, chart)
        show_toon(finder, toon)
        show_histogram(finder, chart, title)
    simple.SaveScreenshot(
        str(path), layout, ImageResolution=[1200, 1000], FontScaling="Do not scale fonts"
    )


def main():
    options = binding_sites.arguments(__doc__)
    surface, _, name, _ = binding_sites.prepare(options, options.output)
    lines = area_table(surface, "MinimumCurvature", "1/A", CURVATURES) + [""]
    lines += area_table(surface, "Potential", "kT/e", POTENTIALS) + [""] + joint_table(surface)
    print("\n".join(lines))
    (options.output / f"{name}_regions.txt").write_text("\n".join(lines) + "\n")
    finders = [
        regions(surface, "MinimumCurvature", JOINT[0]), regions(surface, "Potential", JOINT[1])
    ]
    titles = ["minimum curvature (1/A)", "potential (kT/e)"]
    picture(finders, titles, options.output / f"{name}_regions.png")
    print(f"Picture and tables: {options.output}")


if __name__ == "__main__":
    main()
