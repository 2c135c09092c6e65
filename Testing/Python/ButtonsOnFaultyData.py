"""The buttons on data as people have them: Map to surface on a map whose density is darker than the
background gives the surface of the same map turned over; Surface to choking loops repairs patches that
Choking Loops alone refuses.
"""

import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from shared_data import shared_data

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin


def measures_of(surface):
    measures = simple.SurfaceMeasures(Input=surface)
    measures.UpdatePipeline()
    field = servermanager.Fetch(measures).GetFieldData()
    values = [field.GetArray(name).GetValue(0) for name in ("Area", "Volume", "Genus", "Components")]
    simple.Delete(measures)
    return values


for name in ("emd_1832.map", "emd_5043.map", "1oel_10.mrc"):
    given = simple.OpenDataFile(str(shared_data(f"maps/{name}")))
    scalars = pipelines._point_array(given)
    right, = pipelines.map_to_surface(given)
    assert right.InsideIsHigher == 1, name
    expected = measures_of(right)
    inverted = simple.Calculator(given, ResultArrayName="Inverted", Function=f'-"{scalars}"')
    inverted.UpdatePipeline()
    simple.SetActiveSource(inverted)
    alone = simple.MapSurface(inverted, Scalars=["POINTS", "Inverted"])
    alone.UpdatePipeline()
    assert alone.FieldData["InvertedContrast"], f"{name}: the filter does not suspect it"
    pipelines_array = pipelines._point_array
    pipelines._point_array = lambda source: "Inverted"
    try:
        surface, = pipelines.map_to_surface(inverted)
    finally:
        pipelines._point_array = pipelines_array
    assert surface.InsideIsHigher == 0, f"{name}: not switched"
    found = measures_of(surface)
    print(name, expected, found)
    assert found[2:] == expected[2:], name
    for a, b in zip(found[:2], expected[:2]):
        assert abs(a - b) <= 1e-6 * abs(b), name

patch = simple.OpenDataFile(str(shared_data("reports/s02_flipped_patch.obj")))
loops, = pipelines.surface_to_loops(patch)
assert loops.CapHoles == 1
assert loops.GetDataInformation().GetNumberOfCells() == 2, "a torus has one handle and one tunnel"
cracks = simple.OpenDataFile(str(shared_data("reports/s04_jitter_cracks.stl")))
loops, = pipelines.surface_to_loops(cracks)
assert loops.GetDataInformation().GetNumberOfCells() == 2


def torus(patches, hole=False, facets=False):
    """A torus in which the triangles around `patches` points are turned over; with some triangles
    missing; with points of its own for each triangle."""
    u, v = 48, 24
    points = [((4 + np.cos(b)) * np.cos(a), (4 + np.cos(b)) * np.sin(a), np.sin(b))
              for a in 2 * np.pi * np.arange(u) / u for b in 2 * np.pi * np.arange(v) / v]
    corners = []
    for i in range(u):
        for j in range(v):
            a, b = i * v + j, (i + 1) % u * v + j
            c, d = (i + 1) % u * v + (j + 1) % v, i * v + (j + 1) % v
            corners += [(a, b, c), (a, c, d)]
    corners = np.array(corners)
    points = np.array(points)
    middles = points[corners].mean(axis=1)
    turned = np.zeros(len(corners), bool)
    for k in range(patches):
        turned |= np.linalg.norm(middles - middles[k * len(corners) // patches], axis=1) < 0.7
    corners[turned] = corners[turned][:, ::-1]
    if hole:
        corners = corners[np.linalg.norm(middles - points[v // 2], axis=1) > 0.5]
    if facets:
        points = points[corners].reshape(-1, 3)
        corners = np.arange(len(points)).reshape(-1, 3)
    data = vtkPolyData()
    places = vtkPoints()
    places.SetDataTypeToDouble()
    for point in points:
        places.InsertNextPoint(point)
    data.SetPoints(places)
    cells = vtkCellArray()
    for three in corners:
        cells.InsertNextCell(3, [int(c) for c in three])
    data.SetPolys(cells)
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def lengths(loops):
    """Of the loops, shortest first."""
    data = servermanager.Fetch(loops)
    return sorted(sum(np.linalg.norm(np.diff([data.GetPoint(line.GetPointId(i)) for i in
                                              range(line.GetNumberOfPoints())], axis=0), axis=1))
                  for line in map(data.GetCell, range(data.GetNumberOfCells())))


# What the filter orients with CapHoles, the button does not refuse; loops are those of the right torus.
right = lengths(pipelines.surface_to_loops(torus(0))[0])
assert len(right) == 2, right
for patches, options in ((1, {}), (3, {}), (10, {}), (2, {"hole": True}), (3, {"facets": True}),
                         (4, {"hole": True, "facets": True})):
    source = torus(patches, **options)
    alone = simple.ChokingLoops(source)
    alone.UpdatePipeline()
    assert alone.FieldData["NumberOfSamples"] is None, (patches, options, "the filter alone takes it")
    loops, = pipelines.surface_to_loops(source)
    found = lengths(loops)
    print(patches, options, found)
    assert len(found) == 2 and np.allclose(found, right, rtol=0.02), (patches, options, found, right)
