"""Colours of arrays in views of ParaView: by value, or by category with a name and a colour for each.

    from isthmus import colours                   # or: from isthmus_plugin, with the plugin loaded
    colours.colour_by(display, "CELLS", "Kind")

An array without values gets no colours and no legend: ParaView would open a dialog for its categories.
"""

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported


def sequential():
    """The name of Viridis in this version of ParaView, which is the short one from 6.0 on."""
    presets = servermanager.vtkSMTransferFunctionPresets.GetInstance() if servermanager else None
    return "Viridis (matplotlib)" if presets and not presets.HasPreset("Viridis") else "Viridis"


def has_values(port, association, array):
    """Whether an output has an array of that name with at least one tuple."""
    found = (port.PointData if association == "POINTS" else port.CellData)[array]
    return found is not None and found.GetNumberOfTuples() > 0


def colour_by(display, association, array):
    """Colours a display by an array, or with a solid colour and no legend if the array has no values. Returns whether it
    has any."""
    if has_values(display.Input, association, array):
        table = simple.GetColorTransferFunction(array)
        points = list(table.RGBPoints) if table.AutomaticRescaleRangeMode == "Never" else None
        simple.ColorBy(display, (association, array))
        if points and list(table.RGBPoints) != points:  # a legend that rescales unasked cannot be compared
            table.RescaleTransferFunction(points[0], points[-4])
        return True
    plain(display)
    return False


def plain(display):
    """Solid colour; simple.ColorBy() fails for a display that has no array yet."""
    if display.ColorArrayName[1]:
        simple.ColorBy(display, None)


def legend(table, view, title):
    """The legend of a colour map in a view, with a horizontal title, readable on the background of a view of its own colour."""
    bar = simple.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle, bar.HorizontalTitle = title, "", 1
    if int(table.InterpretValuesAsCategories):
        _fit(bar, table)
    if not int(view.UseColorPaletteForBackground):
        bar.TitleColor = bar.LabelColor = ink(view.Background)
    return bar


def _fit(bar, table):
    """As long as its entries need."""
    bar.ScalarBarLength = min(0.33, 0.05 * len(table.Annotations) / 2)


def ink(background):
    """Black or white, for text on that background."""
    return [0.0] * 3 if sum(background) > 1.5 else [1.0] * 3


def set_categories(table, rows):
    """Rows: (value, name, colour). Names are set first, since ParaView opens a dialog for a table without names."""
    table.Annotations = [word for value, name, _ in rows for word in (value, name)]
    table.IndexedColors = [part for _, _, colour in rows for part in colour]
    table.InterpretValuesAsCategories = 1
    for view in simple.GetViews():
        for bar in getattr(view, "Representations", ()):
            if bar.SMProxy.GetXMLName() == "ScalarBarWidgetRepresentation" and bar.LookupTable == table:
                _fit(bar, table)
