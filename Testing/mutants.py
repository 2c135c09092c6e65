#!/usr/bin/env python3
"""Makes mistakes on purpose, one at a time, and looks that the test which is there for it fails.

    Testing/mutants.py BUILD [NAME...]

BUILD is a build folder of this tree with tests, up to date. Each mutant replaces one piece of a source,
builds what the test needs, runs the test, and puts the source back. A test that passes all the same is
told, and the script ends with 1. Refuses a tree with uncommitted changes, since it edits sources in place.

An audit found these tests asserting nothing; MUTANTS has one mistake for each that it let pass.
"""
import os
import pathlib
import re
import subprocess
import sys

import put_back

ROOT = pathlib.Path(__file__).resolve().parent.parent
CGAL = "Filters/Tetrahedra/CGALTetrahedra.cxx"
FIVE = "TestTetrahedralProperties", "TetrahedralProperties.CGALKeepsItsFiveCriteria"

# name: (file, what stands there, the mistake, (program, GoogleTest filter) or a script of Testing/Python
# with its arguments)
MUTANTS = {
    "TetGen's ratio is not passed on": (
        "Filters/Tetrahedra/TetGenTetrahedra.cxx", '"q" + Number(criteria.RadiusEdgeRatio)', '"q" + Number(2.0)',
        ("TestTetrahedralMesher", "TetrahedralMesher.TetGenKeepsItsBounds")),
    "CGAL's facet angle is not passed on": (
        CGAL, "params::facet_angle = c.FacetAngle", "params::facet_angle = 0.0 * c.FacetAngle", FIVE),
    "CGAL's facet size is not passed on": (
        CGAL, "params::facet_size = facets", "params::facet_size = cells", FIVE),
    "CGAL's facet distance is not passed on": (
        CGAL, "params::facet_distance = c.FacetDistance", "params::facet_distance = 10.0 * c.FacetDistance", FIVE),
    "CGAL's radius-edge ratio is not passed on": (
        CGAL, "params::cell_radius_edge_ratio = c.CellRadiusEdgeRatio",
        "params::cell_radius_edge_ratio = 4.0 * c.CellRadiusEdgeRatio", FIVE),
    "CGAL's cell size is not passed on": (
        CGAL, "params::cell_size = cells", "params::cell_size = (static_cast<void>(cells), 0.0)", FIVE),
    "A histogram is a bin off": (
        "Filters/Tetrahedra/MeshQuality.cxx", "static_cast<int>(angle / 180.0 * bins)",
        "static_cast<int>(angle / 180.0 * bins) + 1",
        ("TestMeshQuality", "MeshQuality.HistogramCountsEveryAngleOnce")),
    "Every node counts as irregular": (
        "Filters/Surfaces/SurfaceCrossings.cxx", "irregular[static_cast<std::size_t>(node)] = any;",
        "irregular[static_cast<std::size_t>(node)] = any || true;", ("TestSurfaceToGrid", "*")),
    "A ball's area is 5 % too large": (
        "Filters/Curvature/EdgeTensor.cxx", "sums.Area += AreaInBall(", "sums.Area += 1.05 * AreaInBall(",
        ("TestEdgeTensor", "SurfaceCurvature.BallAndDiscHaveTheirAreas")),
    "An open fan begins at its wrong end": (
        "Filters/CellComplex/EdgeTable.cxx", "  if (this->Mesh.IsOutside(this->Mesh.Beta3(this->Mesh.Beta2(dart))))\n  {\n    return true;",
        "  if (this->Mesh.IsOutside(this->Mesh.Beta3(dart)))\n  {\n    return true;", ("TestCompactCombinatorialMap", "*")),
    "The mesher refuses everything": (
        "Filters/Tetrahedra/TetrahedralMesher.cxx", "demand(c.FacetAngle >= 0.0 &&", "demand(c.FacetAngle < 0.0 &&",
        ("TestMeshingFuzz", "MeshingFuzz.CGAL")),
    "The picture of six descriptors is blank": (
        "Examples/MapToCurvature.py", '    simple.ColorBy(display, ("POINTS", array))',
        '    simple.ColorBy(display, ("POINTS", array))\n    display.Visibility = 0', "MapToCurvature.py"),
    "Gaussian curvature is 3 % too large": (
        "Filters/Curvature/HessianCurvatureRows.cxx", "shape.Gaussian[i] = valid ? gaussian", "shape.Gaussian[i] = valid ? 1.03 * gaussian",
        "MapToCurvature.py"),
    "A panel's number goes nowhere": (
        "Plugin/MapSurface.xml", 'command="SetMinimumComponentArea"', 'command="SetMinimumComponentShare"',
        "PropertyEffects.py MapSurface"),
    "A function on a mesh has no error": (
        "Filters/ChokingLoops/FeatureDiagram.cxx", "const double jung = std::sqrt(3.0 / 8.0);", "const double jung = 0.0;",
        ("TestLowerStarFiltration", "MorseFunctions.MeshMadeInside")),
    "Faces of the box are not split": (
        "Filters/Tetrahedra/TetGenTetrahedra.cxx", "criteria.KeepSurface && (criteria.RadiusEdgeRatio > 0.0 ||",
        "!criteria.KeepSurface && (criteria.RadiusEdgeRatio > 0.0 ||",
        ("TestTetrahedralMesher", "TetrahedralMesher.TetGenKeepsItsBoundsBesideAKeptSurface")),
    "A repair that changes the genus does not say so": (
        "Filters/Surfaces/SurfaceMeasures.cxx", 'change("the genus", old.Whole.Genus, now.Whole.Genus)',
        'change("the genus", old.Whole.Genus, old.Whole.Genus)', ("TestSurfaceMending", "RepairReport.TellsThatTheGenusChanged")),
    "Coupling moves the wrong field": (
        "Filters/Imaging/DiffusionHighPass.cxx", "u[n] += ofU * difference;", "u[n] += (ofU > 0 ? ofV : ofU) * difference;",
        ("TestDiffusionHighPass", "DiffusionHighPass.CouplingPullsEachFieldByItsOwnRate")),
    "Coupling changes equal fields": (
        "Filters/Imaging/DiffusionHighPass.cxx", "const T difference = v[n] - u[n];",
        "const T difference = static_cast<T>(0.999) * v[n] - u[n];",
        ("TestDiffusionHighPass", "DiffusionHighPass.CouplingKeepsEqualFieldsEqual")),
    "The solvent's pull is half as strong": (
        "Filters/MolecularSurfaces/Dispersion.cxx", "static_cast<double>(value)) / tension);",
        "static_cast<double>(value)) / (2.0 * tension));", ("TestNonpolarEnergy", "NonpolarEnergy.PullIsThatOfTheEquation")),
    "The field is not relaxed": (
        "Filters/Solvation/SolvationFlow.cxx", "? this->Parameters.Policy.FieldRelaxation : 1.0", "? 1.0 : 1.0",
        ("TestSolvationFlow", "SolvationFlow.RelaxationTakesItsShare")),
    "A cutaway goes deep first": (
        "Filters/CellComplex/TetCutaway.cxx", "map.Neighbours(queue[next])", "map.Neighbours(queue[queue.size() - 1 - next % 2])",
        ("TestTetCutaway", "TetCutaway.RemovesTheNearestFirst")),
}


