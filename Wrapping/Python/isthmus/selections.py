"""Selections of points, cells and rows, as the window itself makes them: lists of selections.

The window crashes if a source gets a single selection, and ParaView 6.1 refuses one.
"""

try:
    from paraview import servermanager
    from paraview.modules.vtkRemotingViews import vtkSMSelectionHelper
except ImportError:
    servermanager = vtkSMSelectionHelper = None  # with pip's vtk alone, isthmus.pipelines can still be imported


def of_ids(kind, numbers):
    """The selection of these points, cells or rows (kind: POINT, CELL or ROW), which may be none."""
    return _as_list(servermanager.sources.IDSelectionSource(
        FieldType=kind, IDs=[number for i in numbers for number in (-1, i)] or [-1, -1]))


def of_query(kind, query):
    """The selection by a query (kind: "Point Data" or "Cell Data")."""
    return _as_list(servermanager.sources.SelectionQuerySource(QueryString=query, ElementType=kind))


def select(source, port, selection):
    """Selects in an output of a source, as the user would; None: nothing."""
    source.SMProxy.SetSelectionInput(port, selection.SMProxy if selection else None, 0)


def _as_list(selection):
    made = vtkSMSelectionHelper.NewAppendSelectionsFromSelectionSource(selection.SMProxy)
    proxy = servermanager._getPyProxy(made)
    made.UnRegister(None)
    return proxy
