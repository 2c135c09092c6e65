"""How well do polarized curvature, curvature alone and potential alone find ligands?

Usage: pvpython evaluate_binding_sites.py FOLDER [--work FOLDER] [--surfaces NAMES] [--potentials NAMES]
                                          [--sweep]

FOLDER contains ligands.csv (file, ligand_residue) and the complexes listed there. Charges by pdb2pqr, without
the ligand, and APBS' potentials are kept in the folder --work, if given, and reused. --surfaces: gaussian
(Molecular Density), flow (Molecular Flow Surface) or both. --potentials: ours (Poisson Boltzmann, fitted
at the surface), apbs (interpolated in its grid) or both. Default: gaussian, ours; a table for each.
Success: the center of the best patch (of one of the three best) within 4 angstrom of an atom of the
ligand. --sweep repeats polarized curvature over surface decay, quantile and merge distance, and
cross-validates: each complex is evaluated with the setting that is best on all others.
Needs scipy (python3-scipy) for the random patches. Prints Markdown.
"""

import argparse
import csv
import itertools
import sys
from pathlib import Path

import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

sys.path.insert(0, str(Path(__file__).resolve().parent))
import study_paths  # noqa: E402,F401 (before the modules of Examples)
import apbs_potential  # noqa: E402
import site_pipeline  # noqa: E402
from output_folder import output_folder  # noqa: E402

SUCCESS = 4.0  # angstrom
DRAWS = 200
ALL_POINTS, ABSOLUTE, NEGATIVE = 3, 0, 2
METHODS = {
    "polarized curvature": {},
    "kappa_2 alone": {"array": "MinimumCurvature", "Classes": ALL_POINTS, "Amplitude": NEGATIVE},
    "potential alone": {"array": "Potential", "Classes": ALL_POINTS, "Amplitude": ABSOLUTE},
}
KINDS = (("gaussian", "flow"), ("ours", "apbs"))
SWEEP = {"decay": (0.8, 1.0, 1.2, 1.5, 2.3), "Quantile": (0.9, 0.93, 0.96),
         "MergeDistance": (0.0, 1.0, 2.0)}


class Complex:
    """A protein with charges and potential, and where its ligand is."""

    def __init__(self, path, residue, work, with_apbs):
        self.name = path.name.split(".")[0]
        protein, ligand, self.residue = apbs_potential.split(path, residue)
        self.ligand = [apbs_potential.position_of(line) for line in ligand]
        self.notes = ""
        pqr, notes = work / f"{self.name}.pqr", work / f"{self.name}.notes"
        if not notes.exists():
            pqr, removed, dropped = apbs_potential.charges(protein, work, self.name)
            text = [f"removed {residue}" for residue in removed]
            text += [f"left out {residue}" for residue in dropped]
            notes.write_text(", ".join(text))
        self.notes = notes.read_text()
        self.atoms = site_pipeline.read_atoms(pqr)
        self.potential = None
        if with_apbs:
            if not list(work.glob(f"{self.name}_potential*.dx")):
                apbs_potential.potential(pqr, work, self.name)
            self.potential = site_pipeline.read_potential(
                next(work.glob(f"{self.name}_potential*.dx"))
            )
        self.kind = ("gaussian", "ours")
        self.surfaces = {}

    def surface(self, decay):
        """The surface of the chosen kind; the decay is not used for the flow surface."""
        key = (self.kind, decay)
        if key not in self.surfaces:
            if self.kind[0] == "flow":
                bare = site_pipeline.outer_surface(site_pipeline.flow_image(self.atoms), 0.0, higher=False)
            else:
                bare = site_pipeline.outer_surface(site_pipeline.density(self.atoms, decay))
            self.surfaces[key] = (
                site_pipeline.polarized(bare, self.potential) if self.kind[1] == "apbs"
                else site_pipeline.polarized(site_pipeline.with_potential(bare, self.atoms)))
        return self.surfaces[key]

    def distances(self, decay, settings):
        """Distances of the three best centers from the ligand, and the areas of the patches."""
        _, rows = site_pipeline.sites(self.surface(decay), **settings)
        found = [
            site_pipeline.distance_to(self.ligand, site_pipeline.center(row)) for row in rows[:3]
        ]
        return found, [row["Area"] for row in rows[:3]]

    def random_success(self, areas, generator):
        """Fractions of draws in which random patches of these areas succeed: for the first patch, and for any of
        three."""
        surface = self.surface(site_pipeline.DECAY)
        points, triangles = site_pipeline.points_of(surface), site_pipeline.triangles_of(surface)
        weight = site_pipeline.point_areas(surface)
        edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        lengths = numpy.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
        graph = coo_matrix((lengths, edges.T), shape=(len(points), len(points))).tocsr()
        hits = numpy.zeros((DRAWS, len(areas)), bool)
        for draw, (column, area) in itertools.product(range(DRAWS), enumerate(areas)):
            seed = generator.choice(len(points), p=weight / weight.sum())
            reach = 3.0 * numpy.sqrt(area / numpy.pi)
            away = dijkstra(graph, indices=seed, limit=reach)
            order = numpy.argsort(away)
            order = order[: numpy.searchsorted(numpy.cumsum(weight[order]), area) + 1]
            order = order[numpy.isfinite(away[order])]
            middle = numpy.average(points[order], axis=0, weights=weight[order])
            hits[draw, column] = site_pipeline.distance_to(self.ligand, middle) <= SUCCESS
        return hits[:, 0].mean(), hits.any(axis=1).mean()


