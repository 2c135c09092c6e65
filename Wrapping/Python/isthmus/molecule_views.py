"""Cartoons of molecules in the window: their colours, names of residues, selection by residue, distances.

    from isthmus import molecule_views            # or: from isthmus_plugin, with the plugin loaded
    cartoon = MoleculeCartoon(OpenDataFile("1hew.pdb"))
    molecule_views.show(cartoon, colour_by="BFactor")
    molecule_views.label(cartoon, "A:35 A:52")
    molecule_views.distance(cartoon, "A:35", "A:52")

A residue that is selected, in the view or as a row of the table of residues, is selected in all three outputs.
Residues are lists of names (HIS), numbers (57) or numbers with a chain (A:57).
"""

from vtkmodules.vtkCommonCore import vtkIdList

try:
    from paraview import servermanager, simple
    from vtkmodules.numpy_interface import algorithms
except ImportError:
    servermanager = simple = algorithms = None  # with pip's vtk alone, isthmus.pipelines can still be imported

from . import colours, messages, selections

CARTOON, STICKS, RESIDUES = 0, 1, 2  # the ports
MOST_NAMES = 12  # of chains in a legend
# The colours of Okabe and Ito, suitable for colour-blind readers, then lighter ones; more chains repeat them.
CHAINS = ((0.0, 0.447, 0.698), (0.902, 0.624, 0.0), (0.0, 0.620, 0.451), (0.800, 0.475, 0.655), (0.337, 0.706, 0.914),
          (0.835, 0.369, 0.0), (0.941, 0.894, 0.259), (0.55, 0.55, 0.55), (0.45, 0.30, 0.15), (0.40, 0.80, 0.75))
STRUCTURE = (("0", "coil", (0.78, 0.78, 0.78)), ("1", "helix", (0.835, 0.369, 0.0)),
             ("2", "strand", (0.0, 0.447, 0.698)), ("3", "3-10 helix", (0.902, 0.624, 0.0)),
             ("4", "pi helix", (0.800, 0.475, 0.655)), ("5", "nucleic acid", (0.0, 0.620, 0.451)))
# The classes and colours of the AlphaFold Protein Structure Database: very low, low, confident, very high.
CONFIDENCE = ((0.0, 50.0, (1.0, 0.490, 0.271)), (50.0, 70.0, (1.0, 0.859, 0.075)),
              (70.0, 90.0, (0.396, 0.796, 0.953)), (90.0, 100.0, (0.0, 0.325, 0.839)))
# As the window draws ligands; further elements have colours similar to Jmol's.
ELEMENTS = (("6", "C", (0.72, 0.72, 0.66)), ("7", "N", (0.0, 0.447, 0.698)), ("8", "O", (0.835, 0.2, 0.1)),
            ("16", "S", (0.902, 0.75, 0.1)), ("1", "H", (0.9, 0.9, 0.9)), ("15", "P", (0.902, 0.5, 0.0)),
            ("9", "F", (0.56, 0.88, 0.31)), ("17", "Cl", (0.12, 0.82, 0.12)), ("35", "Br", (0.65, 0.16, 0.16)),
            ("53", "I", (0.58, 0.0, 0.58)), ("11", "Na", (0.67, 0.36, 0.95)), ("12", "Mg", (0.40, 0.80, 0.10)),
            ("19", "K", (0.56, 0.25, 0.83)), ("20", "Ca", (0.30, 0.75, 0.20)), ("25", "Mn", (0.61, 0.48, 0.78)),
            ("26", "Fe", (0.88, 0.40, 0.20)), ("30", "Zn", (0.49, 0.50, 0.69)))
TITLES = {"ChainIndex": "Chain", "SecondaryStructure": "Secondary structure", "BFactor": "B factor (Å²)",
          "pLDDT": "pLDDT"}


def show(cartoon, view=None, colour_by=None, sticks=True):
    """Shows the cartoon, and the balls and sticks; returns the display of the cartoon.

    colour_by: SecondaryStructure, ChainIndex, BFactor or pLDDT; None: chosen as in the window.
    sticks: show what is not in the cartoon."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    display = simple.Show(simple.OutputPort(cartoon, CARTOON), view)
    look(display, view, CARTOON)
    if colour_by:
        colour(display, view, colour_by)
    if sticks and _count(cartoon, STICKS):
        look(simple.Show(simple.OutputPort(cartoon, STICKS), view), view, STICKS)
    simple.ResetCamera(view)
    return display


def show_with_map(cartoon, coloured, view=None):
    """Shows a model and the surface of its map by the nearest chain (pipelines.map_with_model) in the same colours;
    returns the display of the surface."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    show(cartoon, view, colour_by="ChainIndex")
    display = simple.Show(coloured, view, "GeometryRepresentation")
    colours.colour_by(display, "POINTS", "ChainIndex")
    display.SetScalarBarVisibility(view, False)
    display.Opacity, display.Pickable = 0.4, 0
    simple.ResetCamera(view)
    return display


