"""Every shared map against gemmi or mrcfile and numbers found by hand; opening maps in ParaView."""

import gzip
import os
import shutil
import struct
from pathlib import Path

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand

import isthmus
from mrc_reference import Reference
from shared_data import shared_data

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MRCMapReader"

# Grid, spacing and place of node 0 of the files that gemmi refuses or that are odd, by hand from a
# dump of their header words (struct, python): spacing CELLA / M, place ORIGIN or NSTART x spacing.
BY_HAND = {
    "1oel_10.mrc": ((116, 114, 69), (1.5, 1.5, 1.5), (-130.5, -84.0, -87.0)),
    # NSTART 3, 4, 5 on axes y, x, z and spacing 6 / 40; the second has ORIGIN, the third SKWTRN on
    # top of NSTART. The same places are in PyMOL's tests.
    "h2o-elf-nstart.ccp4": ((40, 40, 40), (0.15, 0.15, 0.15), (0.6, 0.45, 0.75)),
    "h2o-elf-nstart-origin.mrc": ((40, 40, 40), (0.15, 0.15, 0.15), (1.2, 3.4, 5.6)),
    "h2o-elf-nstart-skwtrn.ccp4": ((40, 40, 40), (0.15, 0.15, 0.15), (1.8, 3.85, 6.35)),
    "invalid_axes.mrc": ((8, 10, 8), (4.0, 4.0, 4.0), (55.0, 75.0, -44.0)),
    "mini.mrc": ((8, 10, 8), (4.0, 4.0, 4.0), (55.0, 75.0, -44.0)),
    "gorgon_groel_skeleton.mrc": ((80, 80, 80), (84.8 / 79,) * 3, (0.0, 0.0, 0.0)),
    "relion31.mrcs": ((256, 256, 5), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)),
    "smallStack.mrcs": ((64, 64, 4), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)),
    "de_movie_mode6.mrc": ((8, 4, 32), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)),
    "clean70SRibosome_vol_65p.mrc": ((65, 65, 65), (1.0, 1.0, 1.0), (0.0, 0.0, 0.0)),
}

# Words of the message that each file that is not a map must produce.
REFUSED = {
    "sfftk_empty1.map": "the file is empty (0 bytes)",
    "test_data_corrupt_header.map": "34280108 bytes expected (header 1024, extended header 0, "
                                    "301 x 401 x 71 voxels of mode 2), found 1108",
    "h2o-elf.cube": "not an MRC, CCP4 or EMDB map",
}

# Words of the repairs that must be told; all other files must need none.
REPAIRED = {
    "1oel_10.mrc": ["stamp (word 54) is 00 00 00 00", "(word 23) is 1065353216"],
    "clean70SRibosome_vol_65p.mrc": ["along x (word 11) is 0", "along y (word 12) is 0",
                                     "along z (word 13) is 0"],
    "de_movie_mode6.mrc": ["(word 11) is -80", "(word 12) is -40", "(word 13) is 0"],
    "gorgon_groel_skeleton.mrc": ["stamp (word 54) is 00 00 00 00", '"MAP " (word 53) is missing'],
    "h2o-elf-nstart.ccp4": ["stamp (word 54) is 4d 41 45 20"],
    "h2o-elf-nstart-origin.mrc": ["stamp (word 54) is 4d 41 45 20"],
    "h2o-elf-nstart-skwtrn.ccp4": ["stamp (word 54) is 4d 41 45 20"],
    "invalid_axes.mrc": ["stamp (word 54) is 00 00 00 00", "(words 17-19) is 10, 11, 12"],
    "mini.mrc": ["stamp (word 54) is 00 00 00 00"],
    "relion31.mrcs": ["stamp (word 54) is 00 00 00 00", '"MAP " (word 53) is missing'],
}

STACKS = {"smallStack.mrcs": 4, "hand.mrcs": 100, "relion31.mrcs": 5}
SINGLE_IMAGES = {"singleImage.mrc"}


def read(path):
    """The reader's image, its error and its warning."""
    said = {"ErrorEvent": "", "WarningEvent": ""}
    reader = isthmus.vtkMRCMapReader()
    reader.SetFileName(str(path))

    def listen(event):
        def keep(_, __, text):
            said[event] += text
        keep.CallDataType = "string0"
        reader.AddObserver(event, keep)
        return keep

    kept = [listen("ErrorEvent"), listen("WarningEvent")]
    # The pipeline prints a sentence of its own when a request fails.
    reader.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
    reader.Update()
    del kept
    return reader.GetOutput(), said["ErrorEvent"], said["WarningEvent"]


def texts(image, name):
    array = image.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def array(image, name):
    """Values by x, y, z."""
    values = vtk_to_numpy(image.GetPointData().GetArray(name))
    return values.reshape(image.GetDimensions()[::-1]).transpose(2, 1, 0)


