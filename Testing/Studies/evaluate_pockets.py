"""Measures how far the highest-ranked pockets are from the ligands. Compares Molecular Pockets with other programs,
all without the ligands.

Usage: pvpython evaluate_pockets.py FOLDER [--fpocket PROGRAM] [--p2rank FOLDER] [--whole] [--each] [--sweep]
       pvpython evaluate_pockets.py FOLDER --robustness 20 [--fpocket PROGRAM] [--whole]

FOLDER contains ligands.csv (file, ligand_residue, chain, residue_number; optional: family) and the complexes listed
there, a file with several ligands in several rows. All ligands' lines are removed from a file before all computations.
A ligand is found if a center is within 4 angstrom of one of its atoms. Recall is the share of ligands found, as in the
LIGYSIS benchmark (J. Utges and G. Barton, J. Cheminform. 16 (2024) 126): by the first N pockets of a protein with N
ligands (top-N), the first N + 2, or all; also with that benchmark's criterion, 12 angstrom between the
center and the mean of the ligand's atoms. Redundancy is the number of pockets listed for one protein, and the share of them within 5
angstrom of a better one. Intervals are 95 % intervals from resampling the families (without that column, every file
is a family).

There are three ways of counting a pocket at an equivalent copy of the ligand's place (the same place of a chain
with the same residues, after superposition): as a miss, as a hit, or with all copies sharing one rank.

With the probabilities of the pockets: their reliability in bins, the expected calibration error and the
Brier score. --fpocket runs fpocket (no part of Debian: build it with its own qhull), whose score depends on
what else is in the file; its center is the mean of a pocket's alpha spheres. --p2rank reads
NAME*_predictions.csv of P2Rank for each file NAME.pdb. --whole adds whole pockets,
ranked by Score. --each prints the distances. --sweep: 40 settings of inner and outer radius of the
whole pockets, and of 9 of them with burial radii of 8 to 12 angstrom and powers 0 to 3 of the
number of atoms in the score, with each complex evaluated by the setting that is best on the others.

--robustness N moves all atoms at random by 0.2 angstrom (root mean square), three times for the first file of N families
at equal distances in the list (0: of all), and prints in how many runs the first center stays within 4
angstrom of that of the unchanged file.
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

SUCCESS, MEAN_SUCCESS, REDUNDANT = 4.0, 12.0, 5.0  # angstrom
NOISE, MOVES = 0.2, 3  # root mean square in angstrom, and number of times
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


def split(path, rows):
    """The file's lines without the ligands of these rows, and the atoms of each ligand."""
    opened = gzip.open if path.suffix == ".gz" else open
    with opened(path, "rt", errors="replace") as file:
        lines = [line for line in file if not line.startswith("ANISOU")]
    ligands = [{
        i
        for i, line in enumerate(lines)
        if line.startswith("HETATM")
        and line[17:20].strip() == row["ligand_residue"]
        and row["chain"] in ("", line[21])
        and row["residue_number"] in ("", line[22:26].strip())
    } for row in rows]
    protein = [line for i, line in enumerate(lines) if not any(i in ligand for ligand in ligands)]
    return protein, [numpy.array([place_of(lines[i]) for i in sorted(ligand)]) for ligand in ligands]


def complexes_of(folder):
    """Of each file: its path, its family, and what split returns."""
    rows = defaultdict(list)
    for row in csv.DictReader(open(folder / "ligands.csv")):
        rows[row["file"]].append(row)
    for file, ligands in rows.items():
        path = (folder / file).resolve()
        yield path, ligands[0].get("family") or path.name.split(".")[0], *split(path, ligands)


def moved(lines, random):
    """The lines with all atoms moved at random."""
    for line in lines:
        if line.startswith(("ATOM", "HETATM")):
            place = numpy.array(place_of(line)) + random.normal(0.0, NOISE / 3 ** 0.5, 3)
            line = line[:30] + "{:8.3f}{:8.3f}{:8.3f}".format(*place) + line[54:]
        yield line


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


def counts_of(centers, ligands, copies):
    """For each way of counting, whether each rank (column) finds each ligand (row)."""
    within = lambda test: numpy.array([[test(ligand, c) for c in centers] for ligand in ligands], bool).reshape(
        len(ligands), len(centers))
    images = [copies.images(ligand) for ligand in ligands]
    hit = numpy.array([[min(distance(image, c) for image in some) <= SUCCESS for c in centers] for some in images],
                      bool).reshape(len(ligands), len(centers))
    groups = []
    for center, found in zip(centers, hit.T):
        places = copies.images(center)
        for group in groups:
            if min(numpy.linalg.norm(place[0] - group[0]) for place in places) <= SUCCESS:
                group[1] |= found
                break
        else:
            groups.append([center, found.copy()])
    return {"copy a miss": within(lambda ligand, c: distance(ligand, c) <= SUCCESS), "copy a hit": hit,
            "copies one rank": numpy.array([found for _, found in groups], bool).reshape(-1, len(ligands)).T,
            "12 angstrom": within(lambda ligand, c: numpy.linalg.norm(ligand.mean(axis=0) - c) <= MEAN_SUCCESS)}


def count_redundant(centers):
    """Centers near a better one."""
    return sum(len(centers[:i]) > 0 and distance(centers[:i], centers[i]) <= REDUNDANT for i in range(len(centers)))


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


def found_by(hits, more):
    """Of each ligand of all files, whether one of the first N + more finds it."""
    return [one[:len(hit) + more].any() for hit in hits for one in hit]