def _count(cartoon, port):
    cartoon.UpdatePipeline()
    return cartoon.SMProxy.GetDataInformation(port).GetNumberOfCells()


def look(display, view, port):
    """The array that the window colours by first: confidence of a prediction, otherwise chains, otherwise
    secondary structure."""
    if port == STICKS and colours.has_values(display.Input, "CELLS", "Element"):
        colour(display, view, "Element")
    if port != CARTOON or not colours.has_values(display.Input, "CELLS", "SecondaryStructure"):
        return
    cells = display.Input.CellData
    chains = cells["ChainIndex"]
    colour(display, view, "pLDDT" if cells["pLDDT"] is not None else
           "ChainIndex" if chains is not None and chains.GetRange(0)[1] > 0 else "SecondaryStructure")
    display.Specular, display.SpecularPower = 0.25, 40.0


def colour(display, view, array):
    """Colours a cartoon, or balls and sticks, by that cell array, with a legend, except for elements and for many chains."""
    if display.Input.CellData[array] is None:
        names = [display.Input.CellData.GetArray(i).Name for i in range(display.Input.CellData.GetNumberOfArrays())]
        raise ValueError(f"There is no {array} to colour by; there are: {', '.join(sorted(names)) or 'none'}.")
    simple.ColorBy(display, ("CELLS", array))
    table = display.LookupTable
    if array == "pLDDT":
        _set_confidence(table)
    elif array == "BFactor":
        table.ApplyPreset(colours.sequential(), True)
        low, high = display.Input.CellData[array].GetRange(0)
        table.RescaleTransferFunction(low, high if high > low else low + 1.0)
    else:
        colours.set_categories(table, _categories(display, array))
    has_legend = array != "Element" and len(table.Annotations) <= 2 * MOST_NAMES
    display.SetScalarBarVisibility(view, has_legend)
    if has_legend:
        colours.legend(table, view, TITLES.get(array, array))
    simple.HideUnusedScalarBars(view)


def _set_confidence(table):
    """Four plain colours."""
    table.InterpretValuesAsCategories = 0
    table.ColorSpace = "RGB"
    table.RGBPoints = [number for low, high, rgb in CONFIDENCE
                       for number in (low if low == 0.0 else low + 1e-4, *rgb, high, *rgb)]
    table.AutomaticRescaleRangeMode = "Never"


def _categories(display, array):
    if array == "Element":
        return ELEMENTS
    data = display.Input.CellData[array]
    low, high = (int(bound) for bound in data.GetRange(0))
    if array == "SecondaryStructure":
        kinds = _kinds(display)
        return [row for row in STRUCTURE if int(row[0]) in kinds] or STRUCTURE[:1]
    names = _chain_names(display)
    return [(str(i), names[i] if i < len(names) and names[i] else "no name", CHAINS[i % len(CHAINS)])
            for i in range(low, high + 1)]


def _table_of(display):
    return servermanager.Fetch(servermanager._getPyProxy(display.Input.SMProxy), idx=RESIDUES)


def _kinds(display):
    array = _table_of(display).GetPointData().GetArray("SecondaryStructure")
    return {int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())}


def _chain_names(display):
    names = _table_of(display).GetFieldData().GetAbstractArray("ChainNames")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())] if names else []


# ---------------------------------------------------------------------------- residues

def rows_of(cartoon, residues):
    """The rows of those residues in the table of residues, ascending: names (HIS), numbers (57), or numbers with a
    chain (A:57), separated by blanks or commas."""
    wanted = set(residues.replace(",", " ").replace(";", " ").split())
    table = servermanager.Fetch(cartoon, idx=RESIDUES)
    data = table.GetPointData()
    found = []
    for i in range(table.GetNumberOfPoints()):
        name, chain, code = (data.GetAbstractArray(array).GetValue(i) for array in (
            "ResidueName", "Chain", "InsertionCode"))
        number = f"{data.GetArray('ResidueId').GetValue(i)}{code}"
        if wanted & {name, number, f"{chain}:{number}"}:
            found.append(i)
    return found


def atoms_of(model, residues):
    """The atoms of those residues of a molecule, with their bonds: names, numbers, or numbers with a chain (A:57)."""
    wanted = set(residues.replace(",", " ").replace(";", " ").split())
    atoms, ends = servermanager.Fetch(model), vtkIdList()
    data = atoms.GetPointData()
    names, numbers, chains = (data.GetAbstractArray(name) for name in ("ResidueName", "ResidueId", "Chain"))
    chosen = {i for i in range(names.GetNumberOfValues() if names else 0)
              if wanted & {names.GetValue(i), str(numbers.GetValue(i)), f"{chains.GetValue(i)}:{numbers.GetValue(i)}"}}
    if not chosen:
        raise ValueError(f"There is no residue {residues} in the molecule.")
    cells = []  # vertices and bonds
    for cell in range(atoms.GetNumberOfCells()):
        atoms.GetCellPoints(cell, ends)
        if all(ends.GetId(i) in chosen for i in range(ends.GetNumberOfIds())):
            cells.append(cell)
    kind, ids = ("CELL", cells) if cells else ("POINT", sorted(chosen))
    part = simple.ExtractSelection(
        model, Selection=selections.of_ids(kind, ids))
    part.UpdatePipeline()
    return part


