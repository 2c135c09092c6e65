"""From a PDB file to charges and a potential by pdb2pqr and APBS, without the ligand.

Needs the programs pdb2pqr (or pdb2pqr30) and apbs; Debian has both.
"""

import collections
import gzip
import re
import shutil
import subprocess
import sys
from pathlib import Path

WATER = ("HOH", "WAT", "DOD")
INCOMPLETE = re.compile(r"reconstruct or cap residue (\S+) (\S) (-?\d+)")
GRID_SIDES = [32 * c + 1 for c in range(1, 17)]  # numbers of nodes that APBS' multigrid accepts
INPUT = """read
  mol pqr {pqr}
end
elec name solvated
  mg-manual
  dime {dime[0]} {dime[1]} {dime[2]}
  grid {spacing} {spacing} {spacing}
  gcent {center[0]} {center[1]} {center[2]}
  mol 1
  lpbe
  bcfl sdh
  pdie 2.0
  sdie 78.54
  ion charge 1 conc 0.150 radius 2.0
  ion charge -1 conc 0.150 radius 2.0
  srfm smol
  chgm spl2
  sdens 10.0
  srad 1.4
  swin 0.3
  temp 298.15
  calcenergy no
  calcforce no
  write pot dx {potential}
end
quit
"""


def programs():
    """The paths (pdb2pqr, apbs), each None if not installed."""
    return shutil.which("pdb2pqr") or shutil.which("pdb2pqr30"), shutil.which("apbs")


def open_text(path):
    """A molecule's file for reading. A file that is not text has no atom lines, which is reported later."""
    plain = gzip.open if str(path).endswith(".gz") else open
    return plain(path, "rt", encoding="ascii", errors="replace")


def require_atoms(path):
    """Exits with a message unless path is a PDB file."""
    if not Path(path).is_file():
        sys.exit(f"There is no file {path}.")
    if next(atom_lines(path), None) is None:
        sys.exit(f"{path} has no ATOM records: a PDB file is needed.")


def is_mmcif(path):
    return str(path).lower().removesuffix(".gz").endswith((".cif", ".mmcif"))


def lines_of_mmcif(path):
    """The atoms of an mmCIF file as PDB lines, which the following functions use."""
    import find_isthmus  # noqa: F401 (before isthmus)
    import isthmus

    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    reader.Update()
    atoms = reader.GetOutput()
    data, fields = atoms.GetPointData(), atoms.GetFieldData()
    symbols = fields.GetAbstractArray("ElementSymbols")

    def text(name, i):
        return data.GetAbstractArray(name).GetValue(i)

    for i in range(atoms.GetNumberOfPoints()):
        name, element = text("AtomName", i), symbols.GetValue(int(text("Element", i)))
        name = name if len(name) >= 4 or len(element) == 2 else " " + name
        record = "HETATM" if text("IsHetero", i) else "ATOM  "
        yield "%s%5d %-4s %3s %s%4d    %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n" % (
            record, (i + 1) % 100000, name, text("ResidueName", i)[:3], (text("Chain", i) or " ")[0],
            text("ResidueId", i), *atoms.GetPoint(i), text("Occupancy", i), text("BFactor", i),
            element.upper())


def atom_lines(path):
    """ATOM and HETATM lines of the first model."""
    if is_mmcif(path):
        yield from lines_of_mmcif(path)
        return
    with open_text(path) as file:
        for line in file:
            if line.startswith("ENDMDL"):
                return
            if line.startswith(("ATOM  ", "HETATM")):
                yield line


def residue_of(line):
    """(name, chain, number with insertion code) of a PDB line."""
    return line[17:20].strip(), line[21].strip(), line[22:27].strip()


def position_of(line):
    return tuple(float(line[start : start + 8]) for start in (30, 38, 46))


def is_heavy(line):
    element = line[76:78].strip() or line[12:16].strip().lstrip("0123456789")[:1]
    return element.upper() not in ("H", "D")


def polymer_names(path):
    """Names of the residues that the file's SEQRES and MODRES records call part of a chain."""
    names = set()
    with open_text(path) as file:
        for line in file:
            if line.startswith("SEQRES"):
                names.update(line[19:].split())
            elif line.startswith("MODRES"):
                names.add(line[12:15].strip())
            elif line.startswith(("ATOM", "HETATM")):
                return names
    return names


