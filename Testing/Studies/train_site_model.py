"""Trains the site model of Molecular Pockets and measures its performance on unseen families.

    python3 train_site_model.py collect PDBBIND SET FOLDER           # SET: "further" or "left out"
    /usr/bin/python3 train_site_model.py describe FOLDER OUT.npz     # needs isthmus (PV_PLUGIN_PATH)
    python3 train_site_model.py train OUT.npz ... [--test OUT.npz] [--table SiteModelTable.cxx]

FOLDER has the same layout as for evaluate_pockets.py, with a column family in ligands.csv. collect writes it for the
entries of site_model_entries.tsv, from a clone of a repository that has PDBbind's files ID/ID_protein.pdb and
ID/ID_ligand.mol2. train needs numpy,
scipy, scikit-learn and lightgbm (4.7.0 made the shipped table), and no Isthmus. Places are the tetrahedra of
pockets; a place is positive if an atom of the ligand lies within 3 angstrom. Every family of proteins has the same
weight, and at most 4 complexes per family are used from each file.

Printed: cross-validation over families (with --nested, the kernel's reach and the number of trees are chosen within
each outer fold), intervals by resampling families, with --curve the learning curve, and calibration on left-out
families. --table writes the C++ source of the model trained on all data, --centers the sites of the cross-validation
into a folder, in the form in which evaluate_pockets.py reads those of P2Rank.
"""

import argparse
import csv
import hashlib
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

import numpy

NEAR, SUCCESS, SPACING, AROUND = 3.0, 4.0, 8.0, 10.0  # angstrom
LEAST = 0.01  # of the largest density, for a site
ENTRIES = Path(__file__).with_name("site_model_entries.tsv")
PER_FAMILY, FOLDS = 4, 5
PLACES = (150, 350)  # of each complex that take part: the largest number of right ones and of wrong ones
REACHES, TREES = (6.0, 8.0, 10.0), (80, 160)
SHIPPED = 10.0, 160  # kernel's reach (PocketSites.h) and number of trees
CROWDING = 2.5
PARAMETERS = {"objective": "binary", "num_leaves": 12, "learning_rate": 0.06, "min_data_in_leaf": 200,
              "bagging_fraction": 0.7, "bagging_freq": 1, "feature_fraction": 0.4, "lambda_l2": 20.0,
              "num_threads": 1, "deterministic": True, "force_row_wise": True, "seed": 1, "verbose": -1}


# ---------------------------------------------------------------------------- complexes of PDBbind

