"""Measures how far the highest-ranked pockets are from the ligand. Compares Molecular Pockets with other programs,
all without the ligand.

Usage: pvpython evaluate_pockets.py FOLDER [--fpocket PROGRAM] [--p2rank FOLDER] [--whole] [--each] [--sweep]

FOLDER contains ligands.csv (file, ligand_residue, chain, residue_number; optional: family) and the complexes listed
there. The ligand's lines are removed from each file before all computations. Success: the center within 4 angstrom
of an atom of the ligand; top-1 for the pocket that ranks first, top-3 for one of the first three. Intervals are 95
% intervals from resampling the families (without that column, every file is a family).

There are three ways of counting a pocket at an equivalent copy of the ligand's place (the same place of a chain
with the same residues, after superposition): as a miss, as a hit, or with all copies sharing one rank.

With the probabilities of the pockets: their reliability in bins, the expected calibration error and the
Brier score. --fpocket runs fpocket (no part of Debian: build it with its own qhull), whose score depends on
what else is in the file; its center is the mean of a pocket's alpha spheres. --p2rank reads
NAME*_predictions.csv of P2Rank for each file NAME.pdb. --whole adds whole pockets,
ranked by Score. --each prints the distances. --sweep: 40 settings of inner and outer radius of the
whole pockets, and of 9 of them with burial radii of 8 to 12 angstrom and powers 0 to 3 of the
number of atoms in the score, with each complex evaluated by the setting that is best on the others.
"""

import argparse
import csv
import gzip
import itertools
import subprocess
import tempfile
from collections import defaultdict
from pathlib import Path

import numpy

import study_paths  # noqa: F401 (before isthmus)
import isthmus
from vtkmodules.util.numpy_support import vtk_to_numpy

SUCCESS = 4.0  # angstrom
INNER = numpy.linspace(1.5, 1.9, 5)
OUTER = numpy.linspace(2.8, 3.5, 8)
# Of the number of atoms around, these with every third radius: the rest would take half an hour.
BURIAL = (8.0, 10.0, 12.0)
POWERS = (0, 1, 2, 3)
SETTINGS = [(inner, outer, burial)
            for (i, inner), (k, outer), burial in itertools.product(enumerate(INNER), enumerate(OUTER), BURIAL)
            if burial == 10.0 or (i % 2 == 0 and k % 3 == 0)]


def place_of(line):
    return [float(line[start : start + 8]) for start in (30, 38, 46)]


def split(path, row):
    """The file's lines with a mark for those of the ligand, and the ligand's atoms."""
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", errors="replace") as file:
        lines = [line for line in file if not line.startswith("ANISOU")]
    ligand = {
        i
        for i, line in enumerate(lines)
        if line.startswith("HETATM")
        and line[17:20].strip() == row["ligand_residue"]
        and row["chain"] in ("", line[21])
        and row["residue_number"] in ("", line[22:26].strip())
    }
    marked = [(line, i in ligand) for i, line in enumerate(lines)]
    return marked, numpy.array([place_of(lines[i]) for i in sorted(ligand)])


