"""Every property of every filter does something: set to other sensible values, the output changes.

For each proxy of the panels (good_data.py finds them) and each property of numbers: up to three values
other than the default (the other entries of an enumeration, the other state of a check box, values
within its range), on small sound data. One of them must change what comes out: a point, a cell, an
array, a table's row. Where the panel shows a property under a condition only, that is met first; what
else a property needs stands in NEEDS. What changes nothing on purpose stands in SILENT with its
reason, and is told when that is no longer true.

    pvpython PropertyEffects.py [PART OF A PROXY'S NAME]
"""

import hashlib
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy

import robustness_trials
from good_data import filters, kinds, made, panels
from long_tests import TURN, share
from lively_data import inputs

SECONDS = 30.0
ION_TRANSPORT = ("IonTransport", "IonTransportOnSurface", "IonTransportMovingSurface")
# Properties that have to be set before this one can show itself: {(proxy, property): {name: value}}.
NEEDS = {
    ("HighOrderDiffusion", "LowerOrders"): {"Order": 1},
    **{("HandleFilling", name): {"FillHandlesBelow": 3.0} for name in ("Side", "SampleSpacing", "Thickness")},
    # Just below the saddle between the two balls: noise decides whether there is a bridge.
    **{("MapHandles", name): {"AutomaticLevel": 0, "Level": 0.155} for name in ("NumberOfResamples", "Seed")},
    ("MapSurface", "CloseAtBorder"): {"AutomaticLevel": 0, "Level": 0.02},
    ("ChokingLoops", "AlwaysIncludeHandles"): {"MaximumRadius": 1.0},
    ("ChokingLoops", "MaximumRadius"): {"AlwaysIncludeHandles": 0},
    ("ChokingLoops", "ThresholdMode"): {"MinimumPersistence": 60.0},
    ("PoissonBoltzmann", "IonRadius"): {"IonicStrength": 0.15},
    ("PoissonBoltzmann", "Nonlinear"): {"IonicStrength": 0.15},
    ("PoissonBoltzmannOnSurface", "IonRadius"): {"IonicStrength": 0.15},
    ("PoissonBoltzmannOnSurface", "Nonlinear"): {"IonicStrength": 0.15},
    ("ScalarRegions", "SweepTarget"): {"SweepSteps": 4},
    **{(name, "NormalCurvatureDirection"): {"OutputArrays": ["NormalCurvature"]}
       for name in ("CurvatureOnSurface", "HessianCurvature")},
    ("SurfaceCurvature", "NormalCurvatureDirection"): {"Method": 1, "OutputArrays": ["NormalCurvature"]},
    **{(name, bound): {"OutputArrays": ["SurfaceType"]}
       for name in ("CurvatureOnSurface", "HessianCurvature", "SurfaceCurvature")
       for bound in ("FlatTolerance", "GaussianTolerance", "MeanTolerance")},
    ("SurfaceCurvature", "Radius"): {"Method": 2},
    ("TetCutaway", "SeedFace"): {"NumberOfCells": 5},
    ("TetCutaway", "SeedMode"): {"NumberOfCells": 5},
    ("TetCutaway", "SeedPoint"): {"NumberOfCells": 5},
    ("TetrahedralMesher", "BoxMargin"): {"Side": 1},
}
# Values for small data, where those of the range are for large ones.
VALUES = {
    **{(name, element): values for name in ION_TRANSPORT for element, values in (
        ("LumenRadius", [4.0]), ("MembraneCenter", [-0.1, 0.1]), ("MembraneThickness", [7.0]),
        ("ProbeRadius", [1.4]), ("Spacing", [1.2]), ("Padding", [5.0]),
        ("MaximumIterations", [1]), ("UpdatePeriod", [2]), ("UpdateTolerance", [1e-5]), ("MaximumUpdates", [2]))},
    ("BindingSites", "MergeDistance"): [6.0, 20.0],
    ("ChokingLoops", "MaximumRadius"): [1.0, 5.0],
    ("ChokingLoops", "MaximumNumberOfLoops"): [1, 2],
    ("HandleFilling", "FillHandlesBelow"): [0.1, 3.0],
    ("MoleculeCartoon", "Sides"): [4, 6],
    ("HandleFilling", "SampleSpacing"): [0.4, 1.0],
    ("MapHandles", "MinimumPersistence"): [0.05, 0.3],
    ("MapSurface", "MinimumComponentArea"): [20.0, 60.0],
    ("ScalarRegions", "SweepTarget"): [0.04, 0.0],
    ("SurfaceCurvature", "MeanTolerance"): [1.0],
    ("SurfaceCurvature", "Radius"): [2.0, 3.0],
    ("SurfaceRemesh", "NumberOfTriangles"): [200, 500],
    ("TetCutaway", "NumberOfCells"): [1, 5],
    ("TetCutaway", "SeedFace"): [20, 60],
}
# {(proxy, property): why no sensible value changes the output of small sound data}.
LIMIT = "a bound on work that small data do not reach"
SILENT = {
    **{("AtomSelection", name): "the atoms are one chain: TestAtomSelection has each kind of residue"
       for name in ("IncludeHydrogens", "IncludeIons", "IncludeLigands", "IncludeProstheticGroups", "IncludeWaters")},
    ("BindingSites", "UsePockets"): "without atoms there are no pockets: BindingSitesInPockets has them",
    **{("BindingSitesInPockets", name): "a ball has no pockets: BindingSites.py has a molecule's"
       for name in ("Amplitude", "Classes", "MergeDistance", "MinimumArea", "Quantile", "RankBy",
                    "Threshold", "AutomaticThreshold")},
    ("ChokingLoops", "Accuracy"): "it concerns more than 40,000 points: TestAdaptiveSamples has them",
    ("ChokingLoops", "AllowSelfIntersections"): "the ring does not cross itself: TestChokingInput has what does",
    ("ChokingLoops", "CapHoles"): "the ring is closed: TestChokingInput has what is not",
    ("ChokingLoops", "LoopOrder"):
        "the ring's loops rank alike by radius and length: TestChokingLoopsFilter has a slotted plate",
    ("ChokingLoops", "MemoryLimit"): LIMIT,
    ("ChokingLoops", "TrustedOnly"):
        "all loops of the ring are trusted, 205 of 244 of a noisy map are: SignificantLoops.py has a noisy map",
    ("DelaunayIsosurface", "MaximumNumberOfPoints"): LIMIT,
    ("DiffusionHighPass", "MaskInvalid"): "all values are finite: MaskedMaps.py has others",
    **{(name, of_program): "the atoms have charges: TestProteinCharges has some without"
       for name in ("ForceFieldCharges", "ForceFieldChargesAndLigands")
       for of_program in ("ForceField", "UsePropka", "PH")},
    **{(name, "MinimumConfidence"): "the atoms are no predicted model: ReportedMolecules.py has one"
       for name in ("MolecularPockets", "PoreProfile")},
    ("FeatureTracks", "MaximumDistance"): "needs steps of time: FeatureTracks.py",
    ("FeatureTracks", "MaximumGap"): "the same",
    **{(name, "MaskInvalid"): "all values are finite: MaskedMaps.py has others"
       for name in ("DenoiseMap", "HighOrderDiffusion")},
    ("IsosurfaceStuffing", "MemoryLimit"): LIMIT,
    **{(name, silent): why for name in ION_TRANSPORT for silent, why in (
        ("IncludeWaters", "the tube has no residues: MolecularFlowSurface.py has"),
        ("UnitedAtoms", "the same"),
        ("Species", "rows of five numbers: IonTransport.py sets them"))},
    ("IonTransportOnSurface", "ProbeRadius"): "the surface is given",
    ("LoopShortening", "MaximumRounds"): LIMIT,
    ("LoopShortening", "Tolerance"): "the ring is as short as it gets at once",
    ("MolecularFlowSurface", "TimeSteps"): "what times may be asked for: MolecularFlowSurface.py, FlowWindow.py",
    **{(name, "UnitedAtoms"): "the atoms have hydrogens: MolecularFlowSurface.py has a chain without"
       for name in ("MolecularFlowSurface", "NonpolarSolvation")},
    **{("SolvationSurface", name): "each run takes seconds: SolvationSurface.EachPropertyHasItsEffect"
       for name in ("AdaptiveUpdate", "EnergyTolerance", "Enlargement", "FieldRelaxation", "IonicStrength",
                    "MaximumUpdates", "Padding", "Pressure", "ProbeRadius", "DielectricModel", "SoluteDielectric",
                    "SolventDielectric", "Spacing", "SurfaceRelaxation", "SurfaceTension", "Temperature",
                    "UpdatePeriod")},
    ("SolvationSurface", "IncludeWaters"): "the atoms have no residues: MolecularFlowSurface.py has",
    ("SolvationSurface", "UnitedAtoms"): "the same",
    ("MolecularFlowSurface", "CoarseToFine"): "a quicker way to a surface that small grids reach at once",
    **{("MolecularPockets", name): "the hollow ball has no pocket: MolecularPockets.py has molecules"
       for name in ("OuterRadius", "ShownPocket", "UsePolarizedCurvature")},
    ("MolecularPockets", "UsePeriodicCell"): "the hollow ball has no cell: TestPeriodicSpace has crystals",
    ("MolecularPockets", "MinimumVolume"): "sites of any volume are listed: TestPocketSurface has whole pockets",
    **{("MoleculeCartoon", name): "the atoms are one chain without names: TestMoleculeCartoon has each kind of residue"
       for name in ("ComputeSecondaryStructure", "IncludeIons", "IncludeLigands", "IncludeWaters", "RibbonThickness", "RibbonWidth",
                    "StickRadius", "StickResidues")},
    ("PDETransform", "MaskInvalid"): "all values are finite: MaskedMaps.py has others",
    **{("PoreProfile", name): "the hollow ball has one pore or none: TestPoreProfile has tubes"
       for name in ("MaximumOffset", "Point1", "Point2")},
    ("PoreProfile", "MaximumPores"): "the hollow ball has one pore or none, and no other test has many",
    ("TetrahedralMesher", "MemoryLimit"): LIMIT,
    ("TetrahedralMesher", "OptimisationTimeLimit"): LIMIT,
    ("TetrahedralMesher", "TimeLimit"): LIMIT,
    **{(name, "MaximumIterations"): LIMIT for name in ("PoissonBoltzmann", "PoissonBoltzmannOnSurface")},
    **{(name, "ForceField"): "the atoms have charges: TestProteinCharges has some without"
       for name in ("PoissonBoltzmann", "PoissonBoltzmannOnSurface")},
    **{(name, asked): "of a volume given as the surface: TestPoissonBoltzmannFilter"
       for name in ("PoissonBoltzmann", "PoissonBoltzmannOnSurface")
       for asked in ("Level", "InsideIsHigher")},
    ("TetrahedralMesher", "Repair"): "there is nothing to repair: TestMeshingFuzz has what there is",
}


