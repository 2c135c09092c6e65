"""The six pipelines on every shared map, protein and closed surface: a table, and no failure without
a sentence. First looks by numbers: with default colours at least 90 % of the area lies inside the
range, whose end is at most twice the larger quantile.

Usage of its own: pvpython Pipelines.py [all]. Without `all`, a part of the data that takes a minute.
"""

import os
import sys
import time

import numpy
from paraview import servermanager, simple
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

MAPS = (
    "emd_5043.map", "emd_1832.map", "emd_1703.map", "1ake.mrc", "tiny1.map", "gorgon_groel_skeleton.mrc",
    "emd_5170.map", "emd_1155.ccp4", "EMD-3001.map.bz2", "EMD-3197.map", "1mru.map", "1mru_m0.map",
    "1oel_10.mrc", "1tyq_10.mrc", "3pqr.ccp4.gz", "3pqr-mode0.ccp4", "D7.ccp4", "Ubi-8.5.mrc",
    "beta-tubulin.mrc", "clean70SRibosome_vol_65p.mrc", "gorgon_groel_densityMap.mrc",
    "h2o-elf-nstart.ccp4", "mergeable_1.map", "merged_mask.mrc", "pymol_web_map_bigendian.ccp4")
PROTEINS = (
    "1AJJ_pH7_PARSE.pqr", "1crn_apbs.pqr", "1ubq.pdb", "1hew/1hew.pqr", "1FAS.cif", "1UBI.pdb",
    "1a1p.pdb", "1AJJ.pdb", "1AJJ_pH2_CHARMM.pqr", "1AJJ_pH7_AMBER.pqr", "1hew.pdb", "2LYZ.pdb",
    "4pti.pdb", "1oel_A.pdb", "pdb1ake.pdb", "2kix.pdb")
SURFACES = ("torus.obj", "72214.stl", "697224__sf.obj", "conrod.stl")
FEW = {"map": 6, "protein": 3, "surface": 2}
EVERYTHING = "all" in sys.argv[1:]


def genus_and_components(proxy):
    """Of the first surface among what a pipeline gave."""
    measures = simple.SurfaceMeasures(Input=proxy)
    measures.UpdatePipeline()
    field = servermanager.Fetch(measures).GetFieldData()
    names = {field.GetArrayName(i): i for i in range(field.GetNumberOfArrays())}
    found = []
    for name in ("NumberOfComponents", "Components", "Genus"):
        if name in names and field.GetArray(names[name]) is not None:
            found.append("%s %g" % (name, field.GetArray(names[name]).GetValue(0)))
    simple.Delete(measures)
    return ", ".join(found)


def weights_of(surface):
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corner = points[triangles]
    areas = numpy.linalg.norm(
        numpy.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]), axis=1)
    return numpy.bincount(triangles.ravel(), numpy.repeat(areas, 3), minlength=len(points))


def check_first_look(proxy, arrays, label):
    """Share of the area inside of the range that the window would show, by numpy."""
    surface = servermanager.Fetch(proxy)
    weights = weights_of(surface)
    said = []
    for array in arrays:
        limits = pipelines.colour_range(proxy, "POINTS", array)
        assert limits, f"{label}: no range for {array}"
        if array in pipelines.FIXED:
            assert limits == pipelines.FIXED[array]
            continue
        values = vtk_to_numpy(surface.GetPointData().GetArray(array)).astype(float)
        counts = numpy.isfinite(values) & (weights > 0)
        valid = surface.GetPointData().GetArray("CurvatureValid")
        if valid is not None:
            counts &= vtk_to_numpy(valid) != 0
        order = numpy.argsort(values[counts])
        sums = numpy.cumsum(weights[counts][order])
        ends = [values[counts][order][min(numpy.searchsorted(sums, q * sums[-1]), len(order) - 1)]
                for q in (0.02, 0.98)]
        inside = (values[counts] >= limits[0]) & (values[counts] <= limits[1])
        share = weights[counts][inside].sum() / weights[counts].sum()
        assert share >= 0.9, f"{label}: only {share:.2f} of the area is in the range of {array}"
        assert max(map(abs, ends)) >= 0.5 * limits[1], f"{label}: {array} {ends} {limits}"
        assert limits[0] == -limits[1]
        said.append(f"{array} {100 * share:.0f} %")
    return ", ".join(said)


def run(function, folder, name):
    label = f"{function} {name}"
    started = time.monotonic()
    source = simple.OpenDataFile(str(shared_data(f"{folder}/{name}")))
    assert source is not None, f"{name}: no reader"
    try:
        proxies = getattr(pipelines, function)(source)
    except ValueError as refusal:
        print(f"{label:52} {time.monotonic() - started:6.1f} s  refused: {refusal}", flush=True)
        assert len(str(refusal)) > 30, "a refusal is a sentence with a way out"
        return False
    facts = []
    if function != "protein_to_sites":
        first = (source if function == "surface_to_loops" else
                 proxies[-1] if function == "protein_to_surface" else proxies[0])
        facts.append(genus_and_components(first))
    if function == "map_to_curvature":
        facts.append(check_first_look(proxies[-1], pipelines.CURVATURES, label))
    if function == "protein_to_sites":
        sites = proxies[-1]
        facts.append(check_first_look(
            sites.Input, pipelines.CURVATURES + ("Potential", "PolarizedCurvature"), label))
    if function.endswith("loops"):
        facts.append("%d loops" % proxies[-1].GetDataInformation().GetNumberOfCells())
    print(f"{label:52} {time.monotonic() - started:6.1f} s  {'; '.join(filter(None, facts))}", flush=True)
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    return True


def part(names, kind):
    return names if EVERYTHING else names[:FEW[kind]]


passed = []
for name in part(MAPS, "map"):
    for function in ("map_to_surface", "map_to_curvature", "map_to_loops"):
        passed.append(run(function, "maps", name))
for name in part(PROTEINS, "protein"):
    for function in ("protein_to_surface", "protein_to_sites"):
        passed.append(run(function, "molecules", name))
for name in part(SURFACES, "surface"):
    passed.append(run("surface_to_loops", "surfaces", name))
print(f"{sum(passed)} of {len(passed)} passed, the others were refused with a sentence")
assert sum(passed) > 0.6 * len(passed)
