"""The example for maps larger than memory, on a small one with little memory: as in one piece, resumable."""

import os
import subprocess
import sys
from pathlib import Path

import mrcfile
import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkMassProperties
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
import large_map  # noqa: E402

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "LargeMap"
OUTPUT.mkdir(parents=True, exist_ok=True)
SIZE = (70, 90, 110)
SPACING, ORIGIN, LEVEL = 1.3, (3.0, 4.0, 5.0), 0.5
source, target = str(OUTPUT / "noisy.mrc"), str(OUTPUT / "denoised.mrc")


def noisy():
    """Twelve balls in white noise, indexed z, y, x."""
    random = numpy.random.default_rng(7)
    places = numpy.indices(SIZE[::-1])
    values = random.normal(0, 0.3, SIZE[::-1])
    for _ in range(12):
        center = random.uniform(0.2, 0.8, 3) * SIZE[::-1]
        values += numpy.exp(-((places - center.reshape(3, 1, 1, 1)) ** 2).sum(0) / (2 * random.uniform(3, 6) ** 2))
    with mrcfile.new(source, values.astype("f4"), overwrite=True) as file:
        file.voxel_size, file.header.origin = SPACING, ORIGIN


def everything():
    return [bound for nodes in SIZE for bound in (0, nodes - 1)]


def in_one_piece(most):
    file = large_map.Map(source)
    parameters = large_map.choose(file, 0.5, most)
    return large_map.values(large_map.denoised(file, everything(), parameters), everything()).copy()


def blocks_until(stop):
    """Denoises by blocks, with an end like Ctrl-C's before block `stop` of this call; how many were done."""
    plain, count = large_map.denoised, 0

    def counted(*arguments):
        nonlocal count
        if count == stop:
            raise KeyboardInterrupt
        count += 1
        return plain(*arguments)

    large_map.denoised = counted
    try:
        large_map.denoise(source, target, 0.5, most)
    except KeyboardInterrupt:
        pass
    large_map.denoised = plain
    return count


noisy()
most = SIZE[0] * 62 * 62  # nodes: blocks of less than a third of the map
whole = in_one_piece(most)
all_of_them = blocks_until(None)
assert all_of_them >= 4, all_of_them
with mrcfile.open(target) as file:
    result, header = file.data.copy(), file.header.copy()
difference = abs(result - whole).max() / whole.std()
print(f"{all_of_them} blocks: {difference:.1e} of the deviation from one piece")
assert 0 < difference < 5e-6, difference
assert abs(whole - mrcfile.open(source).data).max() > 0.5  # something was done at all
for name, value in (("dmin", result.min()), ("dmax", result.max()), ("dmean", result.mean(dtype="f8")),
                    ("rms", result.std(dtype="f8"))):
    assert abs(float(header[name]) - value) < 1e-5, (name, header[name], value)

# Ended in the middle it goes on there, and comes to the same values.
Path(target).unlink()
assert blocks_until(2) == 2 and Path(target + ".blocks").exists()
assert blocks_until(None) == all_of_them - 2
assert not Path(target + ".blocks").exists()
with mrcfile.open(target) as file:
    assert (file.data == result).all() and file.header.dmean == header.dmean
print("resumed after two blocks: the same values")

# The file is the map that ParaView reads, in its place; its surface in pieces is that of one piece.
again = large_map.Map(target).read(everything())
assert numpy.allclose(again.GetSpacing(), SPACING) and numpy.allclose(again.GetOrigin(), ORIGIN)
assert (vtk_to_numpy(again.GetPointData().GetScalars()).reshape(SIZE[::-1]) == result).all()
edges = vtkFlyingEdges3D()
edges.SetInputData(again)
edges.SetValue(0, LEVEL)
edges.Update()
large_map.contour(target, LEVEL, most)


def area(surface):
    properties = vtkMassProperties()
    properties.SetInputData(surface)
    return properties.GetSurfaceArea()


reader = vtkXMLMultiBlockDataReader()
reader.SetFileName(str(OUTPUT / "denoised_surface.vtm"))
reader.Update()
pieces = [reader.GetOutput().GetBlock(i) for i in range(reader.GetOutput().GetNumberOfBlocks())]
pieces = [piece for piece in pieces if piece.GetNumberOfCells()]
assert len(pieces) >= 2
assert sum(piece.GetNumberOfCells() for piece in pieces) == edges.GetOutput().GetNumberOfCells() > 1000
assert abs(sum(map(area, pieces)) / area(edges.GetOutput()) - 1) < 1e-6
print(f"{len(pieces)} pieces of surface: the triangles and the area of one piece")


def refused(*arguments):
    """What the script says when it ends with an error."""
    ended = subprocess.run(["pvpython", "--force-offscreen-rendering", large_map.__file__, *arguments],
                           capture_output=True, text=True, timeout=100)
    assert ended.returncode != 0, arguments
    return ended.stdout + ended.stderr


assert "increase --memory" in refused(source, target, "--memory", "0.401")
assert "is not a map that can be read" in refused(str(OUTPUT / "none.mrc"), target)
done = Path(target + ".blocks")
done.write_text('{"job": ["another map"], "sums": {}}')
assert "remove it to start again" in refused(source, target)
done.unlink()
print("passed")
