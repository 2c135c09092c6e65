"""Molecules of bug reports through the filters: broken at the box, without side chains, and those of which pdb2pqr
loses atoms."""

import shutil

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow

from shared_data import shared_data

said = []


def opened(name, **properties):
    source = simple.OpenDataFile(str(shared_data(f"reports/{name}")))
    for key, value in properties.items():
        setattr(source, key, value)
    source.UpdatePipeline()
    return source


def texts(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return " ".join(array.GetValue(i) for i in range(array.GetNumberOfValues())) if array else ""


class Listener:
    """Warnings while it is there."""

    def __enter__(self):
        said.clear()
        self.tag = vtkOutputWindow.GetInstance().AddObserver("WarningEvent", self.take)
        vtkOutputWindow.GetInstance().AddObserver("ErrorEvent", self.take)
        return said

    def take(self, caller, event, text=""):
        said.append(text)

    take.CallDataType = "string0"

    def __exit__(self, *_):
        vtkOutputWindow.GetInstance().RemoveObserver(self.tag)


def rows(filtered, port):
    return servermanager.Fetch(filtered, idx=port).GetNumberOfRows()


# Broken at the box: the pores and pockets of the whole molecule.
counts = []
for name in ("m01c_whole.gro", "m01_wrapped.gro"):
    atoms = opened(name)
    pores = simple.PoreProfile(Input=atoms)
    pores.UpdatePipeline()
    pockets = simple.MolecularPockets(Input=atoms)
    pockets.UpdatePipeline()
    counts.append((rows(pores, 1), rows(pockets, 1)))
print("pores and pockets", counts)
assert counts[0] == counts[1] and counts[0][0] > 0, counts

# Without side chains there is a warning of each filter, and none otherwise.
bare, whole = opened("i03_ca_only.pdb"), simple.OpenDataFile(str(shared_data("molecules/2LYZ.pdb")))
filters = {"MolecularPockets": {}, "PoreProfile": {}, "MolecularFlowSurface": {"Spacing": 1.5},
           "MolecularDensity": {"Spacing": 2.0}}
for name, properties in filters.items():
    for source, expected in ((bare, 1), (whole, 0)):
        with Listener() as warnings:
            simple.__dict__[name](Input=source, **properties).UpdatePipeline()
        found = [text for text in warnings if "Side chains or bases are missing" in text]
        assert len(found) == expected, (name, warnings)
        assert not found or "only C-alpha of 129 of 129" in found[0], found

# Predicted models: residues of low confidence, left out on request, and a warning where the first site has them.
predicted = simple.OpenDataFile(str(shared_data("molecules/2LYZ.pdb")))
for low, minimum, expected in ((0, 0.0, False), (129, 0.0, True), (129, 60.0, False)):
    confidence = simple.PythonCalculator(
        Input=predicted, ArrayName="pLDDT", ArrayAssociation="Point Data",
        Expression=f"numpy.where((ResidueId <= {low}) & (ResidueId > 20), 40.0, 90.0)")
    for name in ("MolecularPockets", "PoreProfile"):
        with Listener() as warnings:
            filtered = simple.__dict__[name](Input=confidence, MinimumConfidence=minimum)
            filtered.UpdatePipeline()
        found = [text for text in warnings if "low confidence (pLDDT below 70)" in text]
        hollow = name == "PoreProfile" and rows(filtered, 2) == 0
        assert bool(found) == (expected and not hollow), (name, low, minimum, list(warnings))
        notes = texts(servermanager.Fetch(filtered), "Notes")
        assert ("below 60, left out" in notes) == (minimum > 0), (name, notes)

# Charges: what comes back is what went in.
if not shutil.which("pdb2pqr") and not shutil.which("pdb2pqr30"):
    raise SystemExit("pdb2pqr is not installed")


def charged(name):
    source = opened(name)
    with Listener() as warnings:
        filtered = simple.ForceFieldCharges(Input=source)
        filtered.UpdatePipeline()
    data = servermanager.Fetch(filtered)
    elements = vtk_to_numpy(data.GetPointData().GetArray("Element"))
    charge = vtk_to_numpy(data.GetPointData().GetArray("Charge")).sum()
    return int((elements > 1).sum()), charge, " ".join(warnings), texts(data, "Notes")


heavy, charge, warned, notes = charged("r11_same_chain_TER.pdb")
assert heavy == 478 and abs(charge - 6.0) < 1e-3, (heavy, charge, warned)
heavy, charge, warned, notes = charged("q02_rna_5phosphate.pdb")
assert heavy == 389 and abs(charge + 18.0) < 1e-3 and not warned, (heavy, charge, warned)
assert "phosphate at the 5' end, G 2 R" in notes, notes
heavy, charge, warned, notes = charged("v01_HT2.pdb")
assert "HT2 of LEU 129 A" in notes, notes
assert abs(charge - 8.0) < 1e-3 and not warned, (charge, warned)
