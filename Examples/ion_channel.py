"""Shows what the current through gramicidin depends on. Makes a table, the current-voltage curve, and a picture of the
paths of the ions.

Usage: pvpython ion_channel.py [--spacing H] [--pictures-only] [FOLDER]

For surfaces from the bare atoms to half a square angstrom of flow, and for all or a quarter of the ions'
diffusion in the channel: the current at 100 mV, the share carried by potassium, and the radius at the bottleneck;
prints Markdown (takes about two minutes at 0.5 angstrom). Writes ion_channel_curve.png and ion_channel_lines.png
into FOLDER (default: a temporary folder, which is printed). Reads 1GRM from $ISTHMUS_DATA_DIR, else from
../shared/data beside the clone.
"""

import argparse
import os
import subprocess
from pathlib import Path

from paraview import simple

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus
from gramicidin import AXIS, with_charges
from output_folder import output_folder
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkTable

HERE = Path(__file__).resolve().parent
FILE = "molecules/channels/1grm_hole_example.pdb"
PORE_TIME = 0.25  # square angstrom of flow: the recipe that keeps the pore and closes the creases in its wall
SURFACES = (("the atoms", {"probe": 0.0}), ("solvent-excluded, probe 1.0 (default)", {"probe": 1.0}),
            ("solvent-excluded, probe 1.4", {"probe": 1.4}),
            ("flow of 0.1 square angstrom", {"time": 0.1}),
            ("flow of 0.25 square angstrom", {"time": PORE_TIME}), ("flow of 0.5 square angstrom", {"time": 0.5}))


def data_file():
    for folder in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), HERE.parents[1] / "shared" / "data")):
        if (Path(folder) / FILE).is_file():
            return Path(folder) / FILE
    raise SystemExit(f"There is no {FILE}: set ISTHMUS_DATA_DIR.")


def molecule():
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(data_file()))
    reader.Update()
    return with_charges(reader.GetOutput())


def middle_of(atoms):
    return [float(x) for x in vtk_to_numpy(atoms.GetPoints().GetData()).mean(axis=0)]


def number(output, name):
    return output.GetFieldData().GetArray(name).GetValue(0)


def flow_surface(atoms, time, spacing):
    flow = isthmus.vtkMolecularFlowSurface()
    flow.SetInputData(atoms)
    flow.SetEvolutionTime(time)
    flow.SetSpacing(0.8 * spacing)
    flow.Update()
    return flow.GetOutput()


def transport_filter(atoms, spacing, molar=0.1, fraction=1.0, probe=1.0, time=None):
    """Ion transport at 100 mV; not executed."""
    filter_ = isthmus.vtkIonTransport()
    filter_.SetInputData(0, atoms)
    if time is not None:
        filter_.SetInputData(1, flow_surface(atoms, time, spacing))
    filter_.SetProbeRadius(probe)
    filter_.SetMembraneCenter(*middle_of(atoms))
    filter_.SetMembraneNormal(*AXIS)
    filter_.SetLumenRadius(4.0)
    filter_.SetPadding(5.0)
    filter_.SetSpacing(spacing)
    filter_.ClearSpecies()
    filter_.AddSpecies(1.0, molar, molar, 1.96, fraction)
    filter_.AddSpecies(-1.0, molar, molar, 2.03, fraction)
    return filter_


def table(atoms, spacing):
    print("| surface | salt, mol/l | diffusion in the channel | current, pA | part of potassium | bottleneck, angstrom |")
    print("|---|---|---|---|---|---|")
    for name, choice in SURFACES:
        cases = [(0.1, 1.0)]
        if choice.get("time") == PORE_TIME or choice.get("probe") == 1.0:
            cases += [(0.1, 0.25), (1.0, 1.0), (1.0, 0.25)]
        for molar, fraction in cases:
            filter_ = transport_filter(atoms, spacing, molar, fraction, **choice)
            filter_.Update()
            volume = filter_.GetOutput()
            current = number(volume, "Current")
            print(f"| {name} | {molar} | {fraction} | {current:.2f} | {number(volume, 'Current_K') / current:.3f} "
                  f"| {number(volume, 'BottleneckRadius'):.1f} |", flush=True)


def channel(atoms, spacing):
    """Ion Transport On Surface in ParaView."""
    source = simple.PVTrivialProducer(registrationName="Gramicidin")
    source.GetClientSideObject().SetOutput(atoms)
    surface = simple.MolecularFlowSurface(Input=source, EvolutionTime=PORE_TIME, Spacing=0.8 * spacing)
    return simple.IonTransportOnSurface(
        Input=source, Surface=surface, MembraneCenter=middle_of(atoms), MembraneNormal=list(AXIS), LumenRadius=4.0,
        Spacing=spacing, Padding=5.0)


