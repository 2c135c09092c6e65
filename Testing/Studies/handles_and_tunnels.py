"""Compares the handles and tunnels of Choking Loops with the basis tunnels of MeshLib.

Usage: pvpython handles_and_tunnels.py FOLDER --meshlib PYTHON [--names NAME ...]

FOLDER contains closed surfaces (the shared data surfaces). --meshlib: a Python interpreter that has the PyPI
package meshlib (its own licence; a peer of this study, not a dependency). Its detectBasisTunnels gives 2 loops for
each unit of genus that are independent, with the edge length as metric, the shortest that it offers; it does not
say on which side a loop bounds. Choking Loops gives as many handles (which bound inside) as tunnels (outside).
Each row: genus by the Euler number, numbers of loops, their total length, CPU seconds. Prints Markdown.
"""

import argparse
import json
import subprocess
import time
from pathlib import Path

import study_paths  # noqa: F401 (before isthmus)
import isthmus
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataConnectivityFilter, vtkTriangleFilter

MESHLIB = """
import json, sys, time
import meshlib.mrmeshpy as mesh
surface = mesh.loadMesh(sys.argv[1])
start = time.process_time()
loops = mesh.detectBasisTunnels(mesh.MeshPart(surface), mesh.edgeLengthMetric(surface))
seconds = time.process_time() - start
lengths = [sum((surface.destPnt(e) - surface.orgPnt(e)).length() for e in loop) for loop in loops]
print(json.dumps([len(lengths), sum(lengths), seconds]))
"""


def genus_of(surface):
    """Of a closed manifold; None for anything else."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    parts = vtkPolyDataConnectivityFilter()
    parts.SetInputData(surface)
    parts.SetExtractionModeToAllRegions()
    parts.Update()
    if edges.GetOutput().GetNumberOfCells() > 0:
        return None
    euler = surface.GetNumberOfPoints() - surface.GetNumberOfPolys() // 2
    return (2 * parts.GetNumberOfExtractedRegions() - euler) // 2


def read(path):
    surface = isthmus.read(str(path))
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.PassLinesOff()
    triangles.PassVertsOff()
    triangles.Update()
    return triangles.GetOutput()


def by_isthmus(surface):
    """Handles, tunnels, total length, seconds."""
    loops = isthmus.vtkChokingLoops()
    loops.SetInputData(surface)
    loops.SetIncludeBottlenecks(False)
    start = time.process_time()
    loops.Update()
    seconds = time.process_time() - start
    cells = loops.GetOutput().GetCellData()
    kinds = vtk_to_numpy(cells.GetArray("Kind"))
    return (kinds == 0).sum(), (kinds == 1).sum(), vtk_to_numpy(cells.GetArray("Length")).sum(), seconds


def by_meshlib(python, path):
    result = subprocess.run([python, "-c", MESHLIB, str(path)], capture_output=True, text=True, timeout=600)
    return json.loads(result.stdout.splitlines()[-1]) if result.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--meshlib", required=True)
    parser.add_argument("--names", nargs="*")
    options = parser.parse_args()
    print("| surface | triangles | genus | handles, tunnels | MeshLib's loops | total length | MeshLib's | "
          "seconds | MeshLib's |")
    print("|---|---|---|---|---|---|---|---|---|")
    for path in sorted(options.folder.iterdir()):
        if path.suffix not in (".off", ".obj", ".stl", ".ply") or (options.names and path.stem not in options.names):
            continue
        surface = read(path)
        genus = genus_of(surface) if surface and surface.GetNumberOfPolys() else None
        if not genus:
            continue
        handles, tunnels, length, seconds = by_isthmus(surface)
        peer = by_meshlib(options.meshlib, path)
        number, other, quick = peer or ("fails", float("nan"), float("nan"))
        print(f"| {path.stem} | {surface.GetNumberOfPolys()} | {genus} | {handles}, {tunnels} | {number} | {length:.4g} "
              f"| {other:.4g} | {seconds:.2f} | {quick:.3f} |", flush=True)


if __name__ == "__main__":
    main()