def load(folder, work, with_apbs):
    complexes = []
    for row in csv.DictReader(open(folder / "ligands.csv")):
        try:
            complexes.append(Complex(folder / row["file"], row["ligand_residue"], work, with_apbs))
        except (Exception, SystemExit) as error:  # one bad complex does not end the evaluation
            print(f"{row['file']}: left out, {error}", file=sys.stderr)
            continue
        print(f"{complexes[-1].name}: {complexes[-1].notes or 'complete'}", file=sys.stderr)
    if not complexes:
        sys.exit("None of the complexes could be prepared.")
    return complexes


def compare(complexes, kind):
    for c in complexes:
        c.kind = kind
    print(f"\nsurface: {kind[0]}; potential: {kind[1]}; n = {len(complexes)}; success: within "
          f"{SUCCESS:g} angstrom\n")
    print("| method | " + " | ".join(c.name for c in complexes) + " | top-1 | top-3 |")
    print("|---|" + "---|" * (len(complexes) + 2))
    areas = {}
    for method, settings in METHODS.items():
        cells, first, three = [], 0, 0
        for c in complexes:
            found, sizes = c.distances(site_pipeline.DECAY, dict(settings))
            areas.setdefault(c.name, sizes)
            cells.append(f"{found[0]:.1f} ({min(found):.1f})" if found else "none")
            first += bool(found) and found[0] <= SUCCESS
            three += bool(found) and min(found) <= SUCCESS
        print(f"| {method} | " + " | ".join(cells) + f" | {first} | {three} |", flush=True)
    generator = numpy.random.default_rng(20240229)
    chances = [c.random_success(areas[c.name], generator) for c in complexes]
    cells = [f"{100 * one:.0f} % ({100 * three:.0f} %)" for one, three in chances]
    totals = [sum(chance[i] for chance in chances) for i in (0, 1)]
    print("| random patches | " + " | ".join(cells) + f" | {totals[0]:.1f} | {totals[1]:.1f} |")


def quality(results, among):
    """Sort key of settings: number of successes first, then near misses."""
    found = [results[i] for i in among]
    first = sum(d[0] <= SUCCESS for d in found)
    three = sum(min(d) <= SUCCESS for d in found)
    return first, three, -sum(d[0] for d in found)


def sweep(complexes):
    everyone = range(len(complexes))
    print("\n| method | best setting | its top-1, top-3 | median | worst | leave one out |")
    print("|---|---|---|---|---|---|")
    for method, fixed in METHODS.items():
        results = {}
        for decay, *rest in itertools.product(*SWEEP.values()):
            settings = {**fixed, **dict(zip(list(SWEEP)[1:], rest))}
            key = ", ".join(f"{value:g}" for value in (decay, *rest))
            results[key] = [c.distances(decay, dict(settings))[0] for c in complexes]
        counts = numpy.array([quality(found, everyone)[:2] for found in results.values()])
        best = max(results, key=lambda s: quality(results[s], everyone))
        judged = []
        for left_out in everyone:
            others = [i for i in everyone if i != left_out]
            chosen = max(results, key=lambda s: quality(results[s], others))
            judged.append(results[chosen][left_out])
        cells = [quality(results[best], everyone), numpy.median(counts, axis=0),
                 counts.min(axis=0), quality(judged, everyone)]
        text = " | ".join(f"{cell[0]:g}, {cell[1]:g}" for cell in cells)
        print(f"| {method} | {best} | {text} |", flush=True)
    print(f"\nSettings are decay, quantile, merge distance: {len(results)} of them.")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--work", type=Path)
    parser.add_argument("--surfaces", nargs="*", choices=KINDS[0], default=KINDS[0][:1])
    parser.add_argument("--potentials", nargs="*", choices=KINDS[1], default=KINDS[1][:1])
    parser.add_argument("--sweep", action="store_true")
    options = parser.parse_args()
    complexes = load(options.folder, output_folder(options.work), "apbs" in options.potentials)
    for kind in itertools.product(options.surfaces, options.potentials):
        compare(complexes, kind)
    if options.sweep:  # on Gaussian surfaces, for several decay rates
        for c in complexes:
            c.kind = ("gaussian", options.potentials[-1])
        sweep(complexes)


if __name__ == "__main__":
    main()
