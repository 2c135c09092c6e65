"""Data of blocks, of levels, and of other kinds on every input of every filter of the plugin.

Through the server manager, which asks no domain. Each must come back: a result for each block, or
an error event, a sentence and an empty output. What is sound in one piece must give the same in a
multiblock of one.
"""

import sys

from vtkmodules.vtkCommonDataModel import (
    vtkHyperTreeGrid, vtkMultiBlockDataSet, vtkMutableDirectedGraph, vtkOverlappingAMR,
    vtkAMRBox, vtkPartitionedDataSet, vtkPartitionedDataSetCollection, vtkTable, vtkUniformGrid)
from vtkmodules.vtkCommonCore import vtkDoubleArray

import robustness_trials
from good_data import INPUTS, filters, image, made, sound


def multiblock(*blocks):
    data = vtkMultiBlockDataSet()
    for i, block in enumerate(blocks):
        data.SetBlock(i, block)
    return data


def partitioned(*blocks):
    data = vtkPartitionedDataSet()
    for i, block in enumerate(blocks):
        data.SetPartition(i, block)
    return data


def collection(*blocks):
    data = vtkPartitionedDataSetCollection()
    for i, block in enumerate(blocks):
        data.SetPartition(i, 0, block)
    return data


def amr():
    """Two levels, the ball of density on each."""
    data = vtkOverlappingAMR()
    data.Initialize(2, [1, 1])
    data.SetGridDescription(3)
    data.SetOrigin([-5.5] * 3)
    for level in range(2):
        grid = vtkUniformGrid()
        grid.ShallowCopy(image())
        spacing = 1.0 / (1 + level)
        grid.SetSpacing([spacing] * 3)
        data.SetSpacing(level, [spacing] * 3)
        data.SetAMRBox(level, 0, vtkAMRBox([0, 0, 0], [10, 10, 10]))
        data.SetDataSet(level, 0, grid)
    return data


def table():
    data, column = vtkTable(), vtkDoubleArray()
    column.SetName("Density")
    column.InsertNextValue(1.0)
    data.AddColumn(column)
    return data


def graph():
    data = vtkMutableDirectedGraph()
    data.AddVertex()
    return data


def hyper_tree_grid():
    data = vtkHyperTreeGrid()
    data.Initialize()
    data.SetDimensions([2, 2, 2])
    return data


def cases(block):
    """{name: data} with `block()` in what can hold it."""
    return {
        "multiblock": lambda: multiblock(block(), block()),
        "multiblock of one": lambda: multiblock(block()),
        "multiblock with a hole": lambda: multiblock(None, block()),
        "multiblock in a multiblock": lambda: multiblock(multiblock(block()), block()),
        "multiblock of nothing": vtkMultiBlockDataSet,
        "multiblock of a block of another kind": lambda: multiblock(table(), image(), block()),
        "partitioned": lambda: partitioned(block(), block()),
        "collection": lambda: collection(block(), block()),
        "AMR": amr,
        "table": table,
        "graph": graph,
        "hyper tree grid": hyper_tree_grid,
        "nothing in it": lambda: type(block())(),
    }


def outcome(proxy):
    """('result' or 'refused', elements of port 0) or a complaint."""
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.SMProxy.UpdatePipeline()
    # What a window asks for next, and what goes through ParaView's own filters behind ours.
    proxy.GetDataInformation()
    output = algorithm.GetOutputDataObject(0)
    size = robustness_trials.size_of(output)
    return ("refused" if listener.errors else "result"), size, listener.errors


def trial(name, kind, port, make):
    return "%s %d %s" % outcome(made(name, kind, {port: make()}, optional=port != INPUTS[name][0][0]))


def plain_size(name, kind):
    word, said, _ = robustness_trials.run(
        lambda: outcome(made(name, kind, optional=False))[1], seconds=60)
    assert word == "done", (name, kind, said)
    return int(said)


def sweep(part):
    counts, complaints = {"result": 0, "refused": 0}, []
    for name in filters():
        if part not in name:
            continue
        for port, accepted, _ in INPUTS[name]:
            for kind in accepted:
                sizes = {}
                for case, make in cases(lambda: sound(name, port, kind)).items():
                    word, said, took = robustness_trials.run(
                        lambda: trial(name, kind, port, make), seconds=60)
                    if word != "done":
                        complaints.append(f"{name}.{port}({kind}), {case}: {word}: {said[-500:]}")
                        print(complaints[-1], flush=True)
                        continue
                    what, size, _ = said.split(" ", 2)
                    counts[what] += 1
                    sizes[case] = int(size)
                if port != INPUTS[name][0][0]:
                    continue
                plain = plain_size(name, kind)
                for case, blocks in (("multiblock of one", 1), ("multiblock", 2),
                                     ("multiblock with a hole", 1), ("partitioned", 2)):
                    if case in sizes and sizes[case] not in (0, blocks * plain):
                        complaints.append(f"{name}.{port}({kind}), {case}: {sizes[case]} elements, "
                                          f"not {blocks} times {plain}")
                        print(complaints[-1], flush=True)
    return counts, complaints


if __name__ == "__main__":
    part_of_name = sys.argv[1] if len(sys.argv) > 1 else ""
    counted, wrong = sweep(part_of_name)
    print(counted)
    assert not wrong, f"{len(wrong)} trials went wrong"
    assert part_of_name or counted["result"] > 100
