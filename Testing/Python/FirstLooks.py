"""What a button shows, and what the window shows of a filter at first: a button goes back to the source
that it can use, hides all else, and refuses in one sentence; meshes have edges, charts have levels, and
a surface takes the place of its molecule.
"""

import os
from pathlib import Path

from good_data import channel
from paraview import servermanager, simple
from shared_data import shared_data
from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow

from isthmus_plugin import colours, look, pipelines  # there once paraview.simple has loaded the plugin
from isthmus_plugin import diagram_views as diagrams


def visible(view):
    return sorted(display.Input.SMProxy.GetXMLName() for display in view.Representations
                  if hasattr(display, "Input") and display.Visibility)


def named(name):
    return [proxy for proxy in simple.GetSources().values() if proxy.SMProxy.GetXMLName() == name]


def check_buttons():
    view = simple.GetActiveViewOrCreate("RenderView")
    density = simple.OpenDataFile(str(shared_data("maps/1ake.mrc")))
    simple.SetActiveSource(density)
    pipelines.run("map_to_surface")
    assert simple.GetActiveSource().SMProxy.GetXMLName() == "MapSurface"
    assert visible(view) == ["MapSurface"], visible(view)
    # The next button is pressed with the surface selected: back to the map.
    pipelines.run("map_to_curvature")
    (curvature,) = named("CurvatureOnSurface")
    assert curvature.Volume.SMProxy == density.SMProxy
    assert visible(view) == ["CurvatureOnSurface"], visible(view)
    (surface,) = named("MapSurface")  # that on the screen, not a second one
    assert curvature.Input.SMProxy == surface.SMProxy
    pipelines.run("map_to_surface")
    assert visible(view) == ["MapSurface"] and named("MapSurface") == [surface], "the surface under the curvature is that of the map"
    # A molecule's button shows the molecule's surface, and nothing of the map.
    atoms = simple.OpenDataFile(str(shared_data("molecules/1AJJ_pH7_PARSE.pqr")))
    simple.SetActiveSource(atoms)
    pipelines.run("protein_to_surface")
    assert visible(view) == ["MapSurface"], visible(view)
    # What can't be used leaves all as it was.
    count = len(simple.GetSources())
    simple.SetActiveSource(curvature)
    pipelines.run("protein_to_pockets")
    assert len(simple.GetSources()) == count and visible(view) == ["MapSurface"]
    return density, atoms


def check_refusal():
    """A button's sentence goes where the window's messages come from, once."""
    window, said = vtkOutputWindow.GetInstance(), []
    watched = window.AddObserver("ErrorEvent", lambda caller, event: said.append(event))
    simple.SetActiveSource(simple.Sphere())
    pipelines.run("map_to_surface")
    window.RemoveObserver(watched)
    assert len(said) == 1, said


def check_fault():
    """A fault that nobody has foreseen is one sentence without an exception's text, and a file has that."""
    said, before = [], pipelines.map_to_surface

    def broken(_):
        raise KeyError("nobody foresaw this")

    def keep(_, __, text):
        said.append(text)

    keep.CallDataType = VTK_STRING
    window = vtkOutputWindow.GetInstance()
    watched = window.AddObserver("ErrorEvent", keep)
    pipelines.map_to_surface = broken
    simple.SetActiveSource(simple.Wavelet())
    pipelines.run("map_to_surface")
    pipelines.use_proposed_threshold(0)
    pipelines.map_to_surface = before
    window.RemoveObserver(watched)
    assert len(said) == 2 and all("fault in Isthmus" in text for text in said), said
    assert not any(word in text for text in said for word in ("Error", "nobody", "<string>")), said
    for text in said:
        report = Path(text.split("the file ")[1].split(" and, if")[0])
        assert "Traceback" in report.read_text()
        report.unlink()


