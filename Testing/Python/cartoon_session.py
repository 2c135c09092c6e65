"""Opens the molecule of CartoonWindow.py as a cartoon beside its table of residues, and writes down the rows that are
selected in each output, whenever that changes."""

import os
from pathlib import Path

from paraview import simple

from isthmus_plugin import molecule_views as molecules  # there once paraview.simple has loaded the plugin
from isthmus_plugin import pocket_views as pockets

path = Path(os.environ["ISTHMUS_SESSION_DIR"]) / "selected.txt"

opened = simple.OpenDataFile(os.environ["ISTHMUS_SESSION_DATA"])
view = simple.GetActiveViewOrCreate("RenderView")
cartoon = simple.MoleculeCartoon(opened)
molecules.show(cartoon, view)
table = pockets.new_view("SpreadSheetView", view, "right", 0.6)
simple.Show(simple.OutputPort(cartoon, molecules.RESIDUES), table, "SpreadSheetRepresentation")
simple.SetActiveView(view)
simple.SetActiveSource(cartoon)


def write_down(*_):
    rows = [molecules.selected(cartoon, port) for port in (molecules.CARTOON, molecules.STICKS, molecules.RESIDUES)]
    with path.open("a") as file:
        print(*rows, sep="|", file=file)


cartoon.SMProxy.AddObserver("SelectionChangedEvent", write_down)