def by_isthmus(path, sites=True):
    """Centers by rank, and their probabilities (none for whole pockets)."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    finder = isthmus.vtkMolecularPockets()
    finder.SetInputConnection(reader.GetOutputPort())
    finder.SetFindSites(sites)
    finder.Update()
    table = finder.GetPocketTable()
    columns = [vtk_to_numpy(table.GetColumnByName(name)) for name in ("CenterX", "CenterY", "CenterZ", "Probability")]
    return numpy.stack(columns[:3], axis=1), columns[3] if sites else None


def by_scores(path, inner, outer, burial):
    """Centers of the pockets by rank, for each power in the score of the number of surrounding atoms."""
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(str(path))
    finder = isthmus.vtkMolecularPockets()
    finder.SetInputConnection(reader.GetOutputPort())
    finder.SetInnerRadius(inner)
    finder.SetOuterRadius(outer)
    finder.SetBurialRadius(burial)
    finder.SetFindSites(False)
    finder.Update()
    cells = finder.GetOutput().GetCellData()
    owner, volume, atoms = (vtk_to_numpy(cells.GetArray(name)) for name in ("PocketId", "EmptyVolume", "Burial"))
    centers = vtk_to_numpy(finder.GetAlphaBalls().GetPoints().GetData())
    found = {}
    for power in POWERS:
        weights = volume * (atoms / 100.0) ** power
        scores = numpy.bincount(owner, weights)
        sums = numpy.stack([numpy.bincount(owner, weights * centers[:, k]) for k in range(3)], axis=1)
        ranks = [i for i in numpy.argsort(-scores, kind="stable") if i > 0 and scores[i] > 0.0]
        found[power] = [sums[i] / scores[i] for i in ranks]
    return found


def by_fpocket(program, path):
    folder = path.parent / (path.stem + "_out")
    subprocess.run([program, "-f", str(path)], check=True, stdout=subprocess.DEVNULL)
    spheres = defaultdict(list)
    for line in open(folder / (path.stem + "_out.pdb")):
        if line.startswith("HETATM") and line[17:20] == "STP":
            spheres[int(line[22:26])].append(place_of(line))
    return numpy.array([numpy.mean(spheres[rank], axis=0) for rank in sorted(spheres)]).reshape(-1, 3), None


def by_p2rank(folder, name):
    found = sorted(folder.glob(f"{name}*_predictions.csv"))
    if not found:
        raise SystemExit(f"{folder} has no {name}*_predictions.csv.")
    rows = [{key.strip(): value.strip() for key, value in row.items()} for row in csv.DictReader(open(found[0]))]
    places = [[float(row["center_" + axis]) for axis in "xyz"] for row in rows]
    return numpy.array(places).reshape(-1, 3), None


# ---------------------------------------------------------------------------- equivalent copies

class Copies:
    """Chains with the same residues, and the transformations between them."""

    def __init__(self, lines):
        self.alphas = defaultdict(dict)
        for line in lines:
            if line.startswith(("ATOM", "HETATM")) and line[12:16] == " CA ":
                self.alphas[line[21]].setdefault((line[22:27], line[17:20]), place_of(line))
        self.moves = defaultdict(list)
        for a, b in itertools.permutations(self.alphas, 2):
            common = sorted(self.alphas[a].keys() & self.alphas[b].keys())
            if len(common) >= max(10, 0.8 * min(len(self.alphas[a]), len(self.alphas[b]))):
                self.moves[a].append(superposition(numpy.array([self.alphas[a][k] for k in common]),
                                                   numpy.array([self.alphas[b][k] for k in common])))

    def chain_at(self, places):
        """The chain whose residues are nearest to these places."""
        nearest = lambda chain: numpy.linalg.norm(
            numpy.array(list(self.alphas[chain].values()))[:, None] - places, axis=2).min(axis=0).mean()
        return min(self.alphas, key=nearest, default=None)

    def images(self, places):
        """The places themselves, and their equivalent copies."""
        places = numpy.atleast_2d(places)
        return [places] + [(places - here) @ turn + there for here, turn, there in self.moves[self.chain_at(places)]]


def superposition(a, b):
    """(center of a, rotation, center of b), least squares (W. Kabsch, Acta Cryst. A 32 (1976) 922)."""
    here, there = a.mean(axis=0), b.mean(axis=0)
    u, _, v = numpy.linalg.svd((a - here).T @ (b - there))
    u[:, -1] *= numpy.sign(numpy.linalg.det(u @ v))
    return here, u @ v, there


def distance(places, center):
    return numpy.linalg.norm(places - center, axis=1).min()


def three_counts(centers, ligand, copies):
    """For each counting rule, whether each rank succeeds."""
    targets = copies.images(ligand)
    miss = [distance(ligand, c) <= SUCCESS for c in centers]
    hit = [min(distance(target, c) for target in targets) <= SUCCESS for c in centers]
    groups = []
    for center, success in zip(centers, hit):
        images = copies.images(center)
        for group in groups:
            if min(numpy.linalg.norm(image[0] - group[0]) for image in images) <= SUCCESS:
                group[1] |= success
                break
        else:
            groups.append([center, success])
    return miss, hit, [success for _, success in groups]


# ---------------------------------------------------------------------------- figures

def interval(values, families, rounds=5000):
    """95 % interval of the mean, from resampling families."""
    values, families = numpy.asarray(values, float), numpy.asarray(families)
    names = numpy.unique(families)
    sums = numpy.array([values[families == name].sum() for name in names])
    counts = numpy.array([(families == name).sum() for name in names])
    picks = numpy.random.default_rng(0).integers(0, len(names), (rounds, len(names)))
    return numpy.percentile(sums[picks].sum(axis=1) / counts[picks].sum(axis=1), [2.5, 97.5])


def share_of(values, families):
    low, high = interval(values, families)
    return f"{100 * numpy.mean(values):.1f} [{100 * low:.0f}, {100 * high:.0f}]"


def print_summary(found, families):
    """`found`: for each method, for each complex, the successes of the ranks by the three counts."""
    counts = ("copy a miss", "copy a hit", "copies one rank")
    print("| | " + " | ".join(f"{count}: top-{k}" for count in counts for k in (1, 3)) + " |")
    print("|---|" + "---|" * 6)
    for name, complexes in found.items():
        cells = [share_of([any(one[count][:k]) for one in complexes], families)
                 for count in range(3) for k in (1, 3)]
        print(f"| {name} | " + " | ".join(cells) + " |")
    first = next(iter(found.values()))
    for name, complexes in list(found.items())[1:]:
        gain = [any(a[0][:1]) - any(b[0][:1]) for a, b in zip(first, complexes)]
        print(f"top-1 of {next(iter(found))} less that of {name}, pairs: {share_of(gain, families)}")


def reliability_bins(probability, hit, least=50):
    """Boundaries of bins of probability, narrower towards high values, with at least `least` pockets each."""
    order = numpy.argsort(probability, kind="stable")
    count = len(order)
    sizes = []
    while sum(sizes) + least <= count:
        sizes.append(max(least, (count - sum(sizes)) // 3))
    if not sizes:
        sizes = [count]
    sizes[-1] += count - sum(sizes)
    ends = numpy.cumsum(sizes)
    return [order[end - size:end] for size, end in zip(sizes, ends)]


def calibration_error(probability, hit, bins):
    return sum(len(some) * abs(probability[some].mean() - hit[some].mean()) for some in bins) / len(probability)


def print_reliability(probability, hit, families):
    probability, hit, families = (numpy.asarray(values) for values in (probability, hit, families))
    bins = reliability_bins(probability, hit)
    print("\n| mean probability | observed share | interval | pockets |\n|---|---|---|---|")
    for some in bins:
        low, high = interval(hit[some], families[some])
        print(f"| {probability[some].mean():.3f} | {hit[some].mean():.3f} | {low:.3f} to {high:.3f} | {len(some)} |")
    print(f"expected calibration error {calibration_error(probability, hit, bins):.4f}, Brier score "
          f"{((probability - hit) ** 2).mean():.4f}, {len(hit)} pockets")


def print_sweep(table):
    """`table`: for each setting whether it succeeds (first, among three) on each complex."""
    settings = sorted(table)
    success = numpy.array([table[setting] for setting in settings])  # setting, complex, rank
    sums = success.sum(axis=1)
    print(f"{len(settings)} settings: first {sums[:, 0].min()} to {sums[:, 0].max()}, "
          f"median {numpy.median(sums[:, 0]):g}; among three {sums[:, 1].min()} to {sums[:, 1].max()}")
    for burial, power in itertools.product(BURIAL, POWERS):
        chosen = [setting[2:] == (burial, power) for setting in settings]
        if not any(chosen):
            continue
        some = sums[chosen]
        print(f"  burial radius {burial:g}, power {power}: first {some[:, 0].min()} to {some[:, 0].max()}, "
              f"median {numpy.median(some[:, 0]):g}; among three {some[:, 1].min()} to {some[:, 1].max()}")
    left_out = numpy.zeros(2)
    for i in range(success.shape[1]):
        others = numpy.delete(success, i, axis=1).sum(axis=1)
        best = others[numpy.lexsort((others[:, 1], others[:, 0]))[-1]]
        ties = (others == best).all(axis=1)
        left_out += success[ties, i].mean(axis=0)
    print("leave one out, mean over the settings that are best on the others: first {:.2f}, among "
          "three {:.2f}".format(*left_out))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--fpocket")
    parser.add_argument("--p2rank", type=Path)
    for name in ("whole", "each", "sweep"):
        parser.add_argument("--" + name, action="store_true")
    options = parser.parse_args()
    methods = {"Molecular Pockets": lambda path, name: by_isthmus(path)}
    if options.whole:
        methods["whole pockets by Score"] = lambda path, name: by_isthmus(path, False)
    if options.fpocket:
        methods["fpocket"] = lambda path, name: by_fpocket(options.fpocket, path)
    if options.p2rank:
        methods["P2Rank"] = lambda path, name: by_p2rank(options.p2rank, name)
    found, families, sweep, pockets = {name: [] for name in methods}, [], {}, []
    for row in csv.DictReader(open(options.folder / "ligands.csv")):
        path = (options.folder / row["file"]).resolve()
        lines, ligand = split(path, row)
        name = path.name.split(".")[0]
        families.append(row.get("family") or name)
        protein = [line for line, is_ligand in lines if not is_ligand]
        copies = Copies(protein)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / (name + ".pdb")
            file.write_text("".join(protein))
            for method, run in methods.items():
                centers, probabilities = run(file, name)
                found[method].append(three_counts(centers, ligand, copies))
                if probabilities is not None:
                    pockets += [(p, hit, families[-1]) for p, hit in zip(probabilities, found[method][-1][0])]
                if options.each:
                    print(f"{name}: {method}: " + " ".join(f"{distance(ligand, c):.1f}" for c in centers[:5]), flush=True)
            for setting in SETTINGS if options.sweep else ():
                for power, centers in by_scores(file, *setting).items():
                    d = [distance(ligand, c) for c in centers] or [numpy.inf]
                    sweep.setdefault((*setting, power), []).append((d[0] <= SUCCESS, min(d[:3]) <= SUCCESS))
    print(f"{len(families)} complexes, {len(set(families))} families\n")
    print_summary(found, families)
    if pockets:
        print_reliability(*zip(*pockets))
    if sweep:
        print("Radii only, burial radius 10 and power 2:")
        print_sweep({setting: rows for setting, rows in sweep.items() if setting[2:] == (10.0, 2)})
        print("All four:")
        wide = {setting[:2] for setting in sweep if setting[2] != 10.0}
        print_sweep({setting: rows for setting, rows in sweep.items() if setting[:2] in wide})


if __name__ == "__main__":
    main()
