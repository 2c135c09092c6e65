"""What other readers find in maps and in grids of values: JSON lines for each path on standard input.

Run by GridCorpus.py in a Python that has gemmi, mrcfile and GridDataFormats:

    {"path": ..., "mrcfile": {"size": [4, 4, 4], "spacing": [...], "origin": [...], "values": "5d3a..."}, ...}

Axes are x, y, z. `values` is the checksum of all values as doubles, x fastest. The origin is where the
first value lies: for mrcfile by the header's ORIGIN, or where that is 0 by NXSTART; for gemmi, which ignores
ORIGIN, by NXSTART, and only where ORIGIN is 0. A quantity that a reader does not give is missing.
"""

import warnings

import gemmi
import mrcfile
import numpy

from peer_tools import answer_paths, checksum

warnings.filterwarnings("ignore")
try:
    from gridData import Grid
except ImportError:
    Grid = None


def is_map(path):
    return not path.lower().removesuffix(".gz").removesuffix(".bz2").endswith(".dx")


def by_mrcfile(path):
    if not is_map(path):
        return None
    with mrcfile.open(path, permissive=True) as file:
        header, data = file.header, file.data
        if data is None:
            return "no data"
        if file.is_volume_stack():
            data = data[0]
        data = data.reshape((1,) * (3 - data.ndim) + data.shape)
        axes = [int(header[name]) - 1 for name in ("mapc", "mapr", "maps")]
        # The file's columns, rows and sections are x, y, z in the order of `axes`.
        values = data.transpose(2, 1, 0).transpose([axes.index(axis) for axis in range(3)])
        sampling = [int(header[name]) for name in ("mx", "my", "mz")]
        lengths = [float(header.cella[name]) for name in ("x", "y", "z")]
        angles = [float(header.cellb[name]) for name in ("alpha", "beta", "gamma")]
        start = [int(header[name]) for name in ("nxstart", "nystart", "nzstart")]
        origin = [float(header.origin[name]) for name in ("x", "y", "z")]
    found = {"size": list(values.shape), "values": checksum(values, "<f8")}
    if min(sampling) < 1 or min(lengths) <= 0:
        return found
    found["spacing"] = [length / steps for length, steps in zip(lengths, sampling)]
    if any(origin):
        found["origin"] = origin
    elif all(abs(angle - 90) < 0.01 for angle in angles):
        starts = [start[axes.index(axis)] for axis in range(3)]
        found["origin"] = [s * step for s, step in zip(starts, found["spacing"])]
    return found


def by_gemmi(path):
    if not is_map(path):
        return None
    if path.endswith(".bz2"):
        return None
    file = gemmi.read_ccp4_map(path)
    axes = [file.header_i32(word) - 1 for word in (17, 18, 19)]
    order = [axes.index(axis) for axis in range(3)]
    values = numpy.array(file.grid.array).transpose(order)
    found = {"size": list(values.shape), "values": checksum(values, "<f8")}
    cell = file.grid.unit_cell
    sampling = [file.header_i32(word) for word in (8, 9, 10)]
    found["spacing"] = [length / steps for length, steps in zip((cell.a, cell.b, cell.c), sampling)]
    start = [file.header_i32(word) for word in (5, 6, 7)]
    if not any(file.header_float(word) for word in (50, 51, 52)):
        fractions = [start[order[axis]] / sampling[axis] for axis in range(3)]
        found["origin"] = list(cell.orthogonalize(gemmi.Fractional(*fractions)).tolist())
    return found


def by_griddataformats(path):
    if Grid is None or is_map(path):
        return None
    grid = Grid(path)
    return {"size": list(grid.grid.shape), "values": checksum(grid.grid, "<f8"),
            "spacing": [float(step) for step in numpy.asarray(grid.delta).ravel()[:3]],
            "origin": [float(x) for x in grid.origin]}


if __name__ == "__main__":
    answer_paths({"mrcfile": by_mrcfile, "gemmi": by_gemmi, "GridDataFormats": by_griddataformats})
