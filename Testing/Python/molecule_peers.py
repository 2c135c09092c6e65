"""What other readers find in molecule files: JSON lines for each path on standard input.

Run by MoleculeCorpus.py in a Python that has gemmi, and MDAnalysis and chemfiles if possible:

    {"path": ..., "gemmi": {"atoms": 4, "models": 1, "elements": {"C": 3, "X": 1}, "chains": [...],
     "residues": 2}, "MDAnalysis": "why it refuses", ...}

A quantity that a reader does not give is missing. Atoms are those of the first model, with all
alternate locations. Residues are counted by chain, number, insertion code and name.
"""

import bz2
import collections
import gzip
import warnings
from pathlib import Path

import gemmi

from peer_tools import answer_paths

warnings.filterwarnings("ignore")
try:
    import MDAnalysis
except ImportError:
    MDAnalysis = None
try:
    import chemfiles
    chemfiles.set_warnings_callback(lambda message: None)
except ImportError:
    chemfiles = None

SYMBOLS = {gemmi.Element(i).name for i in range(1, 119)}


def symbol(text):
    """The element that `text` names, X if it names none; deuterium is hydrogen."""
    text = (text or "").strip().capitalize()
    return "H" if text in ("D", "T") else text if text in SYMBOLS else "X"


def finding(elements, models, residues=None, chains=None):
    found = {"atoms": len(elements), "models": models,
             "elements": dict(collections.Counter(elements))}
    if residues is not None:
        found["residues"] = len(set(residues))
    if chains is not None:
        found["chains"] = sorted(set(chains))
    return found


def by_gemmi(path):
    if path.endswith(".bcif"):  # which gemmi does not read: the same structure in mmCIF
        path = path.removesuffix("bcif") + "cif"
        if not Path(path).exists():
            return None
    name = path.removesuffix(".gz").removesuffix(".bz2").lower()
    if not name.endswith((".pdb", ".ent", ".cif", ".mmcif")):
        return None
    if name.endswith(("cif")):
        document = gemmi.cif.read(path)
        blocks = [block for block in document if block.find_values("_atom_site.Cartn_x")]
        if not blocks:
            crystals = [gemmi.make_small_structure_from_block(block) for block in document]
            crystals = [crystal for crystal in crystals if len(crystal.sites)]
            if crystals:
                return finding([symbol(site.element.name) for site in crystals[0].sites],
                               len(crystals))
            structures = [gemmi.make_structure_from_chemcomp_block(block) for block in document
                          if block.find_values("_chem_comp_atom.atom_id")]
            structures = [structure for structure in structures if len(structure)]
            if not structures:
                return "no atoms"
            # Each has up to two models: ideal coordinates and an example's, of which we read one.
            found = of_structure(structures[0])
            found["models"] = len(structures)
            return found
        else:
            structure = gemmi.make_structure_from_block(blocks[0])
    else:
        structure = gemmi.read_structure(path, merge_chain_parts=True)
    return of_structure(structure)


def of_structure(structure):
    if not len(structure):
        return "no atoms"
    rows = [(chain.name, residue, atom) for chain in structure[0] for residue in chain
            for atom in residue]
    return finding([symbol(atom.element.name) for *_, atom in rows], len(structure),
                   [(chain, str(residue.seqid), residue.name) for chain, residue, _ in rows],
                   [chain for chain, *_ in rows])


def by_twin(path):
    """Of a GRO file: the elements of the structure of the same name in another format."""
    if not path.endswith(".gro"):
        return None
    for extension in (".cif", ".pdb"):
        twin = Path(path).with_suffix(extension)
        if twin.exists():
            structure = gemmi.read_structure(str(twin))
            atoms = [atom for chain in structure[0] for residue in chain
                     for atom in residue.first_conformer()]
            return {"atoms": len(atoms), "elements": dict(
                collections.Counter(symbol(atom.element.name) for atom in atoms))}
    return None


def by_mdanalysis(path):
    if MDAnalysis is None:
        return None
    universe = MDAnalysis.Universe(path, to_guess=())
    atoms = universe.atoms

    def column(name, default):
        values = getattr(atoms, name, None)
        return default if values is None else list(values)

    elements = column("elements", None)
    given = elements is not None and any(elements)
    chains = column("chainIDs", None)
    if chains is None or not any(chains):
        chains = column("segids", [""] * len(atoms))
        chains = ["" if chain == "SYSTEM" else chain for chain in chains]
    residues = None
    if hasattr(atoms, "resids"):
        residues = list(zip(chains, map(int, column("resids", [])),
                            column("icodes", [""] * len(atoms)),
                            column("resnames", [""] * len(atoms))))
    if not given and hasattr(atoms, "names"):
        universe.guess_TopologyAttrs(to_guess=["elements"])
        elements = list(atoms.elements)
    found = finding([symbol(e) for e in elements] if elements else ["X"] * len(atoms),
                    universe.trajectory.n_frames, residues, chains)
    if not elements:
        del found["elements"]
    return found


def by_chemfiles(path):
    if chemfiles is None:
        return None
    name = path.lower().removesuffix(".gz").removesuffix(".bz2")
    form = "SDF" if name.endswith(".mol") else "Tinker" if name.endswith((".txyz", ".arc")) else ""
    if name.endswith(".xyz"):  # TINKER's have the same extension: atoms begin with their number
        opener = gzip.open if path.endswith(".gz") else bz2.open if path.endswith(".bz2") else open
        with opener(path, "rt", errors="replace") as file:
            words = [file.readline().split() for _ in range(3)][-1]
        form = "Tinker" if len(words) > 5 and words[0] == "1" and words[1][0].isalpha() else ""
    with chemfiles.Trajectory(path, "r", form) as trajectory:
        steps = trajectory.nsteps
        frame = trajectory.read()
    residue_of = {}
    for residue in frame.topology.residues:
        names = set(residue.list_properties())
        chain = residue["chainid"] if "chainid" in names else ""
        code = residue["insertion_code"] if "insertion_code" in names else ""
        for atom in residue.atoms:
            residue_of[atom] = (chain, residue.id, code, residue.name)
    atoms = list(frame.atoms)
    none = ("", 0, "", "")
    found = finding([symbol(atom.type) for atom in atoms], steps,
                    [residue_of.get(i, none) for i in range(len(atoms))] if residue_of else None,
                    [residue_of.get(i, none)[0] for i in range(len(atoms))] if residue_of else None)
    # Types are names where the format has no elements, and numbers of a force field in TINKER's.
    if residue_of and all(atom.type == atom.name for atom in atoms) or form == "Tinker":
        del found["elements"]
    return found


if __name__ == "__main__":
    answer_paths({"gemmi": by_gemmi, "MDAnalysis": by_mdanalysis, "chemfiles": by_chemfiles,
                  "twin": by_twin})