def close(found, expected, tolerance=1e-4):
    return numpy.allclose(found, expected, rtol=1e-6, atol=tolerance, equal_nan=True)


def compare_statistics(name, found, expected):
    found, expected = found.astype(float), expected.astype(float)
    for statistic in (numpy.min, numpy.max, numpy.mean, numpy.std):
        a, b = statistic(found), statistic(expected)
        assert close(a, b, 1e-9 * max(1.0, abs(b))), (name, statistic.__name__, a, b)


def sample(dimensions, count=1000):
    """Indices of nodes, `count` of them, the same in every run."""
    generator = numpy.random.default_rng(5043)
    return numpy.stack([generator.integers(0, n, count) for n in dimensions], axis=1)


def compare_upright(name, image, reference):
    """A cell with right angles: every value, and the place of 1,000 of them in the world."""
    values = array(image, "Density")
    assert image.GetDimensions() == reference.values.shape, (name, image.GetDimensions())
    assert close(image.GetSpacing(), reference.spacing), (name, image.GetSpacing())
    assert numpy.array_equal(values.astype(float), reference.values.astype(float), equal_nan=True)
    compare_statistics(name, values, reference.values)
    origin = numpy.array(BY_HAND[name][2] if name in BY_HAND else reference.origin)
    ends = origin + reference.spacing * (numpy.array(values.shape) - 1)
    bounds = numpy.array(image.GetBounds()).reshape(3, 2)
    assert close(bounds[:, 0], origin) and close(bounds[:, 1], ends), (name, bounds, origin, ends)
    # gemmi wraps positions into the cell: no help where a map is larger (emd_1155: M is not N).
    in_cell = reference.grid is not None and name not in STACKS | BY_HAND.keys() \
        and numpy.all(numpy.array(values.shape) <= reference.sampling)
    for node in sample(values.shape):
        world = numpy.array(image.GetPoint(image.ComputePointId([int(n) for n in node])))
        u, v, w = (int(n) for n in numpy.rint((world - origin) / reference.spacing))
        assert values[tuple(node)] == reference.values[u, v, w], (name, node)
        if in_cell:
            start = [int(n) for n in reference.start]
            theirs = reference.grid.get_value(u + start[0], v + start[1], w + start[2])
            assert close(values[tuple(node)], theirs), (name, node, theirs)