def conditions():
    """{(proxy, property): [(other property, value)]} under which a panel shows a property."""
    found = {}

    def meet(proxy, name, hints):
        for decorator in hints.iter("PropertyWidgetDecorator") if hints is not None else ():
            if decorator.get("type") == "GenericDecorator" and decorator.get("inverse") != "1":
                value = decorator.get("value") or decorator.get("values", "").split()[0]
                if value != "null":  # an input that may be missing, and is here
                    found.setdefault((proxy, name), []).append((decorator.get("property"), value))

    for root in panels():
        for proxy in root.iter("SourceProxy"):
            for element in proxy:
                if element.tag.endswith("VectorProperty"):
                    meet(proxy.get("name"), element.get("name"), element.find("Hints"))
                if element.tag == "PropertyGroup":
                    for member in element.findall("Property"):
                        meet(proxy.get("name"), member.get("name"), element.find("Hints"))
    return found


def domains_of(vector):
    iterator = vector.NewDomainIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetDomain()
        iterator.Next()


def values_of(vector):
    """Up to three sensible values other than the default, for each element."""
    if vector.GetClassName() == "vtkSMStringVectorProperty":  # output arrays: none and all
        domain = next(domains_of(vector))
        return [[], [domain.GetString(i) for i in range(domain.GetNumberOfStrings())]]
    whole = vector.GetClassName() != "vtkSMDoubleVectorProperty"
    default = vector.GetElement(0)
    low, high = None, None
    for domain in domains_of(vector):
        if domain.IsA("vtkSMBooleanDomain"):
            return [1 - default]
        if domain.IsA("vtkSMEnumerationDomain"):
            entries = [domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())]
            return [entry for entry in entries if entry != default][:3]
        if domain.IsA("vtkSMDoubleRangeDomain") or domain.IsA("vtkSMIntRangeDomain"):
            low = domain.GetMinimum(0) if domain.GetMinimumExists(0) else low
            high = domain.GetMaximum(0) if domain.GetMaximumExists(0) else high
    tried = [default * 2, default / 2] if default else [1, 0.3]
    if low is not None and high is not None:
        tried = [low + part * (high - low) for part in (0.3, 0.6, 0.1)]
    elif whole:
        tried += [default + 1]
    else:
        tried += [default + 0.1]
    if whole:
        tried = [round(value) for value in tried]
    return list(dict.fromkeys(
        value for value in tried if value != default and (low is None or value >= low)
        and (high is None or value <= high)))


