"""Measures how much the energies of Solvation Surface depend on its settings, and how close they are to those of
other programs.

Usage: pvpython evaluate_solvation.py [--policies] [--molecules] [--picture] [FOLDER]

--policies: lysozyme (1HEW) at 0.7 angstrom with every update policy: updates, energies, their spread
(two minutes). --molecules: small molecules compared with APBS on the same grid, APBS' geometric flow, and
experiment; with the constants fitted to alkanes, and with constants fitted to all other molecules (a minute). --picture:
figure 5.3 of the thesis, the potential on lysozyme's surfaces in the same colours, as
solvation_potential.png in FOLDER (default: a temporary folder, which is
printed). Without any of them: all. Prints Markdown. Reads the data from $ISTHMUS_DATA_DIR, else from ../shared/data
beside the clone; --molecules needs apbs.
"""

import argparse
import os
import subprocess
from pathlib import Path

import numpy

import apbs_solvation
import study_paths  # noqa: F401 (before isthmus)
import isthmus
from output_folder import output_folder

HERE = Path(__file__).resolve().parent
LYSOZYME = "molecules/1hew/1hew.pqr"
SOLUTE, SOLVENT, SPACING = 1.5, 80.0, 0.25  # as in APBS' geometric flow examples
# Experiments, kcal/mol: FreeSolv 0.52 (D. L. Mobley, J. P. Guthrie, J. Comput.-Aided Mol. Des. 28 (2014) 711).
# Geometric flow: APBS' README of the example, polar + nonpolar; Debian's APBS is built without it.
MOLECULES = (("methanol", "solv/methanol.pqr", -5.10, None),
             ("acetic acid", "ionize/acetic-acid.pqr", -6.69, None),
             ("imidazole", "geoflow/imidazole_zap.pqr", -9.63, (-10.3022, 0.541742)),
             ("glyceryl triacetate", "geoflow/gly.pqr", -8.84, None),
             ("methoxide", "solv/methoxide.pqr", None, None), ("acetate", "ionize/acetate.pqr", None, None),
             ("ion of 3 angstrom", "born/ion.pqr", None, None))


def data(relative):
    for folder in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), HERE.parents[2] / "shared" / "data")):
        if (Path(folder) / relative).exists():
            return Path(folder) / relative
    raise SystemExit(f"There is no {relative}: set ISTHMUS_DATA_DIR.")


def solvation(path, **properties):
    """Columns of the last update, and the number of updates."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    surface = isthmus.vtkSolvationSurface()
    surface.SetInputConnection(reader.GetOutputPort())
    for name, value in properties.items():
        getattr(surface, f"Set{name}")(value)
    surface.Update()
    table = surface.GetUpdates()
    last = table.GetNumberOfRows() - 1
    return {table.GetColumnName(i): table.GetValue(last, i).ToDouble()
            for i in range(table.GetNumberOfColumns())}, last + 1


def policies():
    print("| period | alpha' | updates | polar, kcal/mol | total, kcal/mol |")
    print("|---|---|---|---|---|")
    totals = []
    for relaxation in (1.0, 0.5):
        for period in (10, 20, 50, 100):
            found, updates = solvation(data(LYSOZYME), Spacing=0.7, UpdatePeriod=period, AdaptiveUpdate=False,
                                       FieldRelaxation=relaxation)
            totals.append((found["PolarEnergy"], found["TotalEnergy"]))
            print(f"| {period} | {relaxation} | {updates} | {totals[-1][0]:.2f} | {totals[-1][1]:.2f} |", flush=True)
    for name, values in zip(("polar", "total"), zip(*totals)):
        print(f"\nSpread of the {name} energy: {100 * abs((max(values) - min(values)) / min(values)):.4f} %")


def apbs_polar(path):
    """Energy in kcal/mol with APBS' molecular surface on a grid of the same spacing."""
    text = apbs_solvation.input_text((97, 97, 97), SPACING, "mol 1", SOLUTE, SOLVENT)
    return apbs_solvation.energy(path.read_text(), text, timeout=300)


def left_out(rows):
    """Errors of the total energy of each molecule, with tension and pressure fitted to all others; columns: area,
    volume, the remaining energy, experiment."""
    table = numpy.array(rows)
    errors = []
    for i, (area, volume, rest, wanted) in enumerate(table):
        others = table[numpy.arange(len(table)) != i]
        fit = numpy.linalg.lstsq(others[:, :2], others[:, 3] - others[:, 2], rcond=None)[0]
        errors.append(area * fit[0] + volume * fit[1] + rest - wanted)
    return errors


