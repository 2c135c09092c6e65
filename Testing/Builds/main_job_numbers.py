"""The main job's numbers, for the comparison of versions in Examples/guide/tested_versions.md. Run by
release.sh after Examples/run.sh, in the root, with the plugin of the build tree.

    pvpython main_job_numbers.py EXAMPLE_FOLDER DATA_FOLDER NUMBERS.json
"""

import json
import sys
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion

# Of the loops of the Delaunay surface; each is sorted, since the order of loops of equal rank may differ.
LOOPS = ("Birth", "Death", "Length")
# Curvature at the nodes of a map: that many are kept, evenly spread, with the largest of all.
NODES, MAP = 5000, "emd_1832.map"
CURVATURES = ("GaussianCurvature", "MeanCurvature", "MaximumCurvature", "MinimumCurvature")


def fetched(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def column(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name)).astype(float)


def loops_of(path):
    """Counts and sorted values of the loops in choking_loops.vtp."""
    data = fetched(simple.OpenDataFile(str(path)))
    field, cells = data.GetFieldData(), data.GetCellData()
    inside, outside = column(field, "NumberOfAdditionalLoops").tolist()
    numbers = {"handles": column(field, "NumberOfHandles")[0], "tunnels": column(field, "NumberOfTunnels")[0],
               "additional loops inside": inside, "additional loops outside": outside}
    numbers.update((f"loops: {name.lower()}", sorted(column(cells, name).tolist())) for name in LOOPS)
    return numbers


def measures_of(mesh):
    """Number of cells and their total size of the files of MapToMesh.py."""
    sizes = fetched(simple.CellSize(Input=mesh)).GetCellData()
    name = "Volume" if sizes.GetArray("Volume") and column(sizes, "Volume").any() else "Area"
    values = column(sizes, name)
    return len(values), float(values.sum())


def curvature_of_nodes(path):
    """{array: [largest absolute value, values at some nodes]}."""
    points = fetched(simple.HessianCurvature(Input=simple.OpenDataFile(str(path)))).GetPointData()
    numbers = {}
    for name in CURVATURES:
        values = column(points, name)
        numbers[name] = [float(abs(values).max()), *values[::max(1, len(values) // NODES)].tolist()]
    return numbers


def main(example, data, result):
    example, data = Path(example), Path(data)
    report = json.loads((example / "report.json").read_text())
    surface = report["surface"]
    numbers = {"VTK": vtkVersion.GetVTKVersion(), "map": report["map"]["file"],
               "genus": surface["genus_from_euler_number"], "area": surface["area_A2"], "volume": surface["enclosed_volume_A3"]}
    numbers.update(loops_of(example / "choking_loops.vtp"))
    numbers["Delaunay triangles"], numbers["Delaunay area"] = measures_of(
        simple.OpenDataFile(str(example / "surface_delaunay.vtp")))
    numbers["tetrahedra"], numbers["volume of the tetrahedra"] = measures_of(
        simple.OpenDataFile(str(example / "tetrahedra.vtu")))
    numbers["curvature at nodes"] = curvature_of_nodes(data / "maps" / MAP)
    Path(result).write_text(json.dumps(numbers))


if __name__ == "__main__":
    main(*sys.argv[1:])
