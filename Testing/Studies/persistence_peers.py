"""Compares Scalar Persistence with GUDHI and Cubical Ripser: CPU time, memory, and whether the pairs are equal.

Usage: pvpython persistence_peers.py [MAP ...] [--peers PYTHON] [--size NODES] [--volumes NAME ...] [--threads 1 2]

Volumes of SIZE^3 nodes (192 by default, as in the comparison of 36 volumes by P. Guillou, J. Vidal and J. Tierny,
Discrete Morse Sandwich, IEEE Trans. Vis. Comput. Graph. 30 (2024) 1897): elevation (the least topology), random (the
most), waves, a gyroid, and the given maps, resampled. --peers: a Python interpreter that has the PyPI packages gudhi
and cripser. Every computation is a process of its own. Time is CPU time of the computation alone, memory the largest
resident memory of the process above that before the computation. Equal: the number of pairs of each dimension and the
sum of their persistence (to 1e-6 relative). All programs use the V-construction, in float. Prints Markdown.

A large smooth volume, without peers: --size 1024 --volumes gyroid --threads 2
"""

import argparse
import json
import re
import subprocess
import tempfile
import time
from pathlib import Path

import numpy

PEERS = {
    "GUDHI": """
import gudhi
complex = gudhi.CubicalComplex(vertices=volume)
pairs = complex.persistence(homology_coeff_field=2, min_persistence=0)
rows = [(d, b, e) for d, (b, e) in pairs if e != float("inf") and e != b]
""",
    "Cubical Ripser": """
import cripser
pairs = cripser.computePH(volume.astype(float), maxdim=2)
pairs = pairs[numpy.abs(pairs[:, 2]) < 1e300]
rows = pairs[pairs[:, 1] != pairs[:, 2]][:, :3]
""",
}
FRAME = """
import json, re, sys, time
import numpy
def peak():
    return int(re.search(r"VmHWM:\\s+(\\d+)", open("/proc/self/status").read())[1])
volume = numpy.load(sys.argv[1])
before = peak()
start = time.process_time()
{body}
seconds = time.process_time() - start
memory = peak() - before
rows = numpy.array(rows, dtype=float).reshape(-1, 3)
print(json.dumps([seconds, memory / 1024.0, [[int((rows[:, 0] == d).sum()),
    float(numpy.abs(rows[rows[:, 0] == d, 2] - rows[rows[:, 0] == d, 1]).sum())] for d in range(3)]]))
"""


def peak():
    """KiB. Unlike getrusage, this does not include the process that started this one."""
    return int(re.search(r"VmHWM:\s+(\d+)", Path("/proc/self/status").read_text())[1])


def layer(name, x, y, z):
    """The values of a volume at one x, in double."""
    if name == "elevation":
        return x + 1e-3 * y + 1e-6 * z
    if name == "waves":
        return numpy.sin(25 * x) * numpy.sin(31 * y) * numpy.sin(37 * z) + 0.1 * x + 0.05 * y
    if name == "gyroid":
        u, v, w = (30 * t for t in (x, y, z))
        return numpy.sin(u) * numpy.cos(v) + numpy.sin(v) * numpy.cos(w) + numpy.sin(w) * numpy.cos(u) + 0.1 * z
    raise ValueError(f"{name} is none of elevation, random, waves, gyroid")


def make(name, size):
    if name == "random":
        return numpy.random.default_rng(0).random((size, size, size)).astype(numpy.float32)
    axis = numpy.linspace(0.0, 1.0, size)
    volume = numpy.empty((size, size, size), numpy.float32)
    for place, x in zip(volume, axis):
        place[:] = layer(name, x, axis[:, None], axis)
    return volume


def resample(path, size):
    """The map on size^3 nodes, trilinear."""
    import study_paths  # noqa: F401 (before isthmus)
    import isthmus
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkImagingCore import vtkImageResample

    resampled = vtkImageResample()
    image = isthmus.read(str(path))
    resampled.SetInputData(image)
    for axis, count in enumerate(image.GetDimensions()):
        resampled.SetAxisMagnificationFactor(axis, (size - 0.5) / (count - 0.5))
    resampled.Update()
    output = resampled.GetOutput()
    values = vtk_to_numpy(output.GetPointData().GetScalars()).astype(numpy.float32)
    return values.reshape(output.GetDimensions()[::-1])


def by_isthmus(path, threads):
    """Run in a process of its own."""
    import study_paths  # noqa: F401 (before isthmus)
    import isthmus
    from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkSMPTools
    from vtkmodules.vtkCommonDataModel import vtkImageData

    vtkSMPTools.Initialize(threads)
    volume = numpy.load(path)
    image = vtkImageData()
    image.SetDimensions(volume.shape[::-1])
    image.GetPointData().SetScalars(numpy_to_vtk(volume.ravel()))
    persistence = isthmus.vtkScalarPersistence()
    persistence.SetInputData(image)
    before = peak()
    start = time.process_time()
    persistence.Update()
    seconds = time.process_time() - start
    memory = peak() - before
    table = persistence.GetOutputDataObject(1)
    columns = [vtk_to_numpy(table.GetColumnByName(name)) for name in ("Dimension", "Birth", "Death")]
    rows = numpy.stack(columns, axis=1).astype(float)
    rows = rows[1:] if len(rows) and rows[0, 0] == 0 else rows  # the class that never dies
    print(json.dumps([seconds, memory / 1024.0, [
        [int((rows[:, 0] == d).sum()), float(numpy.abs(rows[rows[:, 0] == d, 2] - rows[rows[:, 0] == d, 1]).sum())]
        for d in range(3)]]))


def run(command):
    result = subprocess.run(command, capture_output=True, text=True)
    return json.loads(result.stdout.splitlines()[-1]) if result.returncode == 0 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("maps", nargs="*", type=Path)
    parser.add_argument("--peers")
    parser.add_argument("--size", type=int, default=192)
    parser.add_argument("--volumes", nargs="*", default=["elevation", "random", "waves", "gyroid"])
    parser.add_argument("--threads", nargs="*", type=int, default=[1, 2])
    parser.add_argument("--own", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.own:
        by_isthmus(options.own[0], int(options.own[1]))
        return
    print("| volume | program | CPU seconds | MiB | pairs of dimension 0, 1, 2 | equal |")
    print("|---|---|---|---|---|---|")
    volumes = [(name, None) for name in options.volumes] + [(path.name, path) for path in options.maps]
    for name, path in volumes:
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "volume.npy"
            numpy.save(file, resample(path, options.size) if path else make(name, options.size))
            known = None
            programs = [(f"Isthmus, threads: {threads}", ["pvpython", __file__, "--own", str(file), str(threads)])
                        for threads in options.threads]
            if options.peers:
                programs += [(program, [options.peers, "-c", FRAME.format(body=body), str(file)])
                             for program, body in PEERS.items()]
            for program, command in programs:
                found = run(command)
                if not found:
                    print(f"| {name} | {program} | fails | | | |", flush=True)
                    continue
                known = known or found[2]
                same = all(a[0] == b[0] and abs(a[1] - b[1]) <= 1e-6 * max(1.0, a[1]) for a, b in zip(known, found[2]))
                print(f"| {name} | {program} | {found[0]:.2f} | {found[1]:.0f} | "
                      f"{', '.join(str(part[0]) for part in found[2])} | {'yes' if same else 'no'} |", flush=True)


if __name__ == "__main__":
    main()