def collect(source, chosen, folder):
    folder.mkdir(parents=True)
    with open(folder / "ligands.csv", "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["file", "ligand_residue", "chain", "residue_number", "family"])
        for row in csv.DictReader(open(ENTRIES), delimiter="\t"):
            for entry in row["entries"].split() if row["set"].endswith(chosen) else ():
                lines = (source / entry / f"{entry}_protein.pdb").read_text().splitlines()
                lines = [line for line in lines if not line.startswith(("END", "CONECT", "MASTER"))]
                atoms = (source / entry / f"{entry}_ligand.mol2").read_text().split("@<TRIPOS>")
                for line in next(part for part in atoms if part.startswith("ATOM")).splitlines()[1:]:
                    number, name, x, y, z, kind = line.split()[:6]
                    element = kind.split(".")[0].upper()
                    if element not in ("H", "D", "DU", "LP"):
                        lines.append(f"HETATM{number:>5} {name[:4]:4} LIG Z   1    {float(x):8.3f}{float(y):8.3f}"
                                     f"{float(z):8.3f}  1.00  0.00          {element:>2}")
                (folder / f"{entry}.pdb").write_text("\n".join([*lines, "END", ""]))
                table.writerow([f"{entry}.pdb", "LIG", "Z", "1", row["family"]])


# ---------------------------------------------------------------------------- descriptors, by Isthmus

def atoms_of(lines):
    """Positions of the heavy atoms of a polymer, and the words and numbers of their residues (SiteAtom)."""
    atoms = [line for line in lines if line.startswith("ATOM") and line[76:78].strip() not in ("H", "D")
             and line[12:16].strip("0123456789 ")[:1] not in ("H", "D")]
    places = numpy.array([[float(line[start:start + 8]) for start in (30, 38, 46)] for line in atoms])
    residues, number = numpy.unique([line[21:27] + line[17:20] for line in atoms], return_inverse=True)
    words = [" ".join(other[6:] if other[0] == residues[i][0] else "" for other in residues[max(0, i - 3):i + 4])
             for i in range(len(residues))]
    return places.reshape(-1, 3), numpy.unique(words, return_inverse=True)[1][number], number


def describe(folder, out):
    import study_paths  # noqa: F401 (before isthmus)
    import isthmus
    from evaluate_pockets import split
    from vtkmodules.util.numpy_support import vtk_to_numpy

    columns = defaultdict(list)
    for row in csv.DictReader(open(folder / "ligands.csv")):
        lines, (ligand,) = split((folder / row["file"]).resolve(), [row])
        with tempfile.TemporaryDirectory() as temporary:
            path = Path(temporary) / "protein.pdb"
            path.write_text("".join(lines))
            reader = isthmus.vtkMacromoleculeReader()
            reader.SetFileName(str(path))
            finder = isthmus.vtkMolecularPockets()
            finder.SetInputConnection(reader.GetOutputPort())
            finder.GetOutputArraySelection().EnableArray("SiteDescriptors")
            finder.Update()
        judged = finder.GetSiteSurface()
        array = judged.GetPointData().GetArray("SiteDescriptors")
        if array is None:
            print(f"{row['file']}: no pockets")
            continue
        values = vtk_to_numpy(array)
        places = vtk_to_numpy(judged.GetPoints().GetData())
        distances = numpy.min([numpy.linalg.norm(places - atom, axis=1) for atom in ligand], axis=0)
        columns["name"].append(row["file"])
        columns["family"].append(row["family"].replace("A:", ""))
        columns["values"].append(values)
        columns["places"].append(places)
        columns["distances"].append(distances)
        columns["ligand"].append(ligand)
        atoms, word, number = atoms_of(lines)
        columns["atoms"].append(atoms)
        columns["words"].append(numpy.stack([word, number], axis=1))
    names = [array.GetComponentName(k) for k in range(array.GetNumberOfComponents())]
    numpy.savez_compressed(
        out, names=names, name=columns["name"], family=columns["family"],
        sizes=[len(v) for v in columns["values"]], ligand_sizes=[len(v) for v in columns["ligand"]],
        atom_sizes=[len(v) for v in columns["atoms"]], **{key: numpy.concatenate(columns[key]) for key in (
            "values", "places", "distances", "ligand", "atoms", "words")})
    print(f"{len(columns['name'])} complexes, {len(set(columns['family']))} families")


class Complex:
    def __init__(self, name, family, values, places, distances, ligand, atoms, words, source):
        self.name, self.family, self.source = name, family, source
        self.atoms, self.words = atoms, words
        self.residues, self.places, self.ligand = values[:, -40:], places, ligand
        self.values, self.right = values[:, :-40].copy(), distances < NEAR
        # A sample of the places, with weights that give each kind its share back.
        random = numpy.random.default_rng(int(hashlib.sha1(name.encode()).hexdigest()[:8], 16))
        chosen, weights = [], []
        for kind, most in ((self.right, PLACES[0]), (~self.right, PLACES[1])):
            all_of_it = numpy.flatnonzero(kind)
            some = all_of_it if len(all_of_it) <= most else random.choice(all_of_it, most, replace=False)
            chosen.append(some)
            weights.append(numpy.full(len(some), len(all_of_it) / max(1, len(some)) / len(kind)))
        self.sample, self.sample_weights = numpy.concatenate(chosen), numpy.concatenate(weights)


def load(path):
    data = numpy.load(path)
    parts = {}
    for sizes, keys in (("sizes", ("values", "places", "distances")), ("ligand_sizes", ("ligand",)),
                        ("atom_sizes", ("atoms", "words"))):
        ends = numpy.cumsum(data[sizes])
        for key in keys:
            whole = data[key]
            parts[key] = [whole[end - size:end] for end, size in zip(ends, data[sizes])]
    return [Complex(str(name), str(family), *some, str(path)) for name, family, *some in zip(
        data["name"], data["family"], *(parts[key] for key in (
            "values", "places", "distances", "ligand", "atoms", "words")))
            ], [str(name) for name in data["names"]][:-40]


def at_most(complexes, count):
    groups = defaultdict(list)
    for one in sorted(complexes, key=lambda c: hashlib.sha1(c.name.encode()).hexdigest()):
        groups[one.family].append(one)
    return [one for group in groups.values() for one in group[:count]]


# ---------------------------------------------------------------------------- model

def family_weights(complexes):
    count = Counter(one.family for one in complexes)
    return numpy.array([1.0 / count[one.family] for one in complexes])


def propensity_of(complexes, column):
    """Enrichment of each residue near positive places compared with others: logarithm of the ratio."""
    near, others = numpy.zeros(40), numpy.zeros(40)
    for one, weight in zip(complexes, family_weights(complexes)):
        shares = one.residues / numpy.maximum(one.residues.sum(axis=1, keepdims=True), 1e-9)
        if one.right.any() and not one.right.all():
            near += weight * shares[one.right].mean(axis=0)
            others += weight * shares[~one.right].mean(axis=0)
    pseudo = 0.5 / len(complexes)
    return numpy.log((near / near.sum() + pseudo) / (others / others.sum() + pseudo))


def with_propensity(one, propensity, column, rows=slice(None)):
    values = one.values[rows].copy()
    near = one.residues[rows].astype(float)
    values[:, column] = near @ propensity / numpy.maximum(near.sum(axis=1), 1e-9)
    return values


def fit(complexes, column, trees):
    import lightgbm

    propensity = propensity_of(complexes, column)
    values = numpy.vstack([with_propensity(one, propensity, column, one.sample) for one in complexes])
    right = numpy.concatenate([one.right[one.sample] for one in complexes])
    weights = numpy.concatenate([w * one.sample_weights for one, w in zip(complexes, family_weights(complexes))])
    weights *= len(weights) / weights.sum()
    data = lightgbm.Dataset(values, right, weight=weights, params={"verbose": -1})
    return propensity, lightgbm.train(PARAMETERS, data, trees)


def predict(model, one, column, trees=None):
    propensity, booster = model
    return booster.predict(with_propensity(one, propensity, column), num_iteration=trees)


def sites_of(places, probabilities, reach, most=None):
    """Densities and modes of the first sites, computed as in PocketSites.h."""
    from scipy.spatial import cKDTree

    tree = cKDTree(places)
    pairs = tree.sparse_distance_matrix(tree, CROWDING, output_type="coo_matrix")
    crowding = numpy.bincount(pairs.row, (1.0 - (pairs.data / CROWDING) ** 2) ** 2, minlength=len(places))
    likely = probabilities / numpy.sqrt(numpy.maximum(crowding, 1.0))

    def mean(at):
        near = tree.query_ball_point(at, reach)
        weights = likely[near] * (1.0 - ((places[near] - at) ** 2).sum(axis=1) / reach ** 2) ** 2
        total = weights.sum()
        return total, (weights @ places[near] / total if total > 0.0 else at)

    pairs = tree.sparse_distance_matrix(tree, reach, output_type="coo_matrix")
    weights = likely[pairs.col] * (1.0 - (pairs.data / reach) ** 2) ** 2
    density = numpy.bincount(pairs.row, weights, minlength=len(places))
    taken = numpy.zeros(len(places), bool)
    found = []
    for i in numpy.argsort(-density, kind="stable"):
        if density[i] < LEAST * density.max():
            break
        if taken[i]:
            continue
        taken[i] = True
        at = places[i]
        for _ in range(40):
            value, after = mean(at)
            moved = numpy.linalg.norm(after - at)
            if moved <= 0.01:
                break
            at = after
        if all(numpy.linalg.norm(other - at) >= 0.5 * SPACING for _, other in found):
            found.append((value, at))
            taken[tree.query_ball_point(at, SPACING)] = True
            if len(found) == most:
                break
    found.sort(key=lambda site: -site[0])
    return numpy.array([d for d, _ in found]), numpy.array([c for _, c in found]).reshape(-1, 3)


def weights_around(one, center):
    """Weights of the surrounding residues, by word and by word and number."""
    weights = 1.0 - numpy.linalg.norm(one.atoms - center, axis=1) / AROUND
    of_all, of_each = defaultdict(float), defaultdict(float)
    for i in numpy.flatnonzero(weights >= 0.0):
        word, number = one.words[i]
        of_all[word] = max(of_all[word], weights[i])
        of_each[word, number] = max(of_each[word, number], weights[i])
    return of_all, of_each


def likeness(a, b):
    common = sum(min(weight, b[key]) for key, weight in a.items() if key in b)
    return common / max(sum(a.values()) + sum(b.values()) - common, 1e-9)


def with_copies(one, density, centers):
    """Copies of a site are consecutive, in their order, with the mean of their densities
    (SiteCopies.h)."""
    around = [weights_around(one, center) for center in centers]
    groups = []
    for i, (of_all, of_each) in enumerate(around):
        for group in groups:
            first = around[group[0]]
            if first[0].keys().isdisjoint(of_all):
                continue
            alike = likeness(of_all, first[0])
            if alike >= 0.5 and likeness(of_each, first[1]) < 0.5 * alike:
                group.append(i)
                break
        else:
            groups.append([i])
    density = density.copy()
    for group in groups:
        density[group] = density[group].mean()
    groups.sort(key=lambda group: -density[group[0]])

    def share(i, numbers_of):
        parts = {(word, number): weight * (2.0 - list(numbers_of).index(word) / len(numbers_of))
                 for (word, number), weight in around[i][1].items()}
        return sum(part * 0.25 ** numbers_of[word].index(number) for (word, number), part in parts.items()) / max(
            sum(parts.values()), 1e-9)

    order = []
    for group in groups:
        keys = sorted({key for i in group for key in around[i][1]})
        numbers_of = {word: [number for same, number in keys if same == word] for word, _ in keys}
        order += sorted(group, key=lambda i: -share(i, numbers_of))
    return density[order], centers[order]


def hits_of(one, probabilities, reach, most=None, folder=None):
    density, centers = with_copies(one, *sites_of(one.places, probabilities, reach, most))
    if folder:
        rows = [f"{rank},{x:.3f},{y:.3f},{z:.3f}\n" for rank, (x, y, z) in enumerate(centers, 1)]
        path = folder / (one.name.split(".")[0] + "_predictions.csv")
        path.write_text("rank,center_x,center_y,center_z\n" + "".join(rows))
    distances = numpy.array([numpy.linalg.norm(one.ligand - c, axis=1).min() for c in centers])
    return density, distances <= SUCCESS


def first_and_three(hits):
    return numpy.array([[h[0], h[:3].any()] for h in hits], float)


# ---------------------------------------------------------------------------- figures

def interval(values, families, weights=None, rounds=2000):
    """95 % interval of the mean over complexes, from resampling families."""
    random = numpy.random.default_rng(0)
    names = sorted(set(families))
    rows = {name: numpy.flatnonzero(families == name) for name in names}
    sums = numpy.array([values[rows[name]].sum(axis=0) for name in names])
    counts = numpy.array([len(rows[name]) for name in names])
    picks = random.integers(0, len(names), (rounds, len(names)))
    means = sums[picks].sum(axis=1) / counts[picks].sum(axis=1).reshape((-1,) + (1,) * (sums.ndim - 1))
    return numpy.percentile(means, [2.5, 97.5], axis=0)


def say(title, hits, complexes):
    values = first_and_three(hits)
    low, high = interval(values, numpy.array([one.family for one in complexes]))
    mean = values.mean(axis=0)
    print(f"{title}: " + ", ".join(f"{name} {100 * mean[k]:.1f} [{100 * low[k]:.0f}, {100 * high[k]:.0f}]"
                                   for k, name in enumerate(("top-1", "top-3"))), flush=True)


def folds_of(families, folds, seed):
    order = numpy.random.default_rng(seed).permutation(sorted(families))
    return {family: i % folds for i, family in enumerate(order)}


def choose(complexes, judged, column):
    """Reach and number of trees by cross-validation over the families of these complexes."""
    fold = folds_of({one.family for one in complexes}, 3, 1)
    scores = Counter()
    weights = dict(zip((one.name for one in judged), family_weights(judged)))
    for k in range(3):
        model = fit([one for one in complexes if fold[one.family] != k], column, max(TREES))
        for one in judged:
            if fold[one.family] == k:
                for trees in TREES:
                    probabilities = predict(model, one, column, trees)
                    for reach in REACHES:
                        hits = hits_of(one, probabilities, reach, 12)[1]
                        scores[reach, trees] += weights[one.name] * (hits[0] + hits[:3].any())
    return max(sorted(scores), key=lambda setting: scores[setting])


def calibration_rows(densities, hits, complexes):
    weights = family_weights(complexes)
    rows = []
    for density, hit, weight, one in zip(densities, hits, weights, complexes):
        share = density / density.sum()
        rows += [(numpy.log(max(d, 1e-6)), numpy.log(max(s, 1e-6)), float(h), weight, one.family)
                 for d, s, h in zip(density, share, hit)]
    return (numpy.array([row[:2] for row in rows]), numpy.array([row[2] for row in rows]),
            numpy.array([row[3] for row in rows]), numpy.array([row[4] for row in rows]))


def fit_calibration(x, y, weights):
    from sklearn.linear_model import LogisticRegression

    model = LogisticRegression(C=1e6, max_iter=1000).fit(x, y, sample_weight=weights)
    return numpy.array([model.intercept_[0], *model.coef_[0]])


def calibrated(c, x):
    return 1.0 / (1.0 + numpy.exp(-(c[0] + x @ c[1:])))


def reliability(probability, hit, families, bins=8):
    """Bins with about equal numbers of places, each with its mean probability, observed share, interval and number."""
    order = numpy.argsort(probability, kind="stable")
    edges = [0, *(len(order) - numpy.cumsum([max(50, len(order) // 60)] * (bins - 1)))[::-1], len(order)]
    error = 0.0
    print("| mean probability | observed | 95 % over families | sites |\n|---|---|---|---|")
    for low, high in zip(edges[:-1], edges[1:]):
        some = order[low:high]
        interval_low, interval_high = interval(hit[some][:, None], families[some])
        error += len(some) * abs(probability[some].mean() - hit[some].mean())
        print(f"| {probability[some].mean():.3f} | {hit[some].mean():.3f} | {interval_low[0]:.3f} to "
              f"{interval_high[0]:.3f} | {len(some)} |")
    print(f"expected calibration error {error / len(order):.4f}, Brier score "
          f"{((probability - hit) ** 2).mean():.4f}, {len(order)} sites", flush=True)


# ---------------------------------------------------------------------------- C++

def write_table(path, model, calibration):
    propensity, booster = model
    nodes, leaves, first_nodes, first_leaves = [], [], [], []
    for tree in booster.dump_model()["tree_info"]:
        first_nodes.append(len(nodes))
        first_leaves.append(len(leaves))
        mine = []

        def visit(node, first_leaf=len(leaves), mine=mine):
            if "leaf_value" in node:
                leaves.append(node["leaf_value"])
                return -1 - (len(leaves) - 1 - first_leaf)
            assert node["decision_type"] == "<="
            at = len(mine)
            mine.append(None)
            # The largest float that is not above the threshold divides floats alike.
            threshold = numpy.float32(node["threshold"])
            if float(threshold) > node["threshold"]:
                threshold = numpy.nextafter(threshold, numpy.float32(-numpy.inf))
            low = visit(node["left_child"])
            mine[at] = (node["split_feature"], threshold, low, visit(node["right_child"]))
            return at

        if visit(tree["tree_structure"]) != 0:
            raise SystemExit("A tree consists of a single leaf: there is too little data.")
        nodes += mine
    number = lambda value: f"{float(value):.9g}"
    real = lambda value: number(value) + ("f" if "." in number(value) or "e" in number(value) else ".0f")
    lines = lambda parts, per: ",\n  ".join(", ".join(parts[i:i + per]) for i in range(0, len(parts), per))
    text = f"""// Written by Testing/Studies/train_site_model.py: {len(first_nodes)} trees.
#include "Pockets/SiteModel.h"

namespace isthmus
{{
namespace
{{

// clang-format off
const SiteModelNode Nodes[] = {{
  {lines(["{" + f"{f}, {real(t)}, {a}, {b}" + "}" for f, t, a, b in nodes], 4)} }};

const float Leaves[] = {{
  {lines([real(value) for value in leaves], 8)} }};

const int FirstNodes[] = {{
  {lines([str(i) for i in first_nodes], 16)} }};

const int FirstLeaves[] = {{
  {lines([str(i) for i in first_leaves], 16)} }};

const double Propensity[] = {{
  {lines([number(value) for value in propensity], 5)} }};
// clang-format on

}}

const SiteModelTable& GetSiteModel()
{{
  static const SiteModelTable table{{ Nodes, FirstNodes, FirstLeaves, Leaves, {len(first_nodes)}, 0.0, Propensity,
    {{ {", ".join(number(value) for value in calibration)} }} }};
  return table;
}}

}}
"""
    Path(path).write_text(text)


# ---------------------------------------------------------------------------- training

def train(options):
    complexes, names = [], None
    for path in options.files:
        some, names = load(path)
        complexes += some if path == options.files[0] else at_most(some, PER_FAMILY)
    column = names.index("Propensity")
    judged = [one for one in complexes if one.source == str(options.files[0])]
    families = {one.family for one in complexes}
    print(f"{len(complexes)} complexes of {len(families)} families; judged: {len(judged)} of "
          f"{len({one.family for one in judged})} from {options.files[0]}")
    fold = folds_of(families, FOLDS, 0)
    hits, densities = {}, {}
    for k in range(FOLDS):
        inside = [one for one in complexes if fold[one.family] != k]
        reach, trees = SHIPPED
        if options.nested:
            reach, trees = choose(inside, [one for one in inside if one in judged], column)
        model = fit(inside, column, trees)
        print(f"fold {k}: reach {reach:g}, {trees} trees", flush=True)
        for one in complexes:
            if fold[one.family] == k:
                densities[one.name], hits[one.name] = hits_of(
                    one, predict(model, one, column), reach, folder=options.centers)
    say("nested cross-validation", [hits[one.name] for one in judged], judged)
    others = [one for one in complexes if one not in judged]
    if others:
        say("the further complexes", [hits[one.name] for one in others], others)
    if options.curve:
        for share in (0.25, 0.5, 0.75):
            kept = {f for f in families if hashlib.sha1(f"curve {f}".encode()).digest()[0] < 256 * share}
            found = {}
            for k in range(FOLDS):
                inside = [one for one in complexes if fold[one.family] != k and one.family in kept]
                model = fit(inside, column, SHIPPED[1])
                for one in judged:
                    if fold[one.family] == k:
                        found[one.name] = hits_of(one, predict(model, one, column), SHIPPED[0])[1]
            say(f"with {share:g} of the families ({len(kept)})", [found[one.name] for one in judged], judged)
    # Calibration: fitted on other folds than those it is judged on.
    x, y, w, f = calibration_rows([densities[c.name] for c in complexes], [hits[c.name] for c in complexes],
                                  complexes)
    folds = numpy.array([fold[family] for family in f])
    probability = numpy.zeros(len(y))
    for k in range(FOLDS):
        probability[folds == k] = calibrated(fit_calibration(x[folds != k], y[folds != k], w[folds != k]),
                                             x[folds == k])
    reliability(probability, y, f)
    calibration = fit_calibration(x, y, w)
    model = fit(complexes, column, SHIPPED[1])
    gain = model[1].feature_importance("gain")
    print("gain: " + ", ".join(f"{names[i]} {100 * gain[i] / gain.sum():.0f}" for i in numpy.argsort(-gain)[:20]))
    if options.test:
        test, _ = load(options.test)
        found = [hits_of(one, predict(model, one, column), SHIPPED[0]) for one in test]
        say("test files", [h for _, h in found], test)
        x, y, w, f = calibration_rows([d for d, _ in found], [h for _, h in found], test)
        reliability(calibrated(calibration, x), y, f)
    if options.table:
        write_table(options.table, model, calibration)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    collecting = commands.add_parser("collect")
    collecting.add_argument("source", type=Path)
    collecting.add_argument("set", choices=("further", "left out"))
    collecting.add_argument("folder", type=Path)
    describing = commands.add_parser("describe")
    describing.add_argument("folder", type=Path)
    describing.add_argument("out")
    training = commands.add_parser("train")
    training.add_argument("files", nargs="+", help="the first is the one that is judged by")
    training.add_argument("--test")
    training.add_argument("--table")
    training.add_argument("--centers", type=Path)
    training.add_argument("--curve", action="store_true")
    training.add_argument("--nested", action="store_true")
    options = parser.parse_args()
    if options.command == "collect":
        collect(options.source, options.set, options.folder)
    elif options.command == "describe":
        describe(options.folder, options.out)
    else:
        train(options)


if __name__ == "__main__":
    main()
