"""Compares the main job's numbers with those of Debian 12. Run by release.sh after Examples/run.sh, in the root, with
the plugin of the build tree.

    pvpython main_job_numbers.py EXAMPLE_FOLDER NUMBERS.json

Prints the numbers, and writes them with the version of VTK to NUMBERS.json. The exit status is 1 if one differs by more
than it may.
"""

import json
import sys
from pathlib import Path

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion

MAP = "emd_5043.map"
# On Debian 12, with the relative difference that is allowed elsewhere. Other versions of CGAL and TetGen produce
# different triangles and tetrahedra of the same surface.
EXPECTED = {"genus": (22, 0), "handles": (22, 0), "tunnels": (22, 0), "additional loops inside": (33, 0),
            "additional loops outside": (7, 0), "loops": (85, 0),
            "area": (137026.428, 1e-3), "volume": (722968.003, 1e-3),
            "smallest birth": (2.51506, 1e-3), "largest birth": (15.2436, 1e-3),
            "smallest death": (8.45496, 1e-3), "largest death": (16.1899, 1e-3),
            "Delaunay triangles": (10974, 0.02), "Delaunay area": (135197.990, 1e-3),
            "tetrahedra": (16069, 0.05), "volume of the tetrahedra": (706984.548, 1e-3)}


def fetched(source):
    source.UpdatePipeline()
    return servermanager.Fetch(source)


def column(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name)).astype(float)


def loops_of(path):
    """Counts and ranges of the loops in choking_loops.vtp."""
    data = fetched(simple.OpenDataFile(str(path)))
    field, cells = data.GetFieldData(), data.GetCellData()
    inside, outside = column(field, "NumberOfAdditionalLoops").tolist()
    numbers = {"handles": column(field, "NumberOfHandles")[0], "tunnels": column(field, "NumberOfTunnels")[0],
               "additional loops inside": inside, "additional loops outside": outside, "loops": data.GetNumberOfCells()}
    for name in ("Birth", "Death"):
        values = column(cells, name)
        numbers[f"smallest {name.lower()}"], numbers[f"largest {name.lower()}"] = float(values.min()), float(values.max())
    return numbers


def measures_of(mesh):
    """Number of cells and their total size of the files of map_to_mesh.py."""
    sizes = fetched(simple.CellSize(Input=mesh)).GetCellData()
    name = "Volume" if sizes.GetArray("Volume") and column(sizes, "Volume").any() else "Area"
    values = column(sizes, name)
    return len(values), float(values.sum())


def main(example, result):
    example = Path(example)
    report = json.loads((example / "report.json").read_text())
    if Path(report["map"]["file"]).name != MAP:
        sys.exit(f"The main job used {report['map']['file']}; the expected numbers are those of {MAP}.")
    surface = report["surface"]
    numbers = {"genus": surface["genus_from_euler_number"], "area": surface["area_A2"],
               "volume": surface["enclosed_volume_A3"], **loops_of(example / "choking_loops.vtp")}
    numbers["Delaunay triangles"], numbers["Delaunay area"] = measures_of(
        simple.OpenDataFile(str(example / "surface_delaunay.vtp")))
    numbers["tetrahedra"], numbers["volume of the tetrahedra"] = measures_of(
        simple.OpenDataFile(str(example / "tetrahedra.vtu")))
    Path(result).write_text(json.dumps({"VTK": vtkVersion.GetVTKVersion(), **numbers}))
    wrong = 0
    for name, (expected, limit) in EXPECTED.items():
        fine = abs(numbers[name] - expected) <= limit * abs(expected)
        wrong += not fine
        print(f"{name:26}{numbers[name]:14.9g}" + ("" if fine else f"  WRONG: {expected:.9g} on Debian 12, "
                                                   f"of which {limit:g} may differ"))
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main(*sys.argv[1:])
