"""The buttons on data as people have them: Map to surface on a map whose density is darker than the
background gives the surface of the same map turned over; Surface to choking loops repairs patches that
Choking Loops alone refuses.
"""

from paraview import servermanager, simple
from shared_data import shared_data

import isthmus_pipelines as pipelines  # there once paraview.simple has loaded the plugin


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
