"""What filters of surfaces make of a contour in pieces, saved to FOLDER/<ranks>.<rank>.json.

Run by `mpirun -np N pvbatch --sym rank_surfaces.py FOLDER`; Ranks.py compares.
"""

import json
import sys
from pathlib import Path

from paraview import simple
from vtkmodules.vtkCommonCore import VTK_STRING
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def area_and_bounds(data):
    if not data or not data.GetNumberOfPoints() or not data.IsA("vtkPolyData"):
        return 0.0, None
    triangles = vtkTriangleFilter()
    triangles.SetInputData(data)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    properties = vtkMassProperties()
    properties.SetInputConnection(triangles.GetOutputPort())
    triangles.Update()
    if not triangles.GetOutput().GetNumberOfPolys():
        return 0.0, None
    properties.Update()
    return properties.GetSurfaceArea(), list(data.GetBounds())


def table_of(table):
    if not table or not table.IsA("vtkTable") or table.GetNumberOfRows() == 0:
        return {}
    return {table.GetColumnName(c): table.GetValue(0, c).ToDouble()
            for c in range(table.GetNumberOfColumns())}


def counts_of(table):
    column = table.GetColumnByName("Count") if table and table.IsA("vtkTable") else None
    return [column.GetValue(row) for row in range(column.GetNumberOfTuples())] if column else []


def result(proxy):
    algorithm = proxy.GetClientSideObject()
    errors = []

    def keep(_, __, sentence):
        errors.append(sentence)

    keep.CallDataType = VTK_STRING
    algorithm.AddObserver("ErrorEvent", keep)
    algorithm.AddObserver("WarningEvent", lambda *_: None)
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    proxy.UpdatePipeline()
    first = algorithm.GetOutputDataObject(0)
    last = algorithm.GetOutputDataObject(algorithm.GetNumberOfOutputPorts() - 1)
    area, _ = area_and_bounds(first)
    nodes = 0
    if first.IsA("vtkImageData"):
        inside = first.GetPointData().GetArray("Inside")
        nodes = sum(inside.GetValue(i) for i in range(inside.GetNumberOfTuples())) if inside else 0
    return {"errors": errors, "area": area, "table": table_of(last), "inside": nodes,
            "quality": counts_of(last),
            "points": first.GetNumberOfPoints(), "cells": first.GetNumberOfCells()}


def main(folder):
    controller = vtkMultiProcessController.GetGlobalController()
    wavelet = simple.Wavelet(WholeExtent=[-10, 10, -10, 10, -10, 10])
    field = simple.Calculator(Input=wavelet, Function="36-coordsX^2-coordsY^2-coordsZ^2",
                              ResultArrayName="Ball", ResultArrayType="Double")
    contour = simple.Contour(Input=field, ContourBy=["POINTS", "Ball"], Isosurfaces=[0.5],
                             ComputeNormals=0, ComputeScalars=0)
    # Renamed in ParaView 5.12.
    add_ghosts = simple.GhostCells if hasattr(simple, "GhostCells") else simple.GhostCellsGenerator
    ghosts = add_ghosts(Input=contour, BuildIfRequired=0)
    proxies = {}
    for name, surface in (("pieces", contour), ("ghosts", ghosts)):
        proxies[f"SurfaceMeasures, {name}"] = simple.SurfaceMeasures(Input=surface)
        proxies[f"OffsetSurface, {name}"] = simple.OffsetSurface(
            Input=surface, Distance=1.0, Resolution=32, Side="Both")
        proxies[f"SurfaceToGrid, {name}"] = simple.SurfaceToGrid(Input=surface)
        proxies[f"SurfaceCurvature, {name}"] = simple.SurfaceCurvature(Input=surface)
        proxies[f"SurfaceRemesh, {name}"] = simple.SurfaceRemesh(Input=surface)
        proxies[f"MeshQualityReport, {name}"] = simple.MeshQualityReport(Input=surface)
    proxies["SurfaceToGrid, given"] = simple.SurfaceToGrid(Input=contour, Grid=wavelet)
    proxies["SurfaceMeasures, volume"] = simple.SurfaceMeasures(
        Input=field, Scalars=["POINTS", "Ball"])
    proxies["DelaunayIsosurface"] = simple.DelaunayIsosurface(
        Input=field, Scalars=["POINTS", "Ball"], Level=0.5)
    found = {name: result(proxy) for name, proxy in proxies.items()}
    name = f"{controller.GetNumberOfProcesses()}.{controller.GetLocalProcessId()}.json"
    (folder / name).write_text(json.dumps(found))


main(Path(sys.argv[1]))