def check_first_values():
    """A map's level is Map Surface's before the first Apply; one that somebody gave stays."""
    density = simple.OpenDataFile(str(shared_data("maps/emd_1832.map")))
    surface = simple.MapSurface(Input=density)
    surface.UpdatePipeline()
    proposed = surface.FieldData["Level"].GetRange()[0]
    for make in (simple.DelaunayIsosurface, simple.DualContouring, simple.MapHandles):
        filters = make(Input=density), make(Input=density, Level=1.25)
        for proxy in filters:
            look.first_values(proxy.GetGlobalID())
        assert abs(filters[0].Level - proposed) < 1e-6 and filters[1].Level == 1.25, [f.Level for f in filters]
    by_hand = simple.MapSurface(Input=density)
    look.first_values(by_hand.GetGlobalID())
    assert not by_hand.AutomaticLevel and abs(by_hand.Level - proposed) < 1e-6 and by_hand.MinimumComponentShare > 0
    persistence = simple.ScalarPersistence(Input=density)
    look.first_values(persistence.GetGlobalID())
    assert persistence.Superlevel == 1
    solved = simple.PoissonBoltzmann(Input=simple.OpenDataFile(str(shared_data("molecules/1AJJ_pH7_PARSE.pqr"))))
    look.first_values(solved.GetGlobalID())
    assert solved.IonicStrength == 0.15, solved.IonicStrength
    wavelet = simple.Wavelet()
    other = simple.DualContouring(Input=wavelet)
    before = other.Level
    look.first_values(other.GetGlobalID())
    assert other.Level == before  # no density map
    # A map that a menu denoises is seen as a surface with a level, not as a box.
    view = simple.GetActiveViewOrCreate("RenderView")
    before = simple.Show(by_hand, view)
    denoised = simple.DenoiseMap(Input=density)
    look.first_values(denoised.GetGlobalID())
    look.first_look(simple.Show(denoised, view).GetGlobalID())
    assert visible(view) == ["MapSurface"], visible(view)
    (surface,) = [surface for surface in named("MapSurface") if surface.Input.SMProxy == denoised.SMProxy]
    assert not surface.AutomaticLevel and simple.GetActiveSource() == denoised
    assert not before.Visibility, "the denoised surface is drawn over that of the map"
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)


def check_looks(density, atoms):
    view = simple.GetActiveView()
    torus = simple.OpenDataFile(str(shared_data("surfaces/torus.obj")))
    mesh = simple.Show(simple.TetrahedralMesher(Input=torus), view)
    look.first_look(mesh.GetGlobalID())
    assert mesh.Representation == "Surface With Edges" and not mesh.ColorArrayName[1]

    simple.Show(simple.OutputPort(atoms, 1), view)
    flow = simple.Show(simple.MolecularFlowSurface(Input=atoms, Spacing=1.0), view)
    look.first_look(flow.GetGlobalID())
    assert "MacromoleculeReader" not in visible(view), visible(view)

    # A PQR file and Apply: the surface from red at -5 to blue at 5 kT/e.
    solved = simple.Show(simple.OutputPort(simple.PoissonBoltzmann(Input=atoms, Spacing=1.2), 1), view)
    look.first_look(solved.GetGlobalID())
    assert solved.ColorArrayName[:] == ["POINTS", "Potential"], solved.ColorArrayName
    colours = list(simple.GetColorTransferFunction("Potential").RGBPoints)
    assert (colours[0], colours[-4]) == (-5.0, 5.0), colours
    assert colours[1] > 2 * colours[3] and colours[-1] > 2 * colours[-3], colours
    again = simple.Show(simple.OutputPort(solved.Input, 1), simple.CreateView("RenderView"), "GeometryRepresentation")
    look.colours.colour_by(again, "POINTS", "Potential")
    colours = list(simple.GetColorTransferFunction("Potential").RGBPoints)
    assert (colours[0], colours[-4]) == (-5.0, 5.0), "a second view rescales the legend"
    simple.Delete(simple.GetActiveView())
    simple.SetActiveView(view)

    handles = simple.MapHandles(Input=density, Scalars=["POINTS", "Density"])
    chart = simple.CreateView("XYChartView")
    levels = simple.Show(simple.OutputPort(handles, 2), chart, "XYChartRepresentation")
    look.first_look(levels.GetGlobalID())
    assert levels.XArrayName == "Level" and not levels.UseIndexForXAxis
    assert list(levels.SeriesVisibility) == [name for name, _, _ in look.BETTI], levels.SeriesVisibility
    assert chart.BottomAxisTitle == "Level"
    # The other table of the filter has no column Level: in a chart it keeps ParaView's first look.
    intervals = simple.Show(simple.OutputPort(handles, 3), chart, "XYChartRepresentation")
    look.first_look(intervals.GetGlobalID())
    assert intervals.UseIndexForXAxis and intervals.XArrayName != "Level", intervals.XArrayName

    # The cross-sections in a chart view: the currents over the position; in a spreadsheet all columns.
    tube = simple.PVTrivialProducer()
    tube.GetClientSideObject().SetOutput(channel())
    transport = simple.IonTransport(Input=tube, Spacing=1.0, Padding=5.0, MembraneThickness=8.0)
    chart = simple.CreateView("XYChartView")
    currents = simple.Show(simple.OutputPort(transport, 1), chart, "XYChartRepresentation")
    look.first_look(currents.GetGlobalID())
    assert currents.XArrayName == "Along" and chart.BottomAxisTitle == "Position along the axis (Å)"
    assert sorted(currents.SeriesVisibility) == ["Current", "Current_Cl", "Current_K"], currents.SeriesVisibility
    sheet = simple.CreateView("SpreadSheetView")
    look.first_look(simple.Show(simple.OutputPort(transport, 1), sheet).GetGlobalID())
    assert not {"Along", "Current"} & set(sheet.HiddenColumnLabels), sheet.HiddenColumnLabels


