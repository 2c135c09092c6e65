"""Compares Surface Curvature with PyCurv on PyCurv's own test surfaces, beside its published results.

Usage: pvpython membrane_curvature.py FOLDER

FOLDER is pycurv_testing/test_vector_voting_output of the public repository kalemaria/pycurv: a sphere, a torus, a
cylinder with open ends, a plane with noise, and spheres of voxels, with the curvatures that its three algorithms
(RVV, AVV, SSVV) and VTK gave at each triangle, and the time that they took on ten cores.

Surface Curvature: the normal fit, with the automatic radius (three edges), and with the radius that gives the least error on
the same surface, of 2.5, 5, 8, 10, 15 and 28 (PyCurv's radii were chosen in this way as well). Each row: relative error of the larger principal curvature, mean and 95 % quantile (for the plane, the absolute value
of the curvature); the same of the smaller one (absolute on cylinder and torus); CPU time. Points of the border are included. Prints Markdown.
"""

import argparse
import csv
import re
import time
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import study_paths  # noqa: F401 (before isthmus)
import isthmus

RADII = (2.5, 5.0, 8.0, 10.0, 15.0, 28.0)
SPHERE, TORUS, CYLINDER, PLANE = range(4)
# Folder, name, kind, radius, and the part of the published files' names before the algorithm.
SURFACES = (
    ("sphere/noise0", "sphere_r10", SPHERE, 10.0, "sphere_r10"),
    ("sphere/noise0", "sphere_r20", SPHERE, 20.0, "sphere_r20"),
    ("torus/noise0", "torus_rr25_csr10", TORUS, 10.0, "torus_rr25_csr10"),
    ("cylinder/noise0", "cylinder_r10_h25", CYLINDER, 10.0, "cylinder_r10_h25_eb0"),
    ("plane/res20_noise10", "plane_half_size20", PLANE, 1.0, "plane_half_size20"),
    ("sphere/voxel", "sphere_r10", SPHERE, 10.0, "sphere_r10"),
    ("sphere/voxel", "sphere_r30", SPHERE, 30.0, "sphere_r30"),
)


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def by_isthmus(surface, kind, size, radius):
    """Errors of both principal curvatures, and CPU time. The torus lies around z, with the radius 25."""
    curvature = isthmus.vtkSurfaceCurvature()
    curvature.SetInputData(surface)
    curvature.SetMethod(curvature.NormalFit)
    curvature.SetRadius(radius)
    start = time.process_time()
    curvature.Update()
    seconds = time.process_time() - start
    data = curvature.GetOutput().GetPointData()
    values = [vtk_to_numpy(data.GetArray(name)) for name in ("MaximumCurvature", "MinimumCurvature")]
    if values[0].mean() + values[1].mean() < 0.0:  # wound inwards
        values = [-values[1], -values[0]]
    valid = vtk_to_numpy(data.GetArray("CurvatureValid")) > 0
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    if kind == PLANE:
        errors = [abs(values[0]), abs(values[1])]
    else:
        errors = [abs(values[0] * size - 1.0), abs(values[1])]
        if kind == SPHERE:
            errors[1] = abs(values[1] * size - 1.0)
        elif kind == TORUS:
            cosine = (numpy.hypot(points[:, 0], points[:, 1]) - 25.0) / size
            errors[1] = abs(values[1] - cosine / (25.0 + size * cosine))
    return [error[valid] for error in errors], seconds


def published(path, kind):
    if kind == PLANE:  # the tables have errors of normals only
        data = read(path.with_suffix(".vtp")).GetCellData()
        return [abs(vtk_to_numpy(data.GetArray(name))) for name in ("kappa_1", "kappa_2")]
    names = ("kappa1RelErrors", "kappa2RelErrors" if kind == SPHERE else "kappa2AbsErrors")
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file, delimiter=";"))
    return [numpy.abs([float(row[name]) for row in rows]) for name in names]


def published_seconds(path):
    for log in (path.with_suffix(".log"), path.with_name(re.sub(r"[A-Z]+_rh28", "SSVV_RVV_rh28", path.stem) + ".log")):
        if log.exists():
            found = re.search(r"Whole method took: ([\d.]+) min ([\d.]+) s", log.read_text())
            return 60.0 * float(found[1]) + float(found[2])
    return None


def describe(errors):
    first, second = errors
    return (f"{first.mean():.4f}, {numpy.percentile(first, 95):.4f} | {second.mean():.4f}, "
            f"{numpy.percentile(second, 95):.4f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    options = parser.parse_args()
    print("| surface | method | larger curvature | smaller curvature | seconds |")
    print("|---|---|---|---|---|")
    for folder, name, kind, size, prefix in SURFACES:
        surface = read(options.folder / folder / f"{name}.surface.vtp")
        title = f"{folder.split('/')[1]} {name}"
        errors, seconds = by_isthmus(surface, kind, size, 0.0)
        print(f"| {title} | Isthmus, automatic | {describe(errors)} | {seconds:.2f} |")
        tried = [(radius, *by_isthmus(surface, kind, size, radius)) for radius in RADII]
        radius, errors, seconds = min(tried, key=lambda entry: sum(error.mean() for error in entry[1]))
        print(f"| {title} | Isthmus, radius {radius} | {describe(errors)} | {seconds:.2f} |")
        for path in sorted((options.folder / folder / "files4plotting").glob(f"{prefix}.*.csv")):
            if kind == PLANE and path.stem.endswith("VTK"):
                continue  # published without its curvature
            algorithm = path.stem[len(prefix) + 1:]
            took = published_seconds(path)
            print(f"| {title} | {'vtkCurvatures' if algorithm == 'VTK' else 'PyCurv ' + algorithm} | "
                  f"{describe(published(path, kind))} | {f'{took:.0f} on ten cores' if took else '-'} |")


if __name__ == "__main__":
    main()
