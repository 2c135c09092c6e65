"""Buttons of the toolbar one after the other, each with the result of the one before selected: the same
result as on the molecule or map itself. And on what they can't take, groups among it: one sentence, no
error of VTK's besides, and what was selected stays selected.
"""

import tempfile
from pathlib import Path

from paraview import servermanager, simple
from shared_data import shared_data
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin


class Messages:
    """Errors that reach the window's messages meanwhile."""

    def __enter__(self):
        self.sentences = []
        self.window = vtkOutputWindow.GetInstance()

        def keep(_, __, sentence):
            self.sentences.append(sentence.strip())

        keep.CallDataType = VTK_STRING
        self.observer = self.window.AddObserver("ErrorEvent", keep)
        return self.sentences

    def __exit__(self, *_):
        self.window.RemoveObserver(self.observer)


def outcome(proxy):
    """What a result is, in numbers that no order of sources may change."""
    information = proxy.GetDataInformation().DataInformation
    numbers = [proxy.SMProxy.GetXMLName(), information.GetNumberOfPoints(), information.GetNumberOfCells(),
               information.GetBounds()]
    if proxy.SMProxy.GetXMLName() == "MolecularPockets":
        scores = servermanager.Fetch(proxy, idx=1).GetColumnByName("Score")
        numbers += [scores.GetValue(i) for i in range(scores.GetNumberOfTuples())]
    return numbers


def clear(keep):
    for proxy in list(simple.GetSources().values()):
        if proxy not in keep:
            simple.Delete(proxy)


def opened(name):
    return simple.OpenDataFile(str(shared_data(name)))


def check_in_turn(source, alone, turns):
    """`turns`: buttons, the first on the source, each other on the result of the one before."""
    fresh = {}
    for function in alone:
        simple.SetActiveSource(source)
        pipelines.run(function)
        fresh[function] = outcome(simple.GetActiveSource())
        clear([source])
    simple.SetActiveSource(source)
    for function in turns:
        with Messages() as said:
            pipelines.run(function)
        got = outcome(simple.GetActiveSource())
        assert not said and got == fresh[function], f"{function}: {got}, alone {fresh[function]}; {said}"
        print(f"{function:20} {got[:3]}", flush=True)
    clear([])


def check_refusals(source, functions, words):
    """One sentence with `words`, and the source is selected still."""
    for function in functions:
        simple.SetActiveSource(source)
        with Messages() as said:
            pipelines.run(function)
        assert len(said) == 1 and words in said[0], f"{function}: {said}"
        assert simple.GetActiveSource() == source, f"{function}: {simple.GetActiveSource()}"
        print(f"{function:20} {said[0]}", flush=True)


PROTEIN = ("protein_to_pockets", "protein_to_surface")
check_in_turn(opened("molecules/1hew/1hew.pqr"), (*PROTEIN, "protein_to_sites"),
              ("protein_to_pockets", "protein_to_pockets", "protein_to_surface", "protein_to_surface",
               "protein_to_pockets", "protein_to_sites", "protein_to_pockets"))
MAP = ("map_to_surface", "map_to_curvature", "map_to_loops")
check_in_turn(opened("maps/emd_1832.map"), MAP,
              ("map_to_surface", "map_to_surface", "map_to_curvature", "map_to_loops", "map_to_curvature"))

molecule = opened("molecules/1AJJ_pH7_PARSE.pqr")
molecule.UpdatePipeline()
with tempfile.TemporaryDirectory() as folder:
    glycine = Path(folder) / "glycine.pdb"
    glycine.write_text("".join(
        f"ATOM  {i:5d}  {name:3} GLY A   1    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           {name[0]}\n"
        for i, (name, x, y, z) in enumerate(
            (("N", 0.0, 0.0, 0.0), ("CA", 1.46, 0.0, 0.0), ("C", 2.0, 1.42, 0.0), ("O", 1.3, 2.4, 0.3)), 1)))
    residue = simple.OpenDataFile(str(glycine))
    residue.UpdatePipeline()
    check_refusals(residue, ("protein_to_pockets",), "no pockets of this size")
molecules = simple.GroupDatasets(Input=[molecule, opened("molecules/1crn_apbs.pqr")])
check_refusals(molecules, ("protein_to_sites",), "Extract Block")
maps = simple.GroupDatasets(Input=[opened("maps/emd_1832.map"), opened("maps/emd_1703.map")])
check_refusals(maps, ("map_to_curvature",), "Extract Block")

# After Reset Session, the source of before still counts as active, though it is nowhere in the window.
before = simple.Wavelet()
before.UpdatePipeline()
simple.ResetSession()
with Messages() as said:
    pipelines.run("map_to_surface")
assert len(said) == 1 and "Select a source" in said[0], said
assert not simple.GetSources(), simple.GetSources()
