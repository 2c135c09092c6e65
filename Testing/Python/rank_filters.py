"""Each filter of the plugin on this rank's part of its small data, saved to FOLDER/<ranks>.<rank>.json.

Run by `mpirun -np N pvbatch --sym rank_filters.py FOLDER LAYOUT [NAMES]`; EveryFilterOnRanks.py
compares. LAYOUT: 'first', all data on the first rank and empty data of the type on the others, as
readers of one file leave it; 'pieces', cells and atoms dealt out, as distributed data come. Images are
read from a file by each, as far as its filter asks. 'blocks', two of them on the first rank, which
the others lack.
"""

import json
import sys
from pathlib import Path

import numpy
from paraview import servermanager
from paraview.simple import PVTrivialProducer, XMLImageDataReader
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkParallelCore import vtkMultiProcessController

import robustness_trials
from good_data import COARSE, INPUTS, add, filters, sound

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def reader_of(data, name):
    """A reader of the image: it gives each rank the nodes that it is asked for."""
    file = Path(sys.argv[1]) / f"{name}.{RANKS}.{RANK}.vti"
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(data)
    writer.SetFileName(str(file))
    writer.Write()
    return XMLImageDataReader(FileName=[str(file)])


def cells_of(data):
    """The cells whose number is in this rank's share, with the points they use."""
    count = data.GetNumberOfCells()
    owner = numpy.arange(count) * RANKS // max(count, 1)
    marked = data.NewInstance()
    marked.ShallowCopy(data)
    add(marked.GetCellData(), "Owner", owner.astype(float))
    mine = vtkThreshold()
    mine.SetInputData(marked)
    mine.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "Owner")
    mine.SetLowerThreshold(RANK - 0.5)
    mine.SetUpperThreshold(RANK + 0.5)
    last = mine
    if data.IsA("vtkPolyData"):
        last = vtkGeometryFilter()
        last.SetInputConnection(mine.GetOutputPort())
    last.Update()
    result = last.GetOutput()
    result.GetCellData().RemoveArray("Owner")
    return result


def points_of(data):
    """Points without cells (atoms): this rank's share of them."""
    count = data.GetNumberOfPoints()
    mine = numpy.arange(count) * RANKS // count == RANK
    result = vtkPolyData()
    points = data.GetPoints().NewInstance()
    points.SetDataType(data.GetPoints().GetDataType())
    for i in numpy.flatnonzero(mine):
        points.InsertNextPoint(data.GetPoint(i))
    result.SetPoints(points)
    arrays = data.GetPointData()
    for k in range(arrays.GetNumberOfArrays()):
        add(result.GetPointData(), arrays.GetArrayName(k), vtk_to_numpy(arrays.GetArray(k))[mine])
    return result


def part(data, layout):
    """This rank's part of `data`."""
    if layout == "blocks" and data.IsA("vtkDataSet"):
        blocks = vtkMultiBlockDataSet()
        blocks.SetNumberOfBlocks(2)
        for block in range(2 if RANK == 0 else 0):
            blocks.SetBlock(block, data)
        return blocks
    if RANKS == 1:
        return data
    if layout == "first" or not data.IsA("vtkPointSet"):
        return data if RANK == 0 else data.NewInstance()
    return cells_of(data) if data.GetNumberOfCells() else points_of(data)


def source_of(data, layout, name):
    if data.IsA("vtkImageData") and layout != "blocks":
        return reader_of(data, name)
    source = PVTrivialProducer()
    source.GetClientSideObject().SetOutput(part(data, layout))
    source.UpdatePipeline()
    return source


def leaves(data):
    if data is None:
        return []
    if hasattr(data, "NewIterator"):
        iterator, found = data.NewIterator(), []
        while not iterator.IsDoneWithTraversal():
            found += leaves(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        return found
    return [data]


def ranges(data):
    """{association.name: [least, greatest]} of the numbers in `data`."""
    found = {}
    sets = {"row": data.GetRowData()} if data.IsA("vtkTable") else {
        "point": data.GetPointData(), "cell": data.GetCellData()} if data.IsA("vtkDataSet") else {}
    for association, arrays in sets.items():
        for k in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(k)
            if array is None or array.GetNumberOfTuples() == 0 or array.GetName() == "vtkGhostType":
                continue
            values = vtk_to_numpy(array)
            if numpy.isfinite(values).any():
                found[f"{association}.{array.GetName()}"] = [
                    float(numpy.nanmin(values)), float(numpy.nanmax(values))]
    return found


def parts_of(leaf):
    """How many cells, atoms, rows, or nothing but points; pieces of a surface share points."""
    cells = sum(leaf.GetNumberOfElements(kind) for kind in (
        vtkDataObject.CELL, vtkDataObject.VERTEX, vtkDataObject.ROW))
    return cells or leaf.GetNumberOfElements(vtkDataObject.POINT)


def summary(output):
    """Numbers of one output on this rank: bounds, ranges, and how much there is."""
    found = {"bounds": None, "ranges": {}, "size": sum(parts_of(leaf) for leaf in leaves(output)),
             "type": output.GetClassName() if output else ""}
    for leaf in leaves(output):
        if leaf.IsA("vtkDataSet") and leaf.GetNumberOfPoints():
            low, high = leaf.GetBounds()[0::2], leaf.GetBounds()[1::2]
            if found["bounds"]:
                low = [min(a, b) for a, b in zip(low, found["bounds"][0])]
                high = [max(a, b) for a, b in zip(high, found["bounds"][1])]
            found["bounds"] = [list(low), list(high)]
        for name, (least, greatest) in ranges(leaf).items():
            old = found["ranges"].get(name, [least, greatest])
            found["ranges"][name] = [min(least, old[0]), max(greatest, old[1])]
    return found


def run(name, layout):
    inputs = {port: source_of(sound(name, port, accepted[0]), layout, f"{name}.{port}")
              for port, accepted, _ in INPUTS[name]}
    proxy = getattr(servermanager.filters, name)(**inputs, **COARSE.get(name, {}))
    if proxy.GetProperty("Level"):
        proxy.Level = 0.4  # of the ball of density
    proxy.UpdateVTKObjects()
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    outputs = [summary(algorithm.GetOutputDataObject(port))
               for port in range(algorithm.GetNumberOfOutputPorts())]
    return {"errors": listener.errors, "outputs": outputs}


def main(folder, layout, names):
    found = {}
    for name in names or filters():
        (folder / f"{RANKS}.{RANK}.now").write_text(name)  # of whoever hangs
        found[name] = run(name, layout)
    (folder / f"{RANKS}.{RANK}.json").write_text(json.dumps(found))


main(Path(sys.argv[1]), sys.argv[2], sys.argv[3:])