EVERY = 10 ** 6
RECALLS = [(f"top-{name}, {count}", count, more)
           for count in ("copy a miss", "copy a hit", "copies one rank") for name, more in (("N", 0), ("N+2", 2))]
RECALLS += [("all pockets, copy a miss", "copy a miss", EVERY), ("all pockets, copy a hit", "copy a hit", EVERY),
            ("top-N, mean within 12 angstrom", "12 angstrom", 0), ("top-N+2, mean within 12 angstrom", "12 angstrom", 2)]


def print_summary(counts, listed, families):
    """`counts`: for each method, of each file, what counts_of returns; `listed`: its numbers of pockets and of
    redundant ones."""
    first = next(iter(counts))
    each = [family for family, one in zip(families, counts[first]) for _ in one["copy a hit"]]
    print("| recall, % | " + " | ".join(counts) + " |\n|---|" + "---|" * len(counts))
    for title, count, more in RECALLS:
        cells = [share_of(found_by([one[count] for one in files], more), each) for files in counts.values()]
        print(f"| {title} | " + " | ".join(cells) + " |")
    for title, values in (("pockets of a protein", lambda some: f"{some[:, 0].mean():.1f}"),
                          ("near a better one, %", lambda some: f"{100 * some[:, 1].sum() / some[:, 0].sum():.1f}")):
        print(f"| {title} | " + " | ".join(values(numpy.array(some)) for some in listed.values()) + " |")
    for name in list(counts)[1:]:
        for title, count, more in RECALLS[:4]:
            ours, theirs = ([found_by([one[count] for one in counts[method]], more)] for method in (first, name))
            gain = numpy.subtract(*(numpy.array(some[0], float) for some in (ours, theirs)))
            print(f"{title}: {first} less {name}, pairs: {share_of(gain, each)}")


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


def measure_robustness(options, methods):
    """Prints how often the first center stays where it is when the atoms move."""
    files = {}
    for path, family, protein, _ in complexes_of(options.folder):
        files.setdefault(family, (path.name.split(".")[0], protein))
    chosen = list(files)
    if options.robustness:
        chosen = [chosen[i * len(chosen) // options.robustness] for i in range(min(options.robustness, len(chosen)))]
    stays = defaultdict(list)
    with tempfile.TemporaryDirectory() as folder:
        for family in chosen:
            name, protein = files[family]
            file = Path(folder) / (name + ".pdb")
            first = {}
            for number in range(MOVES + 1):
                file.write_text("".join(moved(protein, numpy.random.default_rng(number)) if number else protein))
                for method, run in methods.items():
                    centers = run(file, name)[0][:1]
                    first.setdefault(method, []).append(centers[0] if len(centers) else numpy.full(3, numpy.inf))
            for method, (unmoved, *others) in first.items():
                distances = [numpy.linalg.norm(other - unmoved) for other in others]
                stays[method].append([d <= SUCCESS for d in distances])
                if options.each:
                    print(f"{name}: {method}: " + " ".join(f"{d:.1f}" for d in distances), flush=True)
    for method, some in stays.items():
        print(f"{method}: the first center stays within {SUCCESS:g} angstrom in {numpy.sum(some)} of {numpy.size(some)} "
              f"runs ({len(some)} proteins), {share_of(numpy.mean(some, axis=1), numpy.arange(len(some)))} %")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--fpocket")
    parser.add_argument("--p2rank", type=Path)
    for name in ("whole", "each", "sweep"):
        parser.add_argument("--" + name, action="store_true")
    parser.add_argument("--robustness", type=int)
    options = parser.parse_args()
    methods = {"Molecular Pockets": lambda path, name: by_isthmus(path)}
    if options.whole:
        methods["whole pockets by Score"] = lambda path, name: by_isthmus(path, False)
    if options.fpocket:
        methods["fpocket"] = lambda path, name: by_fpocket(options.fpocket, path)
    if options.p2rank:
        methods["P2Rank"] = lambda path, name: by_p2rank(options.p2rank, name)
    if options.robustness is not None:
        return measure_robustness(options, methods)
    counts, listed = {name: [] for name in methods}, {name: [] for name in methods}
    families, sweep, pockets = [], {}, []
    for path, family, protein, ligands in complexes_of(options.folder):
        name = path.name.split(".")[0]
        families.append(family)
        copies = Copies(protein)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / (name + ".pdb")
            file.write_text("".join(protein))
            for method, run in methods.items():
                centers, probabilities = run(file, name)
                counts[method].append(counts_of(centers, ligands, copies))
                listed[method].append((len(centers), count_redundant(centers)))
                if probabilities is not None:
                    right = counts[method][-1]["copy a miss"].any(axis=0)
                    pockets += [(p, hit, family) for p, hit in zip(probabilities, right)]
                if options.each:
                    away = [min(distance(ligand, c) for ligand in ligands) for c in centers[:5]]
                    print(f"{name}: {method}: " + " ".join(f"{d:.1f}" for d in away), flush=True)
            for setting in SETTINGS if options.sweep else ():
                for power, centers in by_scores(file, *setting).items():
                    d = [min(distance(ligand, c) for ligand in ligands) for c in centers] or [numpy.inf]
                    sweep.setdefault((*setting, power), []).append((d[0] <= SUCCESS, min(d[:3]) <= SUCCESS))
    print(f"{len(families)} proteins of {len(set(families))} families, "
          f"{sum(len(one['copy a hit']) for one in next(iter(counts.values())))} ligands\n")
    print_summary(counts, listed, families)
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
