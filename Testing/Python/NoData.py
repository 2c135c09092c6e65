"""Maps with a value for "no data", and other maps of an entry: their level lies within the density."""

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

from shared_data import shared_data


def opened(name):
    source = simple.OpenDataFile(str(shared_data(f"reports/{name}")))
    source.UpdatePipeline()
    return source


def level(source):
    surface = servermanager.Fetch(simple.MapSurface(Input=source))
    assert surface.GetNumberOfPoints() > 0
    fields = surface.GetFieldData()
    return fields.GetArray("Level").GetValue(0), fields.GetAbstractArray("LevelSource").GetValue(0)


# The level of the density (0.22 for the same map without the value) instead of the border of the mask.
for name in ("k06_sentinel_1e35.mrc", "k06_sentinel_m9999.mrc"):
    source = opened(name)
    found, _ = level(source)
    assert 0.15 < found < 0.3, (name, found)
    image = servermanager.Fetch(source)
    values = vtk_to_numpy(image.GetPointData().GetArray("Density"))
    mask = vtk_to_numpy(image.GetPointData().GetArray("NoData"))
    assert mask.sum() == 3215 and (values[mask == 1] == 0).all() and abs(values).max() < 1, name
    for filter_, settings in (("DenoiseMap", {}), ("DiffusionHighPass", {}), ("PDETransform", {"Scalars": ["POINTS", "Density"]}), ("HessianCurvature", {}),
                              ("DualContouring", {}), ("ScalarPersistence", {}), ("MapHandles", {})):
        output = servermanager.Fetch(getattr(simple, filter_)(Input=source, **settings))
        rows = output.GetRowData() if output.IsA("vtkTable") else output.GetPointData()
        for attributes in (rows, output.GetFieldData()):
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetArray(i)
                if array and array.GetNumberOfTuples() and not image.GetFieldData().HasArray(array.GetName()):
                    numbers = vtk_to_numpy(array).astype(float)
                    numbers = numbers[numpy.isfinite(numbers)]
                    assert not len(numbers) or abs(numbers).max() < 5000, (name, filter_, array.GetName(), abs(numbers).max())

# A level is that of the map itself: a mask has its middle, a map without a contour an estimate.
assert level(opened("emdb/emd_90001.map")) == (3.0, "recommended by the depositors")
assert level(opened("emdb/emd_90001_msk_1.map")) == (0.5, "estimated from the values")
found, how = level(opened("emdb/emd_90004.map"))
assert 1.5 < found < 3.0 and how == "estimated from the values", (found, how)
print("levels lie within the density")