def properties_of(proxy):
    proxy.UpdatePipelineInformation()  # names of output arrays
    for name in proxy.ListProperties():
        vector = proxy.SMProxy.GetProperty(name)
        if vector is not None and vector.GetCommand() and not vector.GetInformationOnly():
            if vector.GetClassName() in ("vtkSMDoubleVectorProperty", "vtkSMIntVectorProperty",
                                         "vtkSMIdTypeVectorProperty"):
                if vector.GetNumberOfElements():
                    yield name, vector
            elif name == "OutputArrays":
                yield name, vector


def digest(algorithm):
    """A number for all that comes out of all ports."""
    said = hashlib.sha256()

    def add(array):
        if array is None:
            return
        said.update((array.GetName() or "").encode())
        if hasattr(array, "GetVoidPointer") and array.GetNumberOfValues():
            try:
                said.update(vtk_to_numpy(array).tobytes())
            except (AssertionError, KeyError, ValueError):
                said.update(str([array.GetVariantValue(i).ToString()
                                 for i in range(array.GetNumberOfValues())]).encode())
        else:
            said.update(str([array.GetValue(i) for i in range(array.GetNumberOfValues())]).encode())

    for port in range(algorithm.GetNumberOfOutputPorts()):
        for leaf in robustness_trials.leaves(algorithm.GetOutputDataObject(port)):
            if leaf is None:
                continue
            for ask in ("GetPointData", "GetCellData", "GetFieldData", "GetRowData"):
                attributes = getattr(leaf, ask)() if hasattr(leaf, ask) else None
                for i in range(attributes.GetNumberOfArrays() if attributes else 0):
                    add(attributes.GetAbstractArray(i))
            if leaf.IsA("vtkPointSet") and leaf.GetPoints():
                add(leaf.GetPoints().GetData())
            if leaf.IsA("vtkImageData"):
                said.update(str((leaf.GetExtent(), leaf.GetSpacing(), leaf.GetOrigin())).encode())
            for ask in ("GetVerts", "GetLines", "GetPolys", "GetCells"):
                cells = getattr(leaf, ask)() if hasattr(leaf, ask) else None
                if cells and hasattr(cells, "GetConnectivityArray"):
                    add(cells.GetConnectivityArray())
    return said.hexdigest()


