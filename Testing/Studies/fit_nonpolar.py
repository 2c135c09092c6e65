"""Fits surface tension and pressure of the nonpolar solvation energy to measured energies of molecules.

Usage: pvpython fit_nonpolar.py TABLE.csv [--spacing ANGSTROM] [--no-pressure]

TABLE.csv has a line "file,energy" for each molecule: a file that Macromolecule Reader reads, relative to the table,
and the target energy in kcal/mol (of a molecule without charges: its hydration energy). A first line without a
number is a header; lines that begin with # are comments.

The energy is tension x area + pressure x volume + dispersion (Nonpolar Solvation; X. Feng, PhD thesis, 4.3 to 4.6 and
5.4, where the tension is fitted), with the minimal molecular surface of Molecular Flow Surface.
Prints both parameters with their standard errors, the energy of each molecule as fitted and as predicted from the
others, and the rms of both.

--spacing ANGSTROM  of the grid of the surfaces, 0.25 unless given.
--no-pressure  fits the tension alone; the pressure is 0.
"""

import csv
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parent))
import study_paths  # noqa: E402,F401 (before isthmus)
import isthmus  # noqa: E402


def read_table(path):
    """[(file, energy)]"""
    rows = []
    for number, row in enumerate(csv.reader(path.read_text().splitlines()), 1):
        if not row or row[0].startswith("#"):
            continue
        try:
            rows.append((path.parent / row[0].strip(), float(row[1])))
        except (IndexError, ValueError):
            if rows or number > 1:
                raise SystemExit(f"{path}, line {number}: {','.join(row)!r} is not a file and an energy.") from None
    return rows


def terms(file, spacing):
    """Area (square angstrom), volume (cubic angstrom) and dispersion energy (kcal/mol) of a molecule."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(file))
    flow = isthmus.vtkMolecularFlowSurface()
    flow.SetInputConnection(reader.GetOutputPort())
    flow.SetSteady(True)
    flow.SetSpacing(spacing)
    energy = isthmus.vtkNonpolarSolvation()
    energy.SetInputConnection(0, reader.GetOutputPort())
    energy.SetInputConnection(1, flow.GetOutputPort(1))
    energy.Update()
    table = energy.GetOutputDataObject(1)
    if table.GetNumberOfRows() == 0:
        raise SystemExit(f"{file}: no energy; the message above has the reason.")
    return [table.GetValueByName(0, name).ToDouble() for name in ("Area", "Volume", "DispersionEnergy")]


def fit(rows, wanted):
    """(parameters, their standard errors, fitted values, values predicted from the other rows)"""
    found = numpy.linalg.lstsq(rows, wanted, rcond=None)[0]
    freedom = len(wanted) - rows.shape[1]
    variance = numpy.sum((rows @ found - wanted) ** 2) / freedom if freedom else numpy.nan
    errors = numpy.sqrt(variance * numpy.diag(numpy.linalg.inv(rows.T @ rows)))
    predicted = []
    for i in range(len(wanted)):
        others = numpy.arange(len(wanted)) != i
        predicted.append(rows[i] @ numpy.linalg.lstsq(rows[others], wanted[others], rcond=None)[0])
    return found, errors, rows @ found, numpy.array(predicted)


def fit_table(path, spacing=0.25, with_pressure=True):
    """Prints the fit; (tension, pressure)."""
    table = read_table(Path(path))
    least = 4 if with_pressure else 3
    if len(table) < least:
        raise SystemExit(f"{path} has {len(table)} molecules, but the fit takes at least {least}.")
    measured = numpy.array([energy for _, energy in table])
    parts = numpy.array([terms(file, spacing) for file, _ in table])
    rows = parts[:, :2] if with_pressure else parts[:, :1]
    found, errors, fitted, predicted = fit(rows, measured - parts[:, 2])
    print(f"{'molecule':24}{'area, A^2':>11}{'volume, A^3':>13}{'dispersion':>12}{'measured':>10}{'fitted':>9}"
          f"{'from others':>13}   (kcal/mol)")
    for (file, energy), (area, volume, dispersion), one, other in zip(table, parts, fitted, predicted):
        print(f"{file.stem:24}{area:11.2f}{volume:13.2f}{dispersion:12.2f}{energy:10.2f}{one + dispersion:9.2f}"
              f"{other + dispersion:13.2f}")
    off = numpy.stack([fitted, predicted]) + parts[:, 2] - measured
    print(f"rms of the fit {numpy.sqrt(numpy.mean(off[0] ** 2)):.3f}, of predictions from the others "
          f"{numpy.sqrt(numpy.mean(off[1] ** 2)):.3f} kcal/mol")
    tension, pressure = [*found, 0.0][:2]
    print(f"SurfaceTension {tension:.5f} +- {errors[0]:.5f} kcal/mol/A^2")
    print(f"Pressure {pressure:.5f} +- {[*errors, 0.0][1]:.5f} kcal/mol/A^3")
    return tension, pressure


def main(words):
    if not words or "--help" in words or "-h" in words:
        print(__doc__)
        return
    spacing = 0.25
    if "--spacing" in words:
        at = words.index("--spacing")
        spacing = float(words[at + 1])
        del words[at:at + 2]
    with_pressure = "--no-pressure" not in words
    names = [word for word in words if word != "--no-pressure"]
    if len(names) != 1:
        raise SystemExit("Give one table: fit_nonpolar.py --help.")
    fit_table(names[0], spacing, with_pressure)


if __name__ == "__main__":
    main(sys.argv[1:])
