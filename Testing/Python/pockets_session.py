"""Opens the molecule of PocketsWindow.py, and writes down which pocket or pore each click chooses."""

import os
from pathlib import Path

from paraview import simple

from isthmus_plugin import pocket_views  # there once paraview.simple has loaded the plugin

chosen = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "chosen.txt"


def choose_and_tell(features, number, choose=pocket_views.choose):  # a name that numpy has, too
    choose(features, number)
    residues = pocket_views.residues_of(features)
    atoms = residues.GetDataInformation().DataInformation.GetNumberOfPoints()
    with chosen.open("a") as file:
        file.write(f"{features.SMProxy.GetXMLName()} {number} {atoms}\n")


pocket_views.choose = choose_and_tell

molecule = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
simple.Show(molecule, simple.GetActiveViewOrCreate("RenderView"))
simple.SetActiveSource(molecule)