def split(path, ligand=None):
    """The lines of the protein (everything except water and the ligand), the lines of the ligand's heavy atoms, and
    the ligand's name.

    `ligand`: residue name. With None, the ligand is the largest HETATM residue with at least six heavy atoms that
    is neither water nor part of a chain (like phosphorylated amino acids).
    """
    lines = [line for line in atom_lines(path) if line[17:20].strip() not in WATER]
    if ligand is None:
        chain = polymer_names(path)
        sizes = collections.Counter(
            line[17:20].strip() for line in lines if line.startswith("HETATM") and is_heavy(line)
        )
        large = [name for name, size in sizes.items() if size >= 6 and name not in chain]
        ligand = max(large, key=sizes.get, default=None)
    protein = [line for line in lines if line[17:20].strip() != ligand]
    bound = [line for line in lines if line[17:20].strip() == ligand and is_heavy(line)]
    return protein, bound, ligand


def charges(protein, folder, name):
    """Runs pdb2pqr on the lines of a protein.

    Returns the path of the PQR file, the residues removed because pdb2pqr cannot build them, and those dropped
    because its force field lacks them (phosphorylated ones, metals, solvent).
    """
    program = programs()[0]
    removed = []
    pdb, pqr = Path(folder) / f"{name}_protein.pdb", Path(folder) / f"{name}.pqr"
    while True:
        pdb.write_text("".join(protein) + "END\n")
        command = [program, "--ff=AMBER", "--keep-chain", "--drop-water", "--nodebump", "--noopt"]
        done = subprocess.run(
            [*command, str(pdb), str(pqr)], capture_output=True, text=True, timeout=600
        )
        if done.returncode == 0:
            break
        missing = INCOMPLETE.search(done.stderr + done.stdout)
        if not missing:
            raise RuntimeError(f"pdb2pqr failed on {name}:\n{done.stderr[-2000:]}")
        residue = missing.groups()
        removed.append(" ".join(residue))
        protein = [line for line in protein if residue_of(line) != residue]
    kept = {tuple(line[21:27].split()) for line in open(pqr) if line.startswith(("ATOM", "HETATM"))}
    dropped = []
    for line in protein:
        residue = residue_of(line)
        label = " ".join(residue)
        if residue[1:] not in kept and label not in dropped:
            dropped.append(label)
    return pqr, removed, dropped


def read_pqr(path):
    """Rows of x, y, z, charge, radius."""
    lines = (line for line in open(path) if line.startswith(("ATOM", "HETATM")))
    return [tuple(float(word) for word in line.split()[-5:]) for line in lines]


def potential(pqr, folder, name, spacing=0.6, margin=10.0):
    """Runs APBS (linearised Poisson-Boltzmann, 0.15 M salt); path of the potential in kT/e.

    The grid reaches `margin` angstrom beyond the atoms' centers on all sides.
    """
    atoms = read_pqr(pqr)
    low = [min(atom[a] for atom in atoms) for a in range(3)]
    high = [max(atom[a] for atom in atoms) for a in range(3)]
    sides = [(high[a] - low[a] + 2.0 * margin) / spacing + 1 for a in range(3)]
    dime = [next(n for n in GRID_SIDES if n >= side) for side in sides]
    center = [(low[a] + high[a]) / 2.0 for a in range(3)]
    stem = Path(folder) / f"{name}_potential"
    settings = Path(folder) / f"{name}.in"
    settings.write_text(
        INPUT.format(pqr=pqr, dime=dime, spacing=spacing, center=center, potential=stem)
    )
    done = subprocess.run(
        [programs()[1], str(settings)], capture_output=True, text=True, timeout=1800, cwd=folder
    )
    # An APBS with MPI adds the number of the process.
    written = [path for path in (Path(f"{stem}.dx"), Path(f"{stem}-PE0.dx")) if path.exists()]
    if done.returncode != 0 or not written:
        raise RuntimeError(f"apbs failed on {name}:\n{(done.stderr + done.stdout)[-2000:]}")
    return written[0]