def molecules():
    print("| molecule | polar | APBS' polar | nonpolar | total | APBS' geometric flow | experiment | error |")
    print("|---|---|---|---|---|---|---|---|")
    names, rows = [], []
    for name, file, experiment, flow in MOLECULES:
        path = data(Path("molecules/apbs") / file)
        found, _ = solvation(path, Spacing=SPACING, SoluteDielectric=SOLUTE, SolventDielectric=SOLVENT)
        total = found["TotalEnergy"]
        print(f"| {name} | {found['PolarEnergy']:.2f} | {apbs_polar(path):.2f} | {found['NonpolarEnergy']:.2f} "
              f"| {total:.2f} | {f'{flow[0]:.2f} + {flow[1]:.2f}' if flow else ''} "
              f"| {experiment if experiment else ''} | {f'{total - experiment:.2f}' if experiment else ''} |",
              flush=True)
        if experiment:
            names.append(name)
            rows.append((found["Area"], found["Volume"], found["PolarEnergy"] + found["DispersionEnergy"],
            experiment))
    errors = left_out(rows)
    print("\nErrors by tension and pressure fitted to the others of these, each left out: " + ", ".join(
        f"{name} {error:.2f}" for name, error in zip(names, errors)) +
        f"; rms {numpy.sqrt(numpy.mean(numpy.square(errors))):.2f} kcal/mol. Alkanes, which have no polar energy: "
        "Testing/Python/NonpolarSolvation.py.")


def picture(path):
    """The potential on the probe's surface, on the converged one and on the thesis' fine one, from the same
    camera."""
    from paraview import servermanager, simple
    atoms = simple.OpenDataFile(str(data(LYSOZYME)))
    panels = []
    for title, properties in (("Solvent-excluded, probe 1.4", {"Method": "Solvent Excluded", "ProbeRadius": 1.4}),
                              ("Flow, converged in the field", None), ("Flow, fine (no probe)", {"Preset": "Fine"})):
        if properties is None:
            panels.append((title, simple.SolvationSurface(Input=atoms, Spacing=0.5)))
            continue
        surface = simple.MolecularFlowSurface(Input=atoms, Spacing=0.5, **properties)
        solved = simple.PoissonBoltzmannOnSurface(Input=atoms, Surface=surface, Spacing=0.5)
        panels.append((title, servermanager.OutputPort(solved, 1)))
    layout = simple.CreateLayout("Figure 5.3")
    layout.SplitHorizontal(0, 1.0 / 3.0)
    layout.SplitHorizontal(2, 0.5)
    camera = None
    for hint, (title, shown) in zip((1, 5, 6), panels):
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view, layout, hint)
        view.UseColorPaletteForBackground = 0
        view.Background = [1.0, 1.0, 1.0]
        view.OrientationAxesVisibility = 0
        display = simple.Show(shown, view)
        simple.ColorBy(display, ("POINTS", "Potential"))
        display.SetScalarBarVisibility(view, False)
        text = simple.Text(Text=title)
        label = simple.Show(text, view)
        label.Color, label.FontSize = [0.0, 0.0, 0.0], 9
        simple.ResetCamera(view)
        simple.GetActiveCamera().Zoom(1.3)
        camera = camera or view
        view.CameraPosition, view.CameraFocalPoint = camera.CameraPosition, camera.CameraFocalPoint
    colours = simple.GetColorTransferFunction("Potential")
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RescaleTransferFunction(-5.0, 5.0)
    colours.InvertTransferFunction()  # red is negative
    simple.SaveScreenshot(str(path), layout, ImageResolution=[1200, 420])
    # 128 colours keep a picture below 200 KB; without ImageMagick it is larger.
    subprocess.run(["convert", str(path), "-colors", "128", str(path)], check=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path)
    for part in ("policies", "molecules", "picture"):
        parser.add_argument(f"--{part}", action="store_true")
    choice = parser.parse_args()
    everything = not (choice.policies or choice.molecules or choice.picture)
    if choice.policies or everything:
        policies()
    if choice.molecules or everything:
        molecules()
    if choice.picture or everything:
        path = output_folder(choice.folder) / "solvation_potential.png"
        picture(path)
        print(path)


if __name__ == "__main__":
    main()
