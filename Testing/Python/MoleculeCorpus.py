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

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

import corpus
import isthmus

FOLDER = corpus.folder()
EXTENSIONS = tuple(word[1:] for word in isthmus.vtkMacromoleculeReader.GetFileExtensions().split())
# Formats that are not read: their messages say what to do.
OTHERS = tuple("mmtf pdbx smi cml inchi psf prmtop parm7 top itp tpr crd cor dms gsd poscar cssr molden "
               "rst7 inpcrd ncrst restrt mae".split())
QUANTITIES = ("atoms", "elements", "chains", "residues", "models")
SYMBOLS = ("X H He Li Be B C N O F Ne Na Mg Al Si P S Cl Ar K Ca Sc Ti V Cr Mn Fe Co Ni Cu Zn Ga Ge As Se "
           "Br Kr Rb Sr Y Zr Nb Mo Tc Ru Rh Pd Ag Cd In Sn Sb Te I Xe Cs Ba La Ce Pr Nd Pm Sm Eu Gd Tb Dy "
           "Ho Er Tm Yb Lu Hf Ta W Re Os Ir Pt Au Hg Tl Pb Bi Po At Rn Fr Ra Ac Th Pa U Np Pu Am Cm Bk Cf "
           "Es Fm Md No Lr Rf Db Sg Bh Hs Mt Ds Rg Cn Nh Fl Mc Lv Ts Og").split()


def texts(data, name):
    array = data.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def read(path):
    """What Isthmus finds, or its message."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    reader.SetAltLoc("*")
    reader.SetBondsByDistance(False)
    messages = corpus.errors_of_update(reader)
    output = reader.GetOutput()
    if messages or not output.GetNumberOfPoints():
        return messages or "no atoms and no message"
    data = output.GetPointData()
    chains = texts(data, "Chain")
    codes = texts(data, "InsertionCode") if data.HasArray("InsertionCode") else [""] * len(chains)
    residues = set(zip(chains, texts(data, "ResidueId"), codes, texts(data, "ResidueName")))
    steps = reader.GetOutputInformation(0).Length(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    return {"atoms": output.GetNumberOfPoints(), "models": max(steps, 1),
            "elements": dict(collections.Counter(SYMBOLS[e] for e in texts(data, "Element"))),
            "chains": sorted(set(chains)), "residues": len(residues)}


paths = corpus.files(FOLDER, EXTENSIONS + OTHERS)
others = corpus.peers("molecule_peers.py",
                      [path for path in paths if corpus.extension(path) in EXTENSIONS])
table = corpus.Table(FOLDER, corpus.explanations("molecule_corpus.txt"), QUANTITIES)
for path in paths:
    ours = read(path)
    if corpus.extension(path) not in OTHERS:
        corpus.add(table, path, ours, others.get(str(path), {}), QUANTITIES)
    elif isinstance(ours, dict):
        table.add(path, "only Isthmus")
    else:
        is_named = " Choose the format" not in ours
        table.add(path, "message" if is_named else "refused", "" if is_named else f"refused: {ours}")
table.finish()
