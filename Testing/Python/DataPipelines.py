"""Pipelines on data give what those of proxies give, number by number: one table of steps (isthmus/steps.py)."""
from paraview import servermanager, simple

import isthmus
from isthmus import pipelines
from shared_data import shared_data

MAP, MOLECULE, CHARGED = [str(shared_data(name)) for name in (
    "maps/emd_1832.map", "molecules/1UBI.pdb", "molecules/1crn_apbs.pqr")]


def fetched(source, port=0):
    if port:
        return servermanager.Fetch(source, idx=port)
    return servermanager.Fetch(source)


def values(attributes, name):
    array = attributes.GetArray(name)
    return [array.GetComponent(i, 0) for i in range(array.GetNumberOfTuples())]


def check_loops():
    surface, loops = pipelines.map_to_loops(simple.OpenDataFile(MAP))
    loops.UpdatePipeline()
    made = isthmus.map_to_loops(MAP)
    assert made.surface.GetNumberOfCells() == fetched(surface).GetNumberOfCells()
    for name in ("Radius", "Persistence", "Length", "Kind"):
        assert values(made.loops.GetCellData(), name) == values(fetched(loops).GetCellData(), name), name


def check_curvature():
    curvature = fetched(pipelines.map_to_curvature(simple.OpenDataFile(MAP))[-1])
    made = isthmus.map_to_curvature(MAP).curvature
    for one, other in zip(values(made.GetPointData(), "MeanCurvature"),
                          values(curvature.GetPointData(), "MeanCurvature")):
        assert one == other or (one != one and other != other)


def check_pockets():
    residues, pockets = pipelines.protein_to_pockets(simple.OpenDataFile(MOLECULE))
    made = isthmus.protein_to_pockets(MOLECULE)
    assert made.residues.GetNumberOfPoints() == residues.GetDataInformation().GetNumberOfPoints()
    assert values(made.ranking.GetRowData(), "Volume") == values(fetched(pockets, 1).GetRowData(), "Volume")


def check_potential():
    sites = fetched(pipelines.protein_to_sites(simple.OpenDataFile(CHARGED))[-1])
    made = isthmus.protein_to_potential(CHARGED).surface
    for name in ("Potential", "PolarizedCurvature", "BindingSite"):
        one, other = values(made.GetPointData(), name), values(sites.GetPointData(), name)
        assert len(one) == len(other) > 1000 and all(
            a == b or (a != a and b != b) for a, b in zip(one, other)), name


for check in (check_loops, check_curvature, check_pockets, check_potential):
    check()
    print(check.__name__, flush=True)