def outcome(name, data, settings):
    """What comes out of a fresh filter with these settings: a digest, or 'refused: ...'."""
    proxy = made(name, replaced=data, optional=False)
    algorithm = proxy.GetClientSideObject()
    listener = robustness_trials.Listener(algorithm)
    proxy.UpdatePipelineInformation()
    for property_name, value in settings:
        if isinstance(value, list):  # of names
            setattr(proxy, property_name, value)
            continue
        vector = proxy.SMProxy.GetProperty(property_name)
        whole = vector.GetClassName() != "vtkSMDoubleVectorProperty"
        for element in range(max(1, vector.GetNumberOfElements())):
            # Lists ascend, as thresholds must.
            vector.SetElement(element, int(value) if whole else float(value) + 0.2 * element)
    proxy.SMProxy.UpdateVTKObjects()
    proxy.SMProxy.UpdatePipeline()
    return f"refused: {listener.errors[0]}" if listener.errors else digest(algorithm)


def judged(name, data, settings):
    word, said, took = robustness_trials.run(lambda: outcome(name, data, settings), SECONDS, 2048)
    return said if word == "done" else f"{word}: {said[-300:]} ({took:.1f} s)"


class Judge:
    """One filter on its inputs, first of one type, then of the next."""

    def __init__(self, name):
        self.name = name
        self.data = [inputs(name, kind) for kind in kinds(name)]
        self.known = {}

    def before(self, number, needs):
        key = (number, str(needs))
        if key not in self.known:
            self.known[key] = judged(self.name, self.data[number], needs)
        return self.known[key]

    def effect(self, needs, property_name, values):
        """'changes', or what was tried in vain."""
        tried = []
        for number, data in enumerate(self.data):
            before = self.before(number, needs)
            if len(before) != 64:
                tried.append(f"nothing to compare: {before}")
                continue
            for value in values:
                after = judged(self.name, data, needs + [(property_name, value)])
                if len(after) == 64 and after != before:
                    return "changes"
                tried.append(f"{value}: " + ("the same" if after == before else after))
        return "; ".join(tried) or "no value to try"


