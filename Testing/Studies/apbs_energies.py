"""Compares energies of the examples of APBS with its published values, its values on this machine, and those of
UHBD or exact ones.

Usage: pvpython apbs_energies.py FOLDER [--only WORD ...] [--no-apbs] [--large]

FOLDER is molecules/apbs of the shared data: PQR files, input files (.in) and APBS' README tables. The
columns, in kJ/mol: the surface of APBS' run; published (APBS' README, newest version); APBS here, if it
is installed: the same .in file, or one solvation energy on our grid where there is none; ours on a
surface of the same kind, ours on level 1 of a sum of Gaussians (decay 2.3); UHBD's or an exact value
where there is one. The energies differ mainly because of the surface: srad 0 is the union of the atoms' balls, mol
the solvent-excluded surface, and spl2 a spline smeared over 0.3 angstrom.

--only WORD  the rows whose names have one of the words.
--large      also binding energies of proteins: minutes.
Prints Markdown.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

import evaluate_electrostatics as electrostatics
import solvation_energies
from solvation_energies import COULOMB, KELVIN, box_of, coulomb_between, solvation

WATER = 78.54


class Case:
    """A row: kind of surface ("balls" or "ses"), dielectrics of solute, solvent, reference."""

    def __init__(self, name, files, surface, dielectrics, published=None, other=None, run=None,
                 salt=0.0, kelvin=KELVIN, spacing=0.25, large=False, nonlinear=False, center=None):
        self.name, self.files, self.surface, self.dielectrics = name, files, surface, dielectrics
        self.published, self.other = published, other  # other: (value, whose)
        self.run = run  # (.in file, number of its printed energy)
        self.salt, self.kelvin, self.spacing, self.large = salt, kelvin, spacing, large
        self.nonlinear, self.center = nonlinear, center


def cases():
    vacuum, solvent, ionize = (1.0, WATER, 1.0), (2.0, 78.0, 1.0), (2.0, 78.0, 2.0)
    protein = {"salt": 0.0, "spacing": 0.5}
    rows = [
        Case("Born ion", ["born/ion.pqr"], "ses", vacuum, -229.774,
             (born_energy(3.0, vacuum), "Born's formula"), ("born/apbs-mol-auto.in", 0)),
        Case("methanol", ["solv/methanol.pqr"], "balls", solvent, -36.2486, (-35.595, "UHBD"),
             ("solv/apbs-mol.in", 0), kelvin=300.0),
        Case("methoxide", ["solv/methoxide.pqr"], "balls", solvent, -390.4122, (-390.023, "UHBD"),
             ("solv/apbs-mol.in", 1), kelvin=300.0),
        Case("acetic acid", ["ionize/acetic-acid.pqr"], "balls", ionize, -22.6788, (-22.22, "UHBD"),
             ("ionize/apbs-mol.in", 0), 0.15, 293.0),
        Case("acetate", ["ionize/acetate.pqr"], "balls", ionize, -199.746, (-198.04, "UHBD"),
             ("ionize/apbs-mol.in", 1), 0.15, 293.0),
        Case("proton", ["ionize/proton.pqr"], "balls", ionize, -297.46, (-295.79, "UHBD"),
             ("ionize/apbs-mol.in", 2), 0.15, 293.0),
        Case("two ions, 4 A apart (spl2)", ["ion-pmf/ion-pmf.pdb"], "balls", vacuum, -1125.1924,
             None, ("ion-pmf/ion-pmf.in", 0)),
    ]
    for i, (published, distance) in enumerate(((18.3082, 1), (8.90669, 2), (5.9096, 3), (4.43014, 4))):
        rows.append(Case(f"two charges in water, {distance} A apart",
                         [f"point-pmf/complex-0_{i + 1}.pqr", "point-pmf/mol0.pqr", f"point-pmf/mol{i + 1}.pqr"],
                         "none", (WATER, WATER, WATER), published,
                         (COULOMB / (WATER * distance), "Coulomb's law"), (f"point-pmf/complex-0_{i + 1}.in", -1)))
    rows.append(Case("cytochrome c551, 1/80", ["bem/test_proteins/451c.pqr"], "ses", (1.0, 80.0, 1.0),
                     -4907.441, (-4920.112, "TABI-PB, order 5"), None, 0.15, 300.0, 0.5))
    for name in ("bem/test_proteins/1ajj", "bem/test_proteins/1bbl", "bem/test_proteins/oneb",
                 "bem/test_proteins/twob", "bem/test_proteins/twob2", "misc/fas2", "geoflow/1a63",
                 "geoflow/imidazole_zap", "helix/Membrane-helix-0"):
        rows.append(Case(name.split("/")[-1], [name + ".pqr"], "ses", (2.0, 80.0, 2.0), **protein))
    pka = ["pka-lig/bx6_7_bin_apbs.pqr", "pka-lig/bx6_7_lig_apbs.pqr", "pka-lig/bx6_7_apo_apbs.pqr"]
    rows += [
        Case("kinase and ligand, binding", pka, "balls", (2.0, 78.0, 2.0), 8.08352, (8.876, "UHBD"),
             ("pka-lig/apbs-mol-vdw.in", -1), spacing=0.4, large=True),
        Case("kinase and ligand, binding", pka, "ses", (2.0, 78.0, 2.0), 119.2610, (86.50, "UHBD"),
             ("pka-lig/apbs-mol-surf.in", -1), spacing=0.4, large=True),
        Case("actin dimer, binding, nonlinear",
             ["actin-dimer/complex.pqr", "actin-dimer/mol1.pqr", "actin-dimer/mol2.pqr"], "ses",
             (2.0, 78.4, 2.0), 104.868, (106.7, "UHBD, 1 A"), None, 0.05, spacing=0.7, large=True,
             nonlinear=True),
    ]
    return rows


def born_energy(radius, dielectrics):
    return 0.5 * COULOMB / radius * (1.0 / dielectrics[1] - 1.0 / dielectrics[2])


def read(path):
    """Positions, charges, radii. APBS' ions without charges in the file have 1 e and 2 angstrom."""
    if path.suffix == ".pdb":
        rows = [line.split() for line in path.read_text().splitlines() if line.startswith("ATOM")]
        points = numpy.array([[float(w) for w in row[5:8]] for row in rows])
        return points, numpy.ones(len(rows)), numpy.full(len(rows), 2.0)
    return solvation_energies.read(path)


