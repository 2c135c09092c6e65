"""Maps and grids of values of a folder, read by Isthmus and by mrcfile, gemmi and GridDataFormats.

    ISTHMUS_CORPUS_DIR      the folder; without it this test is skipped
    ISTHMUS_CORPUS_PYTHON   a Python with the other readers; else the one on the path

Each folder in it is a data set. Testing/Data/grid_corpus.txt lists those in the table of
Readers/Maps/Agreement.md, and explains what does not agree.

The comparison covers the numbers of nodes along x, y and z, all values bit by bit, the spacing, and where the first
value lies. A quantity agrees if one of the other readers finds the same. Cells that are not orthogonal are read
twice: with Keep Cell Axes for the values, and resampled for the place of the first value, which has to be a
node with this value.
"""

from vtkmodules.util.numpy_support import vtk_to_numpy

import corpus
import isthmus
from peer_tools import checksum

FOLDER = corpus.folder()
MAPS = tuple("mrc map ccp4 mrcs rec ali st".split())
QUANTITIES = ("size", "values", "spacing", "origin")


def image_of(path, resample=False):
    """What Isthmus reads, or its message."""
    is_map = corpus.extension(path) in MAPS
    reader = isthmus.vtkMRCMapReader() if is_map else isthmus.vtkOpenDXReader()
    reader.SetFileName(str(path))
    if is_map and not resample:
        reader.SetNonOrthogonalCellToKeepCellAxes()
    messages = corpus.errors_of_update(reader)
    image = reader.GetOutput()
    if messages or not image.GetNumberOfPoints():
        return messages or "no values and no message"
    return image


def values_of(image):
    array = image.GetPointData().GetArray("Density") or image.GetPointData().GetArray("Potential")
    size = image.GetDimensions()
    return vtk_to_numpy(array).reshape(size[2], size[1], size[0]).transpose(2, 1, 0)


def read(path, theirs):
    """What Isthmus finds, or its message."""
    image = image_of(path)
    if isinstance(image, str):
        return image
    values = values_of(image)
    found = {"size": list(values.shape), "values": checksum(values, "<f8"),
             "spacing": list(image.GetSpacing()), "origin": list(image.GetOrigin())}
    origin = theirs.get("gemmi", {}).get("origin") if isinstance(theirs.get("gemmi"), dict) else None
    angles = image.GetFieldData().GetArray("CellAngles")
    if origin and angles and any(abs(angles.GetValue(i) - 90) > 0.01 for i in range(3)):
        found["origin"] = node_near(image_of(path, resample=True), origin, values[0, 0, 0])
    return found


def node_near(image, point, value):
    """Where the node nearest to `point` lies; None: it has another value."""
    index = [round((p - o) / s) for p, o, s in zip(point, image.GetOrigin(), image.GetSpacing())]
    if values_of(image)[tuple(index)] != value:
        return None
    return [o + i * s for o, i, s in zip(image.GetOrigin(), index, image.GetSpacing())]


def same(quantity, theirs, ours):
    """Positions in single precision, as the files have them."""
    if quantity in ("size", "values"):
        return theirs == ours
    if ours is None:
        return False
    scale = max(1.0, *(abs(x) for x in theirs))
    return all(abs(a - b) <= 1e-6 * scale for a, b in zip(theirs, ours))


corpus.check_files(FOLDER, "grid_corpus.txt")
paths = corpus.files(FOLDER, MAPS + ("dx",))
others = corpus.peers("grid_peers.py", paths)
table = corpus.Table(FOLDER, corpus.explanations("grid_corpus.txt"), QUANTITIES)
for path in paths:
    theirs = others.get(str(path), {})
    corpus.add(table, path, read(path, theirs), theirs, QUANTITIES, same)
table.finish()