def those_now(part):
    """The filters of that part of a name; all of them take eight minutes, so under Testing/run.sh a
    third, by the commit's date."""
    names = [name for name in filters() if part in name]
    return share(names, 3) if TURN and not part else names


def check(part):
    shown_where = conditions()
    counts, complaints = {"changes": 0, "silent": 0}, []
    for name in those_now(part):
        judge = Judge(name)
        for property_name, vector in list(properties_of(made(name, replaced=judge.data[0], optional=False))):
            key = (name, property_name)
            needs = [(other, float(value)) for other, value in shown_where.get(key, [])]
            needs += list(NEEDS.get(key, {}).items())
            said = judge.effect(needs, property_name, VALUES.get(key) or values_of(vector))
            if said == "changes":
                counts["changes"] += 1
                if key in SILENT:
                    complaints.append(f"{name}.{property_name} changes the output: not SILENT")
                    print(complaints[-1], flush=True)
            elif key in SILENT:
                counts["silent"] += 1
            else:
                complaints.append(f"{name}.{property_name} changes nothing, with {needs}: {said}")
                print(complaints[-1], flush=True)
    return counts, complaints


if __name__ == "__main__":
    part_of_name = sys.argv[1] if len(sys.argv) > 1 else ""
    counted, wrong = check(part_of_name)
    print(f"{counted['changes']} properties change the output; {counted['silent']} do not, with a reason")
    assert not wrong, f"{len(wrong)} properties went wrong"
    assert part_of_name or counted["changes"] > (20 if TURN else 150)
