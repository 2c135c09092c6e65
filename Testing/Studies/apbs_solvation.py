"""The polar part of a solvation energy by APBS (srfm mol): two solutions, with the solvent and without."""

import re
import subprocess
import tempfile
from pathlib import Path

INPUT = """read
  mol pqr molecule.pqr
end
elec name solv
{common}  sdie {solvent}
{ions}end
elec name ref
{common}  sdie {solute}
end
print elecEnergy solv - ref end
quit
"""
COMMON = """  mg-manual
  dime {n[0]} {n[1]} {n[2]}
  grid {h} {h} {h}
  gcent {center}
  mol 1
  lpbe
  bcfl mdh
  pdie {solute}
  srfm mol
  chgm spl0
  srad 1.4
  swin 0.3
  sdens 10.0
  temp {kelvin}
  calcenergy total
  calcforce no
"""
KILOJOULES = 4.184  # a kilocalorie


def input_text(counts, h, center, solute, solvent, kelvin=298.15, salt=0.0):
    """The input file of APBS; center as in gcent, salt is the concentration of a 1:1 salt in mol/l."""
    common = COMMON.format(n=counts, h=h, center=center, solute=solute, kelvin=kelvin)
    ions = "".join(f"  ion charge {z} conc {salt} radius 2.0\n" for z in (1, -1)) if salt else ""
    return INPUT.format(common=common, solute=solute, solvent=solvent, ions=ions)


def energy(pqr, text, timeout=None):
    """kcal/mol of the molecule that `pqr` (the text of a PQR file) describes."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "molecule.pqr").write_text(pqr)
        (Path(folder) / "in").write_text(text)
        done = subprocess.run(
            ["apbs", "in"], cwd=folder, capture_output=True, text=True, check=True, timeout=timeout)
    return float(re.findall(r"Global net ELEC energy = ([-\d.E+]+) kJ/mol", done.stdout)[-1]) / KILOJOULES