def energy(case, kind, folder):
    """The solvation energy of one file, or the binding energy of complex, ligand, receptor."""
    molecules = [read(folder / name) for name in case.files]
    whole = molecules[0]
    box = box_of(whole[0], numpy.maximum(whole[2], 2.0 if case.surface == "none" else 0.0), case.spacing)
    parts = [solvation(case, kind, molecule, box) for molecule in molecules]
    if len(parts) == 1:
        return parts[0]
    return parts[0] - parts[1] - parts[2] + coulomb_between(molecules[1], molecules[2], case.dielectrics[0])


def apbs_energies(path):
    """The energies printed by an .in file, kJ/mol; APBS runs in a folder with copies of the files that it reads."""
    with tempfile.TemporaryDirectory() as work:
        for file in path.parent.iterdir():
            if file.suffix in (".pqr", ".pdb", ".dat", ".in"):
                text = file.read_text()
                lines = [line for line in text.splitlines(True) if not line.strip().startswith("write ")]
                if path.name.startswith("complex") or file.name == "ion-pmf.in":
                    lines = [line for line in lines if "apolForce" not in line and "apolEnergy" not in line]
                (Path(work) / file.name).write_text("".join(lines))
        done = subprocess.run(["apbs", path.name], cwd=work, capture_output=True, text=True, timeout=3000)
    return [float(line.split("=")[1].split()[0]) for line in done.stdout.splitlines()
            if "Global net ELEC energy" in line]


def apbs_here(case, folder):
    if case.run:
        printed = apbs_energies(folder / case.run[0])
        return printed[case.run[1]] if printed else float("nan")
    if len(case.files) > 1 or case.nonlinear:
        return None
    settings = {"solute": case.dielectrics[0], "solvent": case.dielectrics[1], "kelvin": case.kelvin,
                "salt": case.salt}
    return 4.184 * electrostatics.apbs_energy(*read(folder / case.files[0]), case.spacing, **settings)


def text(value):
    return "" if value is None else f"{value:.2f}"


def row(case, folder, with_apbs):
    kinds = {"balls": "balls (srad 0)", "ses": "solvent-excluded (mol)", "none": "none"}
    here = apbs_here(case, folder) if with_apbs else None
    ours = energy(case, case.surface, folder)
    gaussian = None if case.surface == "none" else energy(case, "gaussian", folder)
    other = f"{case.other[0]:.2f} ({case.other[1]})" if case.other else ""
    return (f"| {case.name} | {kinds[case.surface]} | {text(case.published)} | {text(here)} "
            f"| {text(ours)} | {text(gaussian)} | {other} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--no-apbs", action="store_true")
    parser.add_argument("--large", action="store_true")
    options = parser.parse_args()
    chosen = [case for case in cases() if (options.large or not case.large) and
              (not options.only or any(word.lower() in case.name.lower() for word in options.only))]
    if not chosen:
        sys.exit("No row has one of these words in its name. The rows are: " + ", ".join(case.name for case in cases()))
    print("| molecule | surface | APBS, published | APBS here | ours | ours, Gaussian | other |")
    print("|---|---|---|---|---|---|---|")
    for case in chosen:
        print(row(case, options.folder, not options.no_apbs), flush=True)


if __name__ == "__main__":
    main()
