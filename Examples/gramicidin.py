"""Gramicidin A (1GRM) with charges on its backbone, for tests and examples of ion transport."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

# Amides as in CHARMM's parameter set 19 (B. R. Brooks et al., J. Comput. Chem. 4 (1983) 187): united
# carbons, hydrogen on the nitrogen. Side chains are neutral and left without.
CHARGES = {"N": -0.35, "H": 0.25, "CA": 0.10, "C": 0.55, "O": -0.55}
# United atoms have their hydrogens' room: S. J. Weiner et al., J. Am. Chem. Soc. 106 (1984) 765, one
# radius for each element, as the filters have them for files without hydrogens.
RADII = {"C": 1.85, "N": 1.75, "O": 1.65, "H": 1.00}
ELEMENTS = {"H": 1, "C": 6, "N": 7, "O": 8}
AXIS = (0.0, 1.0, 0.0)  # of the file's frame, along the pore


def with_charges(atoms):
    """vtkPolyData of points with Charge, Radius and Element: what the reader's output `atoms` has, and the amides'
    hydrogens."""
    places = vtk_to_numpy(atoms.GetPoints().GetData()).astype(float)
    data = atoms.GetPointData()

    def texts(name):
        array = data.GetAbstractArray(name)
        return [array.GetValue(i) for i in range(array.GetNumberOfTuples())]

    names, residues, chains, numbers = (texts(name) for name in ("AtomName", "ResidueName", "Chain", "ResidueId"))
    names = [name.strip() for name in names]
    at = {(chain, number, name): i for i, (chain, number, name) in enumerate(zip(chains, numbers, names))}
    points, charges, radii, elements = [], [], [], []

    def put(place, charge, element):
        points.append(place)
        charges.append(charge)
        radii.append(RADII[element])
        elements.append(ELEMENTS[element])

    for i, name in enumerate(names):
        of_backbone = name in CHARGES and not (residues[i].strip() == "ETA" and name == "O")
        if residues[i].strip() == "FOR" or of_backbone:
            put(places[i], CHARGES[name], name[0])
        else:
            put(places[i], 0.0, name[0])
        before = at.get((chains[i], numbers[i] - 1, "C"))
        own = at.get((chains[i], numbers[i], "CA"))
        if name == "N" and before is not None and own is not None:
            units = [(places[j] - places[i]) / numpy.linalg.norm(places[j] - places[i]) for j in (before, own)]
            out = -(units[0] + units[1])
            put(places[i] + out / numpy.linalg.norm(out), CHARGES["H"], "H")
    result = vtkPolyData()
    result.SetPoints(vtkPoints())
    result.GetPoints().SetDataTypeToDouble()
    result.GetPoints().SetData(numpy_to_vtk(numpy.array(points), deep=True))
    for name, values in (("Charge", charges), ("Radius", radii), ("Element", elements)):
        array = numpy_to_vtk(numpy.array(values), deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    return result