def reduce(picture):
    # 128 colours keep a picture below 200 KB; without ImageMagick it is larger.
    subprocess.run(["convert", str(picture), "-colors", "128", str(picture)], check=False)


def currents_by_voltage(filter_, voltages, names=("Current_K", "Current_Cl", "Current")):
    """A vtkTable with a row for each voltage (mV): Voltage, and currents in pA."""
    rows = []
    for voltage in voltages:
        filter_.SetVoltage(voltage)
        filter_.Update()
        rows.append([voltage] + [number(filter_.GetOutput(), name) for name in names])
    table = vtkTable()
    for name, values in zip(("Voltage", *names), zip(*rows)):
        column = vtkDoubleArray()
        column.SetName(name)
        for value in values:
            column.InsertNextValue(value)
        table.AddColumn(column)
    return table


def curve(table, picture):
    """Shows currents over voltages as a chart."""
    source = simple.PVTrivialProducer(registrationName="Currents by voltage")
    source.GetClientSideObject().SetOutput(table)
    chart = simple.CreateView("XYChartView")
    chart.ViewSize = [700, 500]
    shown = simple.Show(source, chart, "XYChartRepresentation")
    shown.UseIndexForXAxis = 0
    shown.XArrayName = "Voltage"
    names = ("Current_K", "Current_Cl", "Current")
    shown.SeriesVisibility = list(names)
    shown.SeriesLabel = [text for pair in zip(names, ("potassium", "chloride", "both")) for text in pair]
    shown.SeriesMarkerStyle = [text for name in names for text in (name, "4")]
    shown.SeriesLineThickness = [text for name in names for text in (name, "2")]
    shown.SeriesColor = [text for pair in zip(names, ("0.84 0.37 0", "0 0.45 0.7", "0 0 0"))
                         for text in (pair[0], *pair[1].split())]
    chart.BottomAxisTitle = "voltage, mV"
    chart.LeftAxisTitle = "current, pA"
    chart.LegendLocation = "TopLeft"
    simple.SaveScreenshot(str(picture), chart, ImageResolution=[700, 500])
    reduce(picture)


def lines(solution, atoms, picture):
    """Streamlines of the current, with the walls cut open and coloured by the potential."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [900, 700]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    middle = middle_of(atoms)
    ways = simple.StreamTracer(Input=solution, Vectors=["POINTS", "CurrentDensity"], SeedType="Point Cloud",
                               MaximumStreamlineLength=150.0)
    ways.SeedType.Center = middle
    ways.SeedType.Radius = 1.2
    ways.SeedType.NumberOfPoints = 40
    tubes = simple.Tube(Input=ways, Radius=0.05)
    walls = simple.Contour(Input=solution, ContourBy=["POINTS", "SignedDistance"], Isosurfaces=[0.0])
    half = simple.Clip(Input=walls, ClipType="Plane")
    half.ClipType.Origin = middle
    half.ClipType.Normal = [0.0, 0.0, 1.0]
    shown = simple.Show(half, view)
    simple.ColorBy(shown, ("POINTS", "Potential"))
    colours = simple.GetColorTransferFunction("Potential")
    colours.AutomaticRescaleRangeMode = "Never"
    colours.InvertTransferFunction()  # red is negative
    bar = simple.GetScalarBar(colours, view)
    bar.TitleColor = bar.LabelColor = [0.1, 0.1, 0.1]
    bar.Title, bar.ComponentTitle = "potential, kT/e", ""
    drawn = simple.Show(tubes, view)
    simple.ColorBy(drawn, None)
    colours.RescaleTransferFunction(-5.0, 5.0)
    drawn.DiffuseColor = drawn.AmbientColor = [0.1, 0.1, 0.1]
    view.CameraPosition = [middle[0], middle[1], middle[2] + 90]
    view.CameraFocalPoint = middle
    view.CameraViewUp = [0, 1, 0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(1.2)
    simple.SaveScreenshot(str(picture), view, ImageResolution=[900, 700])
    reduce(picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("--spacing", default=0.5, type=float)
    parser.add_argument("--pictures-only", action="store_true")
    choice = parser.parse_args()
    folder = output_folder(choice.folder)
    atoms = molecule()
    if not choice.pictures_only:
        table(atoms, choice.spacing)
    solution = channel(atoms, choice.spacing)
    solution.UpdatePipeline()
    voltages = range(-200, 201, 50)
    curve(currents_by_voltage(transport_filter(atoms, choice.spacing, time=PORE_TIME), voltages),
          folder / "ion_channel_curve.png")
    lines(solution, atoms, folder / "ion_channel_lines.png")
    print("\nPictures:", folder)


if __name__ == "__main__":
    main()
