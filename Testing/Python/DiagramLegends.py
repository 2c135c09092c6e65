"""The legend of a persistence diagram covers neither points nor lines, and buttons leave their result selected."""

import os
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import pocket_views as pockets
from shared_data import shared_data

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "DiagramLegends"
FOLDER.mkdir(parents=True, exist_ok=True)
SIZE = [420, 400]  # of a chart beside a view, in a small window


def picture(chart, name):
    path = str(FOLDER / f"{name}.png")
    simple.SaveScreenshot(path, chart, ImageResolution=SIZE)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
    return pixels.reshape(SIZE[1], SIZE[0], 3)


def covered(chart, name):
    """How many pixels of points and lines the legend covers, and how many pixels it has."""
    chart.ViewSize = SIZE
    with_legend = picture(chart, name)
    chart.ShowLegend = 0
    without = picture(chart, f"{name}_without")
    chart.ShowLegend = 1
    rows, columns = numpy.nonzero(abs(with_legend - without).max(axis=2) > 40)
    legend = slice(rows.min() + 3, rows.max() - 2), slice(columns.min() + 3, columns.max() - 2)  # without the axes
    print(name, "legend", legend, "covers", (without[legend].min(axis=2) < 200).sum())
    return int((without[legend].min(axis=2) < 200).sum()), with_legend[legend].size // 3


view = simple.GetActiveViewOrCreate("RenderView")
simple.AssignViewToLayout(view=view)
for data in ("surfaces/torus.obj", "maps/emd_1832.map"):
    opened = simple.OpenDataFile(str(shared_data(data)))
    stem = Path(data).stem
    made = pipelines.map_to_loops(opened) if data.endswith(".map") else pipelines.surface_to_loops(opened)
    (chart,) = pipelines.persistence_diagram(made[-1])
    hidden, size = covered(chart, f"{stem}_loops")
    assert size > 5000 and hidden == 0, (hidden, size)
    if data.endswith(".map"):
        persistence = simple.ScalarPersistence(opened)
        for superlevel in (1, 0):
            persistence.Superlevel = superlevel
            persistence.UpdatePipeline()
            (chart,) = pipelines.persistence_diagram(persistence)
            hidden, size = covered(chart, f"{stem}_persistence_{superlevel}")
            assert size > 3000 and hidden == 0, (hidden, size)

# Tables and surfaces that are made for the display do not become the selected source.
molecule = simple.OpenDataFile(str(shared_data("molecules/1hew.pdb")))
for make in (pipelines.protein_to_pockets, pipelines.protein_to_pores):
    source = molecule if make is pipelines.protein_to_pockets else simple.OpenDataFile(
        str(shared_data("molecules/channels/1grm_hole_example.pdb")))
    found = make(source)[-1]
    pockets.show(found, view)
    assert simple.GetActiveSource() == found, f"{make.__name__}: another source is selected"
