"""What worked with the version before the modules (commit 8c2fda1) works unchanged, with deprecation warnings
where names changed: names of proxies and their properties, methods and enumerators of wrapped classes, a state file
with every filter and every property, the state files and scripts of Examples. All of these are stored in
Testing/Data/previous; CHANGELOG.md lists what is deprecated."""

import os
import re
import runpy
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree as Tree
from pathlib import Path

import isthmus
from paraview import servermanager, simple
from shared_data import shared_data

PREVIOUS = Path(__file__).resolve().parents[1] / "Data" / "previous"
sys.path.insert(0, str(PREVIOUS))
CHANGELOG = Path(__file__).resolve().parents[2] / "CHANGELOG.md"


def names_of(file):
    """{owner: [name, ...]} of a list of the previous version."""
    lines = (PREVIOUS / file).read_text().splitlines()
    return {owner: names.split() for owner, names in (line.split(":") for line in lines)}


def check_properties():
    missing = []
    manager = servermanager.ProxyManager()
    for owner, names in names_of("properties.txt").items():
        proxy = manager.NewProxy(*owner.split("."))
        missing += [f"{owner}.{name}" for name in names if not (proxy and proxy.GetProperty(name))]
        if not proxy:
            missing.append(owner)
    assert not missing, f"proxies and properties that are gone: {missing}"


def check_methods():
    missing = [f"{owner}.{name}" for owner, names in names_of("methods.txt").items()
               for name in names or [""] if not hasattr(getattr(isthmus, owner, None), name or "New")]
    assert not missing, f"methods that are gone: {missing}"


def deprecated_methods():
    """(class, old name) of each method in the table of CHANGELOG.md."""
    methods = []
    for owner, first, others in re.findall(r"^\| `(vtk\w+)::(\w+)`([^|]*)\|", CHANGELOG.read_text(), re.MULTILINE):
        methods += [(owner, name) for name in [first, *re.findall(r"`(\w+)`", others)]
                    if re.fullmatch(r"[SG]et[A-Z]\w*|\w+(On|Off)", name)]
    return methods


def check_warnings():
    """Deprecated methods still do their work, and Python warns of them."""
    methods = deprecated_methods()
    assert len(methods) >= 12, methods
    for owner, name in methods:
        instance = getattr(isthmus, owner)()
        arguments = ["" if name.endswith("Name") else 1] if name.startswith("Set") else []
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            getattr(instance, name)(*arguments)
        said = [str(warning.message) for warning in caught if warning.category is DeprecationWarning]
        assert len(said) == 1, (owner, name, said)
    measures = isthmus.vtkSurfaceMeasures()
    measures.SetIsoValue(0.25)
    assert measures.GetLevel() == 0.25 == measures.GetIsoValue()
    assert isthmus.vtkTetrahedralMesher.OUTSIDE == isthmus.vtkTetrahedralMesher.Outside == 1


def check_state():
    """The state file with every filter: each property has the value stored for it, on the VTK object, too."""
    path = str(PREVIOUS / "every_filter.pvsm")
    simple.LoadState(path)
    stored = {}
    for proxy in Tree.parse(path).getroot().iter("Proxy"):
        if proxy.get("type"):
            stored[proxy.get("type")] = {
                prop.get("name"): [element.get("value") for element in prop.findall("Element")]
                for prop in proxy.findall("Property") if prop.findall("Element")}
    manager = servermanager.ProxyManager()
    ours = {owner.split(".")[1] for owner in names_of("properties.txt") if owner.startswith("filters.")}
    assert ours <= set(stored), ours - set(stored)
    compared = 0
    for name in sorted(ours):
        proxy = manager.GetProxy("sources", name)
        assert proxy, f"{name} was not loaded"
        instance, proxy = proxy.GetClientSideObject(), proxy.SMProxy
        for key, values in stored[name].items():
            if proxy.GetProperty(key).GetInformationOnly():
                continue
            helper = servermanager.vtkSMPropertyHelper(proxy, key)
            loaded = [helper.GetAsString(i) if proxy.GetProperty(key).IsA("vtkSMStringVectorProperty")
                      else helper.GetAsDouble(i) for i in range(helper.GetNumberOfElements())]
            wanted = values if loaded and isinstance(loaded[0], str) else [float(value) for value in values]
            assert loaded == wanted, (name, key, loaded, wanted)
            compared += 1
            read = "G" + proxy.GetProperty(key).GetCommand()[1:] if proxy.GetProperty(key).GetCommand() else ""
            if len(wanted) == 1 and not isinstance(wanted[0], str) and read.startswith("Get") and \
                    hasattr(instance, read):
                assert abs(float(getattr(instance, read)()) - wanted[0]) < 1e-12 + 1e-7 * abs(wanted[0]), (name, key)
    assert compared > 300, compared
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    return len(ours), compared


