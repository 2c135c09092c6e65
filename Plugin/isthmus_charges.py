"""Charges for molecules whose files have none: pdb2pqr, where it is installed, makes a PQR file."""

import os
import re
import shutil
import subprocess

from paraview import print_warning, servermanager, simple


def charged(source):
    """The molecule with charges: itself, or what pdb2pqr makes of its file."""
    charges = source.PointData["Charge"]
    low, high = charges.GetRange(0) if charges else (0.0, 0.0)
    if low < 0.0 < high:
        return source
    program = shutil.which("pdb2pqr") or shutil.which("pdb2pqr30")
    file = _file_of(source)
    way_out = "or open a PQR file, or a potential's .dx file for Polarized Curvature."
    if not file or not file.lower().endswith((".pdb", ".ent", ".cif")):
        raise ValueError("The molecule has no charges, from which the potential comes: open its PDB file as "
                         "it is, not compressed, " + way_out)
    if servermanager.ActiveConnection.IsRemote():
        raise ValueError("The molecule has no charges; on a remote server run pdb2pqr there, " + way_out)
    if not program:
        raise ValueError("The molecule has no charges. They come from a force field by pdb2pqr, which is "
                         "not installed: install it (Debian: apt install pdb2pqr), " + way_out)
    target = _place_for(file, ".pqr")
    done = subprocess.run(
        [program, "--ff=AMBER", "--keep-chain", "--drop-water", "--nodebump", "--noopt", file, target],
        capture_output=True, text=True)
    if done.returncode != 0 or not os.path.exists(target):
        mending = "Open its PDB file, " if file.lower().endswith(".cif") else "Complete the protein, "
        raise ValueError("pdb2pqr could not give the atoms charges: " + _reason(done.stderr or done.stdout)
                         + " " + mending + way_out)
    left_out = _left_out(done.stderr + done.stdout)
    if left_out:
        print_warning("pdb2pqr knows no charges of " + ", ".join(left_out) + ": they were left out.")
    return simple.OpenDataFile(target, registrationName=os.path.basename(target))


def _reason(said):
    """The first error of a log that ends in tracebacks, as a sentence; "RuntimeError" alone explains nothing."""
    told = [line.partition(":")[2].strip() for line in said.splitlines()
            if line.startswith(("ERROR:", "CRITICAL:")) and line.partition(":")[2].strip()]
    errors = [line.strip() for line in said.splitlines() if "Error: " in line]
    found = (errors + told + ["it gave no reason"])[0]
    return found.rstrip(".") + "."


def _left_out(said):
    """The kinds of residues that pdb2pqr's log says it does not know, and so leaves out."""
    return sorted(set(re.findall(r"Unable to find amino or nucleic acid definition for (\S+)\. ", said)))


def _file_of(source):
    name = source.GetProperty("FileName")
    name = name.GetData() if name else None
    return name if name is None or isinstance(name, str) else name[0]


def _place_for(file, ending):
    """Beside the molecule's file, else in the current folder."""
    folder, base = os.path.split(os.path.abspath(file))
    # Root may write everywhere, which is no reason to.
    if not os.access(folder, os.W_OK) or not os.stat(folder).st_mode & 0o222:
        folder = os.getcwd()
    return os.path.join(folder, base.split(".")[0] + ending)