def _one(cartoon, residue):
    rows = rows_of(cartoon, residue)
    if len(rows) != 1:
        raise ValueError(f"{residue} names {len(rows)} residues: give one, as number with a chain (A:57).")
    return rows[0]


def label(cartoon, residues, view=None):
    """Names of these residues in the view, "LYS 48 A"; returns their display."""
    view = view or simple.GetActiveView()
    rows = rows_of(cartoon, residues)
    if not rows:
        raise ValueError(f"There is no residue {residues} in the cartoon.")
    part = simple.ExtractSelection(simple.OutputPort(cartoon, RESIDUES), Selection=selections.of_ids("POINT", rows))
    part.UpdatePipeline()
    display = simple.Show(part, view)
    display.SetRepresentationType("Points")
    display.PointSize, display.Opacity = 1.0, 0.0
    selections.select(part, 0, selections.of_ids("POINT", range(len(rows))))
    display.SelectionPointLabelVisibility, display.SelectionPointFieldDataArrayName = 1, "Residue"
    display.SelectionPointLabelColor = [0.1, 0.1, 0.1]
    display.SelectionPointLabelFontSize = 18
    simple.Render(view)
    return display


def distance(cartoon, first, second, view=None):
    """The distance of two residues (CA, C4', or the middle of a ligand) in angstrom, drawn as a ruler."""
    view = view or simple.GetActiveView()
    table = servermanager.Fetch(cartoon, idx=RESIDUES)
    ends = [table.GetPoint(_one(cartoon, residue)) for residue in (first, second)]
    ruler = simple.Ruler(Point1=ends[0], Point2=ends[1])
    display = simple.Show(ruler, view)
    display.LabelFormat = "{:.1f} Å" if "{" in display.LabelFormat else "%.1f Å"
    simple.Render(view)
    return sum((a - b) ** 2 for a, b in zip(*ends)) ** 0.5


def select(cartoon, residues):
    """Selects residues in the cartoon, the balls and sticks, and the table; returns their rows."""
    rows = rows_of(cartoon, residues)
    _select(cartoon, rows, (CARTOON, STICKS, RESIDUES))
    _keep(cartoon)
    return rows


def selected(cartoon, port):
    """The rows of the residues that are selected in an output; None without a selection."""
    if cartoon.SMProxy.GetSelectionInput(port) is None:
        return None
    part = cartoon.SMProxy.GetSelectionOutput(port)
    part.UpdatePipeline()
    data = servermanager.Fetch(servermanager.OutputPort(servermanager._getPyProxy(part), 0))
    blocks = [data] if not data.IsA("vtkCompositeDataSet") else _blocks(data)
    rows = set()
    for block in blocks:
        for attributes in (block.GetCellData(), block.GetPointData()):
            array = attributes.GetArray("ResidueIndex")
            rows |= {int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())} if array else set()
    return sorted(rows)


def _blocks(data):
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def _select(cartoon, rows, ports):
    for port in ports:
        if not rows or not _count(cartoon, port):
            cartoon.SMProxy.CleanSelectionInputs(port)
            continue
        word = "in1d" if hasattr(algorithms, "in1d") else "isin"  # the latter from ParaView 6 on
        query = f"{word}(ResidueIndex, [" + ", ".join(map(str, rows)) + "])"
        selections.select(cartoon, port, selections.of_query("Point Data" if port == RESIDUES else "Cell Data", query))


_last = {}  # rows that were selected last, by the global id of the cartoon and port


def _keep(cartoon):
    """Stores the current selection, so that the next change can be detected."""
    for port in (CARTOON, STICKS, RESIDUES):
        _last[cartoon.SMProxy.GetGlobalID(), port] = selected(cartoon, port)


@messages.reports_faults("Selecting a residue in all outputs")
def selection_changed(cartoon):
    """Applies a selection made in one output of a cartoon to all of its outputs."""
    number = cartoon.SMProxy.GetGlobalID()
    for port in (CARTOON, STICKS, RESIDUES) if cartoon.SMProxy.GetXMLName() == "MoleculeCartoon" else ():
        rows = selected(cartoon, port)
        if rows is not None and rows != _last.get((number, port)):
            _select(cartoon, rows, [other for other in (CARTOON, STICKS, RESIDUES) if other != port])
            _keep(cartoon)
            simple.RenderAllViews()  # ParaView itself renders only the view that was clicked
            break
