"""Molecule files of a folder, read by Isthmus and by gemmi, MDAnalysis and chemfiles.

    ISTHMUS_CORPUS_DIR      the folder; without it this test is skipped
    ISTHMUS_CORPUS_PYTHON   a Python with the other readers; else the one on the path

Each folder in it is the test suite of a package. Testing/Data/molecule_corpus.txt lists repositories, commits
and paths of those in the table of Readers/Molecules/Agreement.md.

For each file, the first model is compared: atoms with all alternate locations, elements, names of
chains, residues (chain, number, insertion code, name), and the number of models. A quantity agrees if
one of the other readers finds the same. molecule_corpus.txt explains what does not agree, and all
readers' elements of GRO files, which have none, are also compared with those that gemmi reads from a file
of the same name in mmCIF or PDB. At least 99 % of the files agree, are explained, or are refused by all.
"""

import collections
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

FOLDER = os.environ.get("ISTHMUS_CORPUS_DIR")
if not FOLDER:
    print("set ISTHMUS_CORPUS_DIR to a folder of molecule files")
    sys.exit(77)

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import isthmus

FOLDER = Path(FOLDER)
HERE = Path(__file__).resolve().parent
EXTENSIONS = tuple("pdb ent cif mmcif pqr xyz txyz arc pdbqt gro mol2 sdf mol".split())
# Formats that are not read: their messages say what to do.
OTHERS = tuple("bcif mmtf pdbx smi cml inchi psf prmtop parm7 top itp tpr crd cor dms gsd poscar cssr molden "
               "rst7 inpcrd ncrst restrt mae".split())
QUANTITIES = ("atoms", "elements", "chains", "residues", "models")
PEERS = ("gemmi", "MDAnalysis", "chemfiles")
SYMBOLS = ("X H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se "
           "Br Kr Rb Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy "
           "Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi Po At Rn Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf "
           "Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts Og").split()


def extension(path):
    return Path(path.name.removesuffix(".gz").removesuffix(".bz2")).suffix[1:].lower()


def texts(data, name):
    array = data.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def read(path):
    """What Isthmus finds, or its message."""
    reader = isthmus.vtkMacromoleculeReader()
    messages = []

    def keep(caller, event, message=""):
        messages.append(message)

    keep.CallDataType = "string0"
    reader.AddObserver("ErrorEvent", keep)
    reader.AddObserver("WarningEvent", lambda *_: None)
    reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    reader.SetFileName(str(path))
    reader.SetAltLoc("*")
    reader.SetBondsByDistance(False)
    reader.Update()
    output = reader.GetOutput()
    if messages or not output.GetNumberOfPoints():
        return " ".join(messages).split("): ", 1)[-1].strip() or "no atoms and no message"
    data = output.GetPointData()
    chains = texts(data, "Chain")
    codes = texts(data, "InsertionCode") if data.HasArray("InsertionCode") else [""] * len(chains)
    residues = set(zip(chains, texts(data, "ResidueId"), codes, texts(data, "ResidueName")))
    steps = reader.GetOutputInformation(0).Length(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    return {"atoms": output.GetNumberOfPoints(), "models": max(steps, 1),
            "elements": dict(collections.Counter(SYMBOLS[e] for e in texts(data, "Element"))),
            "chains": sorted(set(chains)), "residues": len(residues)}


def peers(paths):
    """Of each path, what the other readers find."""
    python = os.environ.get("ISTHMUS_CORPUS_PYTHON") or shutil.which("python3") or sys.executable
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    answers = {}
    rest = [str(path) for path in paths]
    while rest:
        done = subprocess.run([python, str(HERE / "molecule_peers.py")], text=True, env=environment,
                              input="".join(f"{path}\n" for path in rest), stdout=subprocess.PIPE)
        count = 0
        for line in done.stdout.splitlines():
            if line.startswith("@"):
                answer = json.loads(line[1:])
                answers[answer.pop("path")] = answer
                count += 1
        assert count > 0 or done.returncode < 0, "the other readers do not start: see above"
        if count < len(rest):  # crashed
            answers[rest[count]] = {}
        rest = rest[count + 1:]
    return answers


def explanations():
    """Reasons by the end of a path, from lines 'PATH: reason'."""
    reasons = {}
    for line in (HERE.parent / "Data/molecule_corpus.txt").read_text().splitlines():
        if line.startswith("differs "):
            path, reason = line[len("differs "):].split(": ", 1)
            reasons[path] = reason
    return reasons


def compare(ours, theirs):
    """Of each quantity True, False, or None where no other reader gives it."""
    found = {}
    for quantity in QUANTITIES:
        values = [t[quantity] for t in theirs.values() if isinstance(t, dict) and quantity in t]
        found[quantity] = None if not values else any(value == ours[quantity] for value in values)
    return found


paths = sorted(p for p in FOLDER.rglob("*")
               if p.is_file() and extension(p) in EXTENSIONS + OTHERS)
assert paths, f"no molecule file in {FOLDER}"
others = peers([path for path in paths if extension(path) in EXTENSIONS])
reasons = explanations()
table = collections.defaultdict(collections.Counter)
rows, unexplained = [], []
for path in paths:
    name = path.relative_to(FOLDER)
    row = table[name.parts[0] if len(name.parts) > 1 else "."]
    theirs = others.get(str(path), {})
    readable = {peer: found for peer, found in theirs.items()
                if isinstance(found, dict) and found["atoms"]}
    ours = read(path)
    row["files"] += 1
    reason = next((why for end, why in reasons.items() if str(name).endswith(end)), None)
    if extension(path) in OTHERS:
        is_named = isinstance(ours, str) and " Name the format" not in ours
        kind = "message" if is_named else "only Isthmus" if isinstance(ours, dict) else "refused"
        problem = "" if kind != "refused" else f"refused: {ours}"
    elif isinstance(ours, str):
        kind = "message" if not readable else "refused"
        problem = "" if not readable else f"refused: {ours}"
        if not readable:
            print(f"{name}: no reader: {ours}", flush=True)
    elif not readable:
        kind, problem = "only Isthmus", ""
        print(f"{name}: only Isthmus: {ours}", flush=True)
    else:
        same = compare(ours, readable)
        for quantity in QUANTITIES:
            row[quantity] += same[quantity] is not False
        wrong = [quantity for quantity in QUANTITIES if same[quantity] is False]
        kind = "differ" if wrong else "agree"
        problem = "; ".join(
            f"{quantity} {ours[quantity]} (" + ", ".join(
                f"{peer} {found[quantity]}" for peer, found in readable.items() if quantity in found) + ")"
            for quantity in wrong)
    if problem:
        kind = "explained" if reason else kind
        print(f"{name}: {problem}" + (f" [{reason}]" if reason else ""), flush=True)
        if not reason:
            unexplained.append(str(name))
    row[kind] += 1

columns = ("files", "agree", "explained", "message", "only Isthmus", "refused", "differ") + QUANTITIES
print("| suite | " + " | ".join(columns) + " |\n|---|" + "---|" * len(columns))
for suite, row in sorted(table.items()):
    print(f"| {suite} | " + " | ".join(str(row[column]) for column in columns) + " |")
assert len(unexplained) <= 0.01 * len(paths), f"{len(unexplained)} of {len(paths)}: {unexplained}"