def check_file_without_atoms():
    """ParaView shows a legend of nothing for a molecule without atoms, if it is visible."""
    path = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "words.pdb"
    path.write_text("no molecule\n")
    words = simple.OpenDataFile(str(path))
    view = simple.CreateView("RenderView")
    displays = [simple.Show(simple.OutputPort(words, port), view) for port in (0, 1)]
    look.first_look(*[display.GetGlobalID() for display in displays])
    assert not visible(view), visible(view)
    simple.Delete(view)
    simple.Delete(words)


def check_sites():
    """The best site faces the viewer; the potential is beside it, and the table; all close with their sources."""
    view = simple.GetActiveViewOrCreate("RenderView")
    before = len(simple.GetViews())
    simple.SetActiveSource(simple.OpenDataFile(str(shared_data("molecules/1hew/1hew.pqr"))))
    pipelines.run("protein_to_sites")
    sites = simple.GetActiveSource()
    other, sheet = simple.GetViews()[before:]
    shown = [display for display in other.Representations
             if getattr(display, "Input", None) is not None and display.Input.SMProxy == sites.SMProxy]
    look.first_look(*[display.GetGlobalID() for display in (*shown, *view.Representations)])
    assert shown[0].ColorArrayName[:] == ["POINTS", "Potential"], shown[0].ColorArrayName
    assert sheet.SMProxy.GetXMLName() == "SpreadSheetView" and "Residues" not in sheet.HiddenColumnLabels
    table = servermanager.Fetch(sites, idx=1)
    bounds = sites.GetDataInformation().GetBounds()
    site, place = [], []
    for axis, name in enumerate("XYZ"):
        middle = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1])
        site.append(table.GetValueByName(0, f"Center{name}").ToDouble() - middle)
        place.append(view.CameraPosition[axis] - middle)
    length = [sum(x * x for x in vector) ** 0.5 for vector in (site, place)]
    assert sum(a * b for a, b in zip(site, place)) > 0.99 * length[0] * length[1], (site, place)
    (display,) = [display for display in view.Representations
                  if getattr(display, "Input", None) == sites and display.Visibility]
    assert len(display.LookupTable.Annotations) == 2 * min(6, 1 + table.GetNumberOfRows())
    bar = simple.GetScalarBar(display.LookupTable, view)
    for count in (1, 3):
        colours.set_categories(display.LookupTable, [(str(i), f"site {i}", (0.0, 0.0, 1.0)) for i in range(count)])
        assert abs(bar.ScalarBarLength - 0.05 * count) < 1e-6, f"{count} entries in {bar.ScalarBarLength} of the view"
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    pipelines.forget()
    assert sheet not in simple.GetViews(), "the table stays without its sites"


def check_diagram_of_deleted_loops():
    """ParaView gives the plot of deleted loops their input; it is deleted, and its chart closed."""
    view = simple.CreateView("RenderView")
    surface = simple.OpenDataFile(str(shared_data("surfaces/torus.obj")))
    loops = pipelines.surface_to_loops(surface)[-1]
    simple.SetActiveView(view)
    (chart,) = pipelines.persistence_diagram(loops)
    (plot,) = diagrams.plots_of(loops)
    pipelines.forget()
    assert plot in simple.GetSources().values() and chart in simple.GetViews(), "closed without a cause"
    plot.Input = surface
    simple.Delete(loops)
    pipelines.forget()
    assert plot not in simple.GetSources().values() and chart not in simple.GetViews(), "the diagram stays without its loops"
    simple.Delete(surface)


check_refusal()
check_sites()
check_fault()
check_first_values()
check_looks(*check_buttons())
check_file_without_atoms()
check_diagram_of_deleted_loops()  # last: the plot's script puts numpy's all() in place of Python's
assert servermanager.ActiveConnection is not None
print("buttons and first looks")