def git(*arguments):
    return subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def environment(build):
    package = next(build.glob("lib/python3*/site-packages"))
    output = build / "mutants"
    output.mkdir(exist_ok=True)
    return dict(os.environ, PV_PLUGIN_PATH=str(build / "lib/isthmus/plugins"), PYTHONPATH=str(package),
                ISTHMUS_EXAMPLES_DIR=str(ROOT / "Examples"), ISTHMUS_PANELS_DIR=str(ROOT / "Plugin"),
                ISTHMUS_TEST_OUTPUT_DIR=str(output), ISTHMUS_REQUIRE_DATA="1",
                ISTHMUS_DATA_DIR=os.environ.get("ISTHMUS_DATA_DIR", str(ROOT / "../shared/data")))


def unit_test(name, filter_):
    """The program that has the tests of Testing/Unit/<module>/NAME.cxx, and a filter; "*": all of the file."""
    path = next((ROOT / "Testing/Unit").rglob(name + ".cxx"))
    if filter_ == "*":
        suites = set(re.findall(r"^TEST(?:_F|_P)?\((\w+),", path.read_text(), re.MULTILINE))
        filter_ = ":".join(f"{prefix}{suite}.*" for suite in sorted(suites) for prefix in ("", "*/"))
    return "Test" + path.parent.name, filter_


def passes(test, build):
    """Whether the test, built anew, passes."""
    program, filter_ = unit_test(*test) if isinstance(test, tuple) else ("all", "")
    put_back.run(["cmake", "--build", str(build), "--target", program], stdout=subprocess.DEVNULL).check_returncode()
    if isinstance(test, tuple):
        command = [str(build / "Testing/Unit" / program), "--gtest_filter=" + filter_]
    else:
        script, *arguments = test.split()
        command = ["xvfb-run", "-a", "pvpython", str(ROOT / "Testing/Python" / script), *arguments]
    return put_back.run(command, env=environment(build), cwd=ROOT / "Testing/Python", stdout=subprocess.DEVNULL,
                        stderr=subprocess.DEVNULL, timeout=1200).returncode == 0


def survives(mutant, build):
    file, right, wrong, test = mutant
    path = ROOT / file
    text = path.read_text()
    if text.count(right) != 1:
        sys.exit(f"{file}: {right!r} stands there {text.count(right)} times: the mutant needs another place.")
    try:
        path.write_text(text.replace(right, wrong))
        return passes(test, build)
    finally:
        with put_back.uninterrupted():
            path.write_text(text)


def main(build, *names):
    if git("status", "--porcelain", "--untracked-files=no"):
        sys.exit("The tree has uncommitted changes: commit them first, since mutants edit the sources.")
    wrong = set(names) - set(MUTANTS)
    if wrong:
        sys.exit(f"No such mutants: {', '.join(wrong)}.\nThere are: " + ", ".join(MUTANTS))
    put_back.end_by_exception()
    survivors = []
    for name in names or MUTANTS:
        alive = survives(MUTANTS[name], pathlib.Path(build).resolve())
        print(f"{'SURVIVES' if alive else 'found'}: {name}", flush=True)
        survivors += [name] if alive else []
    subprocess.run(["cmake", "--build", str(build)], check=True, stdout=subprocess.DEVNULL)
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    if len(sys.argv) < 2 or {"-h", "--help"} & set(sys.argv[1:]):
        sys.exit(__doc__)
    main(*sys.argv[1:])
