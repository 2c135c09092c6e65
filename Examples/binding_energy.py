"""The electrostatic binding energy of two molecules: that of the complex minus those of the partners, from three
solutions on the same grid.

Usage: pvpython binding_energy.py ONE.pqr OTHER.pqr [--surface KIND] [--spacing H] [--salt MOL]
                                  [--solute NUMBER] [--solvent NUMBER] [--nonlinear]

The molecules must be placed as in their complex. Each of complex, ONE and OTHER has the same surface and the same
nodes; KIND: gaussian (level 1 of a sum of Gaussians of decay 2.3, the default), balls (van der Waals)
or ses (solvent-excluded, probe 1.4; each on a grid of its own, nodes at multiples of H).

binding = solvation(complex) - solvation(ONE) - solvation(OTHER) + Coulomb's energy between ONE and OTHER
in the solute's dielectric; all in kcal/mol. The molecules are treated as rigid: conformational changes, entropy and
the nonpolar part are not included. It is a small difference of large energies and depends mostly on the surface.
"""

import argparse
import sys
from pathlib import Path

import numpy

import solvation_energies

JOULE = 4.184


def settings(spacing=0.5, salt=0.0, solute=2.0, solvent=80.0, nonlinear=False):
    return solvation_energies.Settings((solute, solvent, solute), salt, solvation_energies.KELVIN, spacing, nonlinear)


def binding(partners, kind, case):
    """kJ/mol: solvation of the complex and of both partners, Coulomb, binding."""
    whole = tuple(numpy.concatenate(parts) for parts in zip(*partners))
    box = solvation_energies.box_of(whole[0], whole[2], case.spacing)
    solvation = [solvation_energies.solvation(case, kind, molecule, box) for molecule in (whole, *partners)]
    coulomb = solvation_energies.coulomb_between(*partners, case.dielectrics[0])
    return {"solvation": solvation, "coulomb": coulomb,
            "binding": solvation[0] - solvation[1] - solvation[2] + coulomb}


def demand_apart(partners):
    """Two atoms are at the same position, so this is not a complex: are both files the same molecule, or not placed
    as in the complex?"""
    (one, _, _), (other, _, _) = partners
    least = min(numpy.sqrt(((other - place) ** 2).sum(axis=1)).min() for place in one)
    if least < 0.5:
        sys.exit(f"An atom of the one lies {least:.2f} angstrom from one of the other: give two molecules as they "
                 "lie in their complex.")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("one", type=Path)
    parser.add_argument("other", type=Path)
    parser.add_argument("--surface", choices=("gaussian", "balls", "ses"), default="gaussian")
    parser.add_argument("--spacing", type=float, default=0.5)
    parser.add_argument("--salt", type=float, default=0.0)
    parser.add_argument("--solute", type=float, default=2.0)
    parser.add_argument("--solvent", type=float, default=80.0)
    parser.add_argument("--nonlinear", action="store_true")
    chosen = parser.parse_args()
    case = settings(chosen.spacing, chosen.salt, chosen.solute, chosen.solvent, chosen.nonlinear)
    partners = [solvation_energies.read(path) for path in (chosen.one, chosen.other)]
    demand_apart(partners)
    parts = binding(partners, chosen.surface, case)
    if not numpy.isfinite(parts["binding"]):
        sys.exit("There is no binding energy, since one of the solutions failed (see above).")
    print(f"{'kcal/mol':34}{'complex':>12}{chosen.one.stem:>16}{chosen.other.stem:>16}")
    print(f"{'solvation':34}" + "".join(f"{value / JOULE:{width}.2f}" for value, width in
                                        zip(parts["solvation"], (12, 16, 16))))
    print(f"{'Coulomb between them':34}{parts['coulomb'] / JOULE:12.2f}")
    print(f"{'electrostatic binding energy':34}{parts['binding'] / JOULE:12.2f}")


if __name__ == "__main__":
    main()