def check_states():
    """The state files of Examples, with the pipelines of today's plugin."""
    states = sorted((PREVIOUS / "states").glob("*.py"))
    assert len(states) == 6, states
    os.environ["ISTHMUS_DATA_DIR"] = str(shared_data("maps").parent)
    os.environ.pop("ISTHMUS_FILE", None)
    for path in states:
        runpy.run_path(str(path))
        points = simple.GetActiveSource().GetDataInformation().GetNumberOfPoints()
        assert points > 100, (path.name, points)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)


def check_functions():
    """Functions of scripts that ask for more data or time than a test has: a solved protein, areas of regions."""
    import evaluate_electrostatics
    import surface_regions

    atoms = evaluate_electrostatics.molecule(*evaluate_electrostatics.read(shared_data("molecules/1crn_apbs.pqr")))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solver = evaluate_electrostatics.solve(atoms, "gaussian", 1.0)
    assert any("SetLevel" in str(warning.message) for warning in caught), caught
    assert solver.GetOutputDataObject(0).GetPointData().GetArray("Potential")
    sphere = simple.SurfaceCurvature(Input=simple.Sphere(ThetaResolution=24, PhiResolution=24))
    sphere.UpdatePipeline()
    lines = surface_regions.area_table(servermanager.Fetch(sphere), "MinimumCurvature", "1/A", [(0.0, 1.0)])
    assert len(lines) > 1, lines
    print(lines[-1], flush=True)


def run_script(name, *arguments, folder):
    """Runs a script of the previous version; its output may have deprecation warnings, but no errors. ParaView 6.1 has
    not all names of colours that these scripts use."""
    script, environment = PREVIOUS / name, dict(os.environ)
    if not servermanager.vtkSMTransferFunctionPresets.GetInstance().HasPreset("Viridis (matplotlib)"):
        script = folder / name
        script.write_text((PREVIOUS / name).read_text().replace("Viridis (matplotlib)", "Viridis"))
        environment["PYTHONPATH"] = os.pathsep.join([str(PREVIOUS), environment.get("PYTHONPATH", "")])
    done = subprocess.run(["pvpython", str(script), *map(str, arguments)], cwd=folder, env=environment,
                          capture_output=True, text=True, timeout=400)
    said = done.stdout + done.stderr
    assert done.returncode == 0, f"{name}: {done.returncode}: {said}"
    errors = [line for line in said.splitlines() if re.search(r"\bERR\||Error\b|Traceback", line)]
    assert not errors, f"{name}: {errors}"
    print(f"{name} runs", flush=True)


def check_scripts(folder):
    import ChooseMap

    phantom = folder / "phantom.mrc"
    ChooseMap.write_phantom(phantom)
    torus = shared_data("surfaces/torus.obj")
    protein = shared_data("molecules/1crn_apbs.pqr")
    run_script("MapToCurvature.py", phantom, folder / "curvature", 0.5, folder=folder)
    run_script("MapToMesh.py", phantom, folder / "curvature", 0.5, folder=folder)
    run_script("resample_map.py", phantom, folder / "small.vti", 12, folder=folder)
    run_script("map_handles.py", phantom, folder / "handles.png", folder=folder)
    run_script("choking_loops.py", torus, folder / "loops.png", folder=folder)
    run_script("flow_surfaces.py", protein, folder, folder=folder)


check_properties()
check_methods()
check_warnings()
filters, values = check_state()
print(f"{filters} filters of a state file with {values} values", flush=True)
check_states()
check_functions()
with tempfile.TemporaryDirectory() as place:
    check_scripts(Path(place))