def compare_oblique(name, image, reference):
    """A cell with other angles: the resampled values against gemmi's interpolation in the cell."""
    values, inside = array(image, "Density"), array(image, "InsideMap")
    last = numpy.array(reference.values.shape) - 1
    shift = reference.shift()
    corners = numpy.array([reference.node(*(last * c)) + shift
                           for c in numpy.ndindex(2, 2, 2)])
    bounds = numpy.array(image.GetBounds()).reshape(3, 2)
    spacing = numpy.array(image.GetSpacing())
    assert close(spacing, reference.spacing), (name, spacing)
    assert numpy.all(bounds[:, 0] <= corners.min(0) + 1e-3), (name, bounds, corners)
    assert numpy.all(bounds[:, 0] > corners.min(0) - spacing - 1e-3), (name, bounds, corners)
    assert numpy.all(bounds[:, 1] >= corners.max(0) - 1e-3), (name, bounds, corners)
    assert numpy.all(bounds[:, 1] < corners.max(0) + spacing + 1e-3), (name, bounds, corners)
    assert not values[inside == 0].any(), name

    nodes = numpy.argwhere(inside == 1)
    chosen = nodes[numpy.linspace(0, len(nodes) - 1, min(len(nodes), 4000)).astype(int)]
    limit = 0.501 if values.dtype.kind in "iu" else 1e-4 * numpy.ptp(reference.values)
    compared = 0
    for node in chosen:
        world = image.GetPoint(image.ComputePointId([int(n) for n in node]))
        theirs = reference.interpolated(numpy.array(world) - shift)
        if not numpy.isnan(theirs):
            compared += 1
            assert abs(values[tuple(node)] - theirs) <= limit, (name, node, theirs)
    assert compared >= min(1000, len(nodes) // 2), (name, compared, len(nodes))
    # Interpolated values stay among the map's.
    within = values[inside == 1].astype(float)
    assert reference.values.min() - limit <= within.min(), name
    assert within.max() <= reference.values.max() + limit, name


def check_map(path):
    name = path.name
    image, error, warning = read(path)
    if name in REFUSED:
        assert REFUSED[name] in error and str(path) in error, (name, error)
        assert image.GetNumberOfPoints() == 0, name
        taken = "header" in name or "empty" in name  # an empty file by its name
        assert isthmus.vtkMRCMapReader().CanReadFile(str(path)) == int(taken)
        return f"refused: {REFUSED[name]}"
    assert not error, (name, error)
    assert isthmus.vtkMRCMapReader().CanReadFile(str(path)) == 1, name
    repairs = texts(image, "Repairs")
    expected = REPAIRED.get(name, [])
    assert len(repairs) == len(expected), (name, repairs)
    for words, repair in zip(expected, repairs):
        assert words in repair and words in warning, (name, words, repair)
    stack = image.GetFieldData().GetArray("IsStack").GetValue(0)
    assert stack == (name in STACKS), name
    reference = Reference(path)
    if reference.orthogonal:
        compare_upright(name, image, reference)
    else:
        assert "resampled" in warning and "resampled" in texts(image, "Notes")[0], (name, warning)
        compare_oblique(name, image, reference)
    if name in BY_HAND:
        dimensions, spacing, origin = BY_HAND[name]
        assert image.GetDimensions() == dimensions and close(image.GetSpacing(), spacing), name
        assert close(image.GetOrigin(), origin), (name, image.GetOrigin())
    return f"{'right' if reference.orthogonal else 'resampled'} as {reference.by} reads it"


def check_all_maps():
    folder = shared_data("maps")
    files = sorted(path for path in folder.iterdir() if path.is_file())
    assert len(files) >= 45, len(files)
    for path in files:
        print(f"{path.name:34} {check_map(path)}")
    missing = (BY_HAND.keys() | REFUSED.keys() | REPAIRED.keys()) - {path.name for path in files}
    assert not missing, missing


def check_pieces():
    """What each of N ranks reads is what the whole has there."""
    for name in ("emd_5043.map", "3pqr.ccp4.gz", "pymol_web_map_bigendian.ccp4"):
        path = shared_data(f"maps/{name}")
        whole = array(read(path)[0], "Density")
        for ranks in (1, 2, 4):
            for rank in range(ranks):
                reader = isthmus.vtkMRCMapReader()
                reader.SetFileName(str(path))
                reader.AddObserver(vtkCommand.WarningEvent, lambda *_: None)
                reader.UpdatePiece(rank, ranks, 0)
                piece = reader.GetOutput()
                x0, x1, y0, y1, z0, z1 = piece.GetExtent()
                expected = whole[x0:x1 + 1, y0:y1 + 1, z0:z1 + 1]
                assert numpy.array_equal(array(piece, "Density"), expected), (name, ranks, rank)
                assert ranks == 1 or expected.size < whole.size


def opened(path):
    """What ParaView makes of a file of this name: the proxy's name and its data."""
    source = simple.OpenDataFile(str(path))
    assert source is not None, path
    source.UpdatePipeline()
    data = servermanager.Fetch(source)
    name = source.GetXMLName()
    simple.Delete(source)
    return name, data


def check_opening():
    """Every ending opens with ours, also those that ParaView's own readers claim."""
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir(parents=True)
    original = shared_data("maps/emd_1703.map").read_bytes()
    expected = read(shared_data("maps/emd_1703.map"))[0]
    for ending in ("mrc", "map", "ccp4", "mrcs", "rec", "ali", "st", "mrc.gz", "map.gz", "rec.gz",
                   "MAP.GZ", "st.gz"):
        path = OUTPUT / f"opened.{ending}"
        path.write_bytes(gzip.compress(original, 1) if ending.lower().endswith("gz") else original)
        name, data = opened(path)
        assert name == "DensityMapReader", (ending, name)
        assert data.GetDimensions() == expected.GetDimensions(), ending
        assert numpy.array_equal(array(data, "Density"), array(expected, "Density")), ending
    name, data = opened(shared_data("maps/EMD-3001.map.bz2"))
    assert name == "DensityMapReader" and data.GetPointData().GetArray("InsideMap"), name


def check_panel():
    """Properties reach the reader, also under the name of ParaView's reader, and in a series."""
    path = str(OUTPUT / "opened.mrc")
    source = simple.DensityMapReader(FileNames=[path], CropExtent=[5, 14, 0, -1, 2, 9],
                                 SampleRate=[1, 2, 1])
    source.UpdatePipeline()
    data = servermanager.Fetch(source)
    assert data.GetDimensions() == (10, 32, 8), data.GetDimensions()
    assert close(data.GetOrigin(), (30.0, 3.0, 12.0)), data.GetOrigin()
    old = simple.MRCSeriesReader(FileNames=[path])
    old.UpdatePipeline()
    assert servermanager.Fetch(old).GetPointData().GetArray("Density")

    second = OUTPUT / "second.mrc"
    content = bytearray((OUTPUT / "opened.mrc").read_bytes())
    content[1024:1028] = struct.pack("<f", 77.0)
    second.write_bytes(content)
    series = simple.DensityMapReader(FileNames=[path, str(second)])
    assert list(series.TimestepValues) == [0.0, 1.0], series.TimestepValues
    series.UpdatePipeline(1.0)
    assert array(servermanager.Fetch(series), "Density")[0, 0, 0] == 77.0


check_all_maps()
check_pieces()
check_opening()
check_panel()
