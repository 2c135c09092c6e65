"""The topology filters through ParaView: a .cmesh file in, edges, faces, a cutaway, the file back."""

import os
from pathlib import Path

import numpy
from isthmus import incidence
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "CellIncidence"

# Cell types by their faces; a pyramid on a hexahedron, the thesis' prism beside it.
HEADER = """isthmus-combinatorial-mesh 1 text
types 3
type 8 6 hexahedron
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
type 5 5 pyramid
4 0 3 2 1
3 0 1 4
3 1 2 4
3 2 3 4
3 3 0 4
type 6 5 prism
3 0 2 1
4 0 1 4 3
4 1 2 5 4
4 2 0 3 5
3 3 4 5
vertices 11 float64
0 0 0  1 0 0  1 1 0  0 1 0  0 0 1  1 0 1  1 1 1  0 1 1
0.5 0.5 2
2 0.5 0  2 0.5 1
blocks 3
block 0 1
0 1 2 3 4 5 6 7
block 1 1
4 5 6 7 8
block 2 1
1 9 2 5 10 6
attributes 1
attribute cells int32 1 Material
10 20 30
end
"""


def cell_values(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def check_incidence(mesh):
    incidence = simple.CellIncidence(Input=mesh)
    edges = servermanager.Fetch(incidence, idx=0)
    faces = servermanager.Fetch(incidence, idx=1)
    assert edges.GetNumberOfLines() == 12 + 4 + 5, edges.GetNumberOfLines()
    assert faces.GetNumberOfPolys() == 6 + 4 + 4, faces.GetNumberOfPolys()
    assert (cell_values(edges, "EdgeId") == numpy.arange(21)).all()
    boundary = cell_values(faces, "OnBoundary")
    assert boundary.sum() == 12
    second = cell_values(faces, "SecondIncidentCell")
    assert ((second == -1) == (boundary == 1)).all()
    assert sorted(second[boundary == 0]) == [1, 2]
    assert (cell_values(faces, "Material")[boundary == 0] == 10).all()
    # The edge that hexahedron and pyramid, and the one that hexahedron and prism, share.
    assert sorted(cell_values(edges, "NumberOfIncidentCells")) == [1] * 14 + [2] * 6 + [3]


def check_map(mesh):
    """The same numbers as those of the filter, as numpy arrays and iterators."""
    grid = servermanager.Fetch(mesh)
    whole = incidence.CombinatorialMap(grid)
    assert [whole.count(kind) for kind in incidence.KINDS] == [11, 21, 14, 3, 16, 24 + 16 + 18]
    filtered = simple.CellIncidence(Input=mesh)
    counts = cell_values(servermanager.Fetch(filtered, idx=0), "NumberOfIncidentCells")
    assert [len(fan) for fan in whole.fans()] == list(counts)
    # The shared edge's fan: prism, hexahedron and pyramid, the hexahedron in the middle.
    (edge,) = numpy.flatnonzero(counts == 3)
    assert whole.fan(edge)[1] == 0 and sorted(whole.fan(edge)) == [0, 1, 2]
    stars = list(whole.stars())
    assert list(stars[8]) == [1] and sorted(stars[6]) == [0, 1, 2] and sorted(stars[3]) == [0]
    offsets, corners = whole.incidence("cell", "vertex")
    assert sorted(corners[offsets[1]:offsets[2]]) == [4, 5, 6, 7, 8]
    assert sorted(whole.incident("cell", 0, "cell")) == [1, 2]
    across = whole.beta(3)
    assert (across[across[across >= 0]] == numpy.flatnonzero(across >= 0)).all()
    assert (across >= 0).sum() == 2 * (4 + 4) and (across < 0).sum() == 58 - 16
    # An attribute on darts: the mean of those around each vertex is summed by numpy alone.
    value = whole.attribute("dart", initial=2.0)
    offsets, darts = whole.incidence("vertex", "dart")
    assert (numpy.add.reduceat(value[darts], offsets[:-1]) == 2.0 * numpy.diff(offsets)).all()
    report = whole.memory_report()
    assert report["H2D"] == 4 * 16 and report["V2D"] == 4 * 11, report
    assert whole.estimated_bytes() == 4 * (8.7 * 3 + 12)
    for wrong in (lambda: whole.star(11), lambda: whole.incident("edge", 0, "edge"),
                  lambda: whole.count("corner"), lambda: incidence.CombinatorialMap(None)):
        try:
            wrong()
        except (IndexError, ValueError):
            continue
        raise AssertionError("accepted what does not exist")


def check_cutaway(mesh):
    cutaway = simple.TetCutaway(Input=mesh, SeedPoint=[0.5, 0.5, 2.0], NumberOfCells=1)
    surface = servermanager.Fetch(cutaway, idx=0)
    cells = servermanager.Fetch(cutaway, idx=1)
    assert cells.GetNumberOfCells() == 2
    assert cell_values(surface, "Exposed").sum() == 1
    assert list(cell_values(cells, "OriginalCellIds")) == [0, 2]
    assert list(cell_values(cells, "Material")) == [10, 30]
    cutaway.StopRule = "Plane"
    cutaway.PlaneOrigin = [0.0, 0.0, 0.75]
    cutaway.SeedPoint = [0.5, 0.5, 1.9]
    assert servermanager.Fetch(cutaway, idx=1).GetNumberOfCells() == 2


def check_file(mesh):
    for binary in (1, 0):
        path = str(OUTPUT / f"again{binary}.cmesh")
        simple.SaveData(path, proxy=mesh, Binary=binary)
        again = simple.OpenDataFile(path)
        data, expected = servermanager.Fetch(again), servermanager.Fetch(mesh)
        assert again.GetXMLName() == "CombinatorialMeshReader", again.GetXMLName()
        assert data.GetNumberOfCells() == 3 and data.GetNumberOfPoints() == 11
        for c in range(3):
            assert data.GetCellType(c) == expected.GetCellType(c)
            for i in range(data.GetCell(c).GetNumberOfPoints()):
                assert data.GetCell(c).GetPointId(i) == expected.GetCell(c).GetPointId(i)
        assert (vtk_to_numpy(data.GetPoints().GetData())
                == vtk_to_numpy(expected.GetPoints().GetData())).all()


def check_picture(mesh):
    incidence = simple.CellIncidence(Input=mesh)
    view = simple.CreateRenderView(ViewSize=[700, 600])
    display = simple.Show(simple.OutputPort(incidence, 1), view)
    simple.ColorBy(display, ("CELLS", "OnBoundary"))
    display.Opacity = 0.6
    lines = simple.Show(simple.OutputPort(incidence, 0), view)
    lines.LineWidth = 3
    simple.ResetCamera(view)
    simple.SaveScreenshot(str(OUTPUT / "mixed.png"), view)


OUTPUT.mkdir(parents=True, exist_ok=True)
(OUTPUT / "mixed.cmesh").write_text(HEADER)
reader = simple.OpenDataFile(str(OUTPUT / "mixed.cmesh"))
assert reader.GetXMLName() == "CombinatorialMeshReader", reader.GetXMLName()
check_incidence(reader)
check_map(reader)
check_cutaway(reader)
check_file(reader)
check_picture(reader)
