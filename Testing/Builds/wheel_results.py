"""Results of two builds on the same data: those of a wheel beside those of pvpython.

    wheel_results.py DATA OUT.json [SURFACES]  writes the results of the Python that runs it, on the surfaces and five
                                               maps of the folder DATA; SURFACES: no more than so many, for a quick look
    wheel_results.py --triangles DATA FOLDER   writes all surfaces of DATA into FOLDER as triangles, by the VTK of the
                                               Python that runs it: with these, vtkOBJReader and vtkTriangleFilter of
                                               another version have no part in the results
    wheel_results.py --compare A.json B.json   prints what differs; exit status 1 if anything does
"""
import hashlib
import json
import pathlib
import sys
import warnings

SURFACES = (".off", ".obj", ".stl", ".ply", ".vtp")
MAPS = ("EMD-3197.map", "emd_1832.map", "1mru.map", "tiny1.map", "D7.ccp4")


def column(attributes, name):
    array = attributes.GetArray(name)
    return [] if array is None else [array.GetComponent(i, 0) for i in range(array.GetNumberOfTuples())]


def digest(*arrays):
    return hashlib.sha256(b"".join(bytes(memoryview(array)) for array in arrays)).hexdigest()


def of_surface(isthmus, surface):
    table = isthmus.surface_measures(surface).table
    found = {"points": surface.GetNumberOfPoints(), "cells": surface.GetNumberOfCells(),
             "genus": table.GetValueByName(0, "Genus").ToString(), "euler": table.GetValueByName(0, "EulerNumber").ToInt(),
             "area": table.GetValueByName(0, "Area").ToDouble(), "volume": table.GetValueByName(0, "Volume").ToDouble()}
    made = isthmus.choking_loops(surface)
    kinds = column(made.loops.GetCellData(), "Kind")
    found.update({f"kind {kind}": kinds.count(kind) for kind in (0, 1, 2)})
    found.update({"pairs": made.persistence_diagram.GetNumberOfRows(),
                  "points and cells of the loops": digest(made.loops.GetPoints().GetData(),
                                                          made.loops.GetLines().GetConnectivityArray()),
                  "radii": sorted(column(made.loops.GetCellData(), "Radius")),
                  "lengths": sorted(column(made.loops.GetCellData(), "Length")),
                  "deaths": sorted(column(made.loops.GetCellData(), "Death"))})
    return found


def of_map(isthmus, path):
    volume = isthmus.read(path)
    curvature = isthmus.map_to_curvature(volume).curvature
    found = of_surface(isthmus, isthmus.map_to_surface(volume))
    for name in ("MeanCurvature", "GaussianCurvature"):
        values = [value for value in column(curvature.GetPointData(), name) if value == value]
        found[name] = [len(values), sum(values), min(values), max(values)]
    return found


def collect(data, out, most):
    import isthmus
    from vtkmodules.vtkCommonCore import vtkVersion
    warnings.simplefilter("ignore")
    results = {"vtk": vtkVersion.GetVTKVersion()}
    paths = sorted(path for path in (data / "surfaces").rglob("*") if path.suffix in SURFACES)
    for path in paths[:most]:
        name = str(path.relative_to(data))
        try:
            results[name] = of_surface(isthmus, isthmus.read(path))
        except Exception as error:  # both Pythons must refuse it alike
            results[name] = {"error": f"{type(error).__name__}: {error}".replace(str(data), "")}
        print(name, len(results[name]), flush=True)
        out.write_text(json.dumps(results))
    for name in MAPS:
        try:
            results[name] = of_map(isthmus, data / "maps" / name)
        except Exception as error:
            results[name] = {"error": f"{type(error).__name__}: {error}".replace(str(data), "")}
        print(name, len(results[name]), flush=True)
        out.write_text(json.dumps(results))


def write_triangles(data, folder):
    import isthmus
    from vtkmodules.vtkFiltersCore import vtkTriangleFilter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
    warnings.simplefilter("ignore")
    for path in (data / "surfaces").rglob("*"):
        if path.suffix not in SURFACES:
            continue
        triangles, writer = vtkTriangleFilter(), vtkXMLPolyDataWriter()
        triangles.SetInputDataObject(isthmus.read(path))
        written = folder / path.relative_to(data).with_suffix(f"{path.suffix}.vtp")
        written.parent.mkdir(parents=True, exist_ok=True)
        writer.SetInputConnection(triangles.GetOutputPort())
        writer.SetFileName(str(written))
        writer.Write()


def differences(a, b):
    """Of two results: names of counts that differ, and the largest relative difference of reals."""
    counts, reals = [], {}
    for name in sorted({*a, *b}):
        one, other = a.get(name), b.get(name)
        if isinstance(one, float) or isinstance(one, list):
            one, other = ([one], [other]) if isinstance(one, float) else (one, other)
            if other is None or len(one) != len(other):
                counts.append(name)
                continue
            scale = max([abs(value) for value in one], default=0.0) or 1.0
            reals[name] = max((abs(x - y) / scale for x, y in zip(one, other)), default=0.0)
        elif one != other:
            counts.append(f"{name}: {one} and {other}")
    return counts, reals


def compare(a, b):
    print(f"VTK {a.pop('vtk')} and {b.pop('vtk')}")
    failures = 0
    for name in sorted({*a, *b}):
        counts, reals = differences(a.get(name, {}), b.get(name, {}))
        counts += [f"{key}: relative difference {value:.2g}" for key, value in reals.items() if value]
        if counts:
            print(name, *counts, sep="\n    ")
        failures += bool(counts)
    refused = sum("error" in result for result in a.values())
    print(f"{len(a)} results, {failures} with differences; {refused} are errors")
    return 1 if failures or refused * 2 > len(a) else 0


def main():
    if sys.argv[1] == "--compare":
        return compare(*[json.loads(pathlib.Path(path).read_text()) for path in sys.argv[2:4]])
    if sys.argv[1] == "--triangles":
        write_triangles(*[pathlib.Path(path) for path in sys.argv[2:4]])
        return 0
    collect(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else None)
    return 0


if __name__ == "__main__":
    sys.exit(main())
