"""The functions of isthmus: examples of all docstrings, exceptions in place of texts on stderr, no copies, keywords.

Runs by pvpython, and by the Python of a wheel (Testing/Builds/wheel.sh), there with and without PyVista."""
import base64
import collections
import contextlib
import doctest
import inspect
import io
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import types
import warnings

import numpy

import isthmus
from isthmus import data_pipelines, functions, notebooks, other_libraries, samples


def expect(kind, words, function, *arguments, **properties):
    """An exception of that kind with these words, and nothing on stderr."""
    with tempfile.TemporaryFile() as caught:
        kept = os.dup(2)
        os.dup2(caught.fileno(), 2)
        try:
            function(*arguments, **properties)
            message = None
        except Exception as error:  # the kind is compared below
            message, found = str(error), type(error)
        finally:
            sys.stderr.flush()
            os.dup2(kept, 2)
            os.close(kept)
        caught.seek(0)
        said = caught.read().decode()
    assert message is not None, f"{function.__name__} raised nothing"
    assert found is kind, f"{function.__name__} raised {found.__name__}: {message}"
    assert words in message, f"{function.__name__}: {words!r} is not in {message!r}"
    assert not said, f"{function.__name__} wrote on stderr: {said!r}"


def check_examples():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", isthmus.IsthmusWarning)
        runner = doctest.DocTestRunner(verbose=False)
        finder = doctest.DocTestFinder()
        count = 0
        for name in [*functions.table()["functions"], "pockets"]:
            function = getattr(isthmus, name)
            parsed = doctest.DocTestParser().get_doctest(function.__doc__, {}, name, None, 0)
            assert len(parsed.examples) > 1, f"{name} has no example"
            runner.run(parsed, out=sys.stdout.write)
            count += 1
        for module in (data_pipelines, samples, functions):
            for parsed in finder.find(module):
                runner.run(parsed, out=sys.stdout.write)
        names = set(functions.table()["pipelines"]) - {"read"}
        assert names == set(data_pipelines.NAMES), names ^ set(data_pipelines.NAMES)
    assert not runner.failures and count > 55, f"{runner.failures} examples fail"


def check_help():
    manual = isthmus.choking_loops.__doc__
    for words in ("Parameters\n", "Returns\n", "Raises\n", "Examples\n", "minimum_persistence : float, default 5.0",
                  "'inside', 'outside', 'both'", "choke_points", "vtkChokingLoops"):
        assert words in manual, words
    parameters = inspect.signature(isthmus.choking_loops).parameters
    assert parameters["minimum_persistence"].default == 5.0 and list(parameters)[0] == "input"
    listed = dict(inspect.getmembers(isthmus))  # loads everything that is listed
    assert {"choking_loops", "map_to_loops", "vtkChokingLoops", "samples"} <= set(listed)
    assert isthmus.vtkIsthmusReadersMaps.vtkMRCMapReader is isthmus.vtkMRCMapReader


def check_exceptions():
    from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
    torus, volume, atoms = samples.torus(), samples.volume(), samples.atoms()
    expect(TypeError, "it is a vtkImageData", isthmus.choking_loops, volume)
    expect(TypeError, "it is a builtins.str", isthmus.choking_loops, "torus.off")
    expect(TypeError, "needs input", isthmus.choking_loops)
    expect(TypeError, "needs input", isthmus.choking_loops, None)
    expect(TypeError, "did you mean 'minimum_persistence'", isthmus.choking_loops, torus, min_persistence=3)
    expect(TypeError, "must be a number, not a str", isthmus.choking_loops, torus, minimum_persistence="5")
    expect(TypeError, "must be an integer", isthmus.choking_loops, torus, maximum_number_of_loops=1.5)
    expect(TypeError, "must be True or False", isthmus.choking_loops, torus, cap_holes="yes")
    expect(TypeError, "positional arguments", isthmus.choking_loops, torus, None, 5)
    expect(ValueError, "choose one of 'inside'", isthmus.choking_loops, torus, side="left")
    expect(ValueError, "is empty: it has no points", isthmus.choking_loops, vtkPolyData())
    expect(ValueError, "is empty: it has no points", isthmus.map_surface, vtkImageData())
    expect(ValueError, "is empty: it has no points", isthmus.pockets, vtkPolyData())
    expect(ValueError, "is empty: it has no cells", isthmus.choking_loops, points_without_cells())
    expect(ValueError, "it has 'Density'", isthmus.map_surface, volume, scalars="Mass")
    expect(ValueError, "no point array Radius", isthmus.pockets, torus)  # the filter's message
    expect(ValueError, "no array Radius", isthmus.protein_to_pockets, torus)
    expect(ValueError, "must have 3 numbers", isthmus.molecular_density, atoms, padding=(1, 2))
    expect(FileNotFoundError, "No such file", isthmus.mrc_map_reader, "/no/such/map.mrc")
    expect(ValueError, "not an MRC", isthmus.mrc_map_reader, __file__)
    expect(ValueError, "no reader for the ending", isthmus.read, __file__)
    # Files of which VTK's readers read garbage, or by which they crash.
    triangle = struct.pack("<12fH", 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0)
    faces_first = "".join(f"{line}\n" for line in (
        "ply", "format ascii 1.0", "element face 1", "property list uchar int vertex_indices", "element vertex 3",
        "property float x", "property float y", "property float z", "end_header", "3 0 1 2", "0 0 0", "1 0 0", "0 1 0"))
    strips = "".join(f"{line}\n" for line in (
        "ply", "format ascii 1.0", "element vertex 3", "property float x", "property float y", "property float z",
        "element tristrips 1", "property list int int vertex_indices", "end_header", "0 0 0", "1 0 0", "0 1 0", "3 0 1 2"))
    with tempfile.TemporaryDirectory() as folder:
        for name, content, word in (
                ("truncated.stl", bytes(80) + struct.pack("<I", 4) + 3 * triangle + triangle[:20], "truncated"),
                ("attributes.stl", bytes(80) + struct.pack("<I", 2) + 2 * (triangle + b"abcd"), "50 bytes"),
                ("faces_first.ply", faces_first.encode(), "vertices first"),
                ("strips.ply", strips.encode(), "no polygons"),
                ("points.obj", b"v 0 0 0\nv 1 0 0\n", "no polygons")):
            path = os.path.join(folder, name)
            with open(path, "wb") as file:
                file.write(content)
            expect(ValueError, word, isthmus.read, path)
        for number, start in enumerate((b"solid in spite of this", b"binary")):
            path = os.path.join(folder, f"good{number}.stl")
            with open(path, "wb") as file:
                file.write(start.ljust(80) + struct.pack("<I", 1) + triangle)
            assert isthmus.read(path).GetNumberOfCells() == 1
    expect(AttributeError, "no attribute", getattr, isthmus, "choking_loop")
    opened = vtkPolyData()
    opened.DeepCopy(torus)
    opened.BuildLinks()
    opened.DeleteCell(0)
    opened.RemoveDeletedCells()
    expect(ValueError, "", isthmus.choking_loops, opened)


def points_without_cells():
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    data = vtkPolyData()
    data.SetPoints(samples.torus().GetPoints())
    return data


def check_keywords():
    torus = samples.torus()
    found = isthmus.choking_loops(input=torus, side="Inside", minimum_persistence=numpy.float32(5),
                                  maximum_number_of_loops=numpy.int64(1))
    assert found._fields == ("loops", "membranes", "choke_points", "persistence_diagram")
    assert found.loops.GetNumberOfCells() == 1
    # Numbers of choices instead of their names.
    same = isthmus.choking_loops(torus, maximum_radius=100, side=0, shortening=2)
    assert same.loops.GetNumberOfCells() == 1
    # A level switches the automatic one off, unless that is asked for.
    volume = samples.volume()
    area = [isthmus.map_surface(volume, **given).GetNumberOfCells()
            for given in ({"level": 0.3}, {"level": 0.8}, {}, {"level": 0.3, "automatic_level": True})]
    assert area[0] != area[1] and area[2] == area[3] != area[0], area
    rows = isthmus.scalar_regions(isthmus.surface_curvature(torus), scalars="MeanCurvature",
                                  thresholds=[0.1, 0.2, 0.3]).regions
    assert rows.GetNumberOfRows() == 4


def check_numpy():
    points, triangles = triangles_of(samples.torus())
    assert isthmus.choking_loops((points, triangles)).loops.GetNumberOfCells() == 2
    expect(ValueError, "that do not exist", isthmus.choking_loops, (points[:5], triangles))
    expect(TypeError, "of shape (4, 4)", isthmus.map_surface, numpy.zeros((4, 4)))
    values = numpy.random.default_rng(1).normal(size=(6, 7, 8))
    values[2, 3, 4] = 9.0
    before = values.copy()
    smooth = isthmus.denoise_map(values)
    assert smooth.shape == values.shape and smooth.std() < values.std()
    assert numpy.unravel_index(smooth.argmax(), smooth.shape) == (2, 3, 4), "axes are in another order"
    assert (values == before).all(), "the input was changed"
    assert isthmus.molecular_density(numpy.array([[0.0, 0, 0, 1.7]]), spacing=0.5).GetNumberOfPoints() > 100


def numbers_of(data):
    return [data.GetPoint(i) for i in range(data.GetNumberOfPoints())]


def check_types_of_numpy():
    """Byte orders and types give the same numbers; masked values, ids that are not whole and other types are refused."""
    x, y, z = numpy.meshgrid(*[numpy.arange(10) - 4.5] * 3, indexing="ij")
    values = numpy.round(100 * numpy.exp(-(x * x + y * y + z * z) / 12))
    expected = numbers_of(isthmus.map_surface(values, level=40.5))
    assert len(expected) > 50
    for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g"):
        for order in "<>":
            array = values.astype(numpy.dtype(kind).newbyteorder(order))
            found = numbers_of(isthmus.map_surface(array, level=40.5))
            assert len(found) == len(expected) and numpy.allclose(found, expected, atol=1e-5), array.dtype
    inside = isthmus.map_surface(values > 40.5, level=0.5)
    assert inside.GetNumberOfCells() > 50 and inside.GetNumberOfPoints() == len(expected)

    points = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    triangles = numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    for kind in ("f2", "f4", "f8", "g", "i2", "u1"):
        for order in "<>":
            ids = triangles.astype(numpy.dtype(kind).newbyteorder(order))
            places = points.astype(numpy.dtype(kind).newbyteorder(order))
            measures = isthmus.surface_measures((places, ids))[0].GetFieldData()
            assert abs(measures.GetArray("Volume").GetValue(0) - 1 / 6) < 1e-12, ids.dtype
    atoms = numpy.array([[0, 0, 0, 1.5], [3, 0, 0, 1.5]])
    assert isthmus.molecular_density(atoms.astype(">f4")).GetDimensions() == \
        isthmus.molecular_density(atoms).GetDimensions()

    for array, function in ((values, isthmus.map_surface), (atoms, isthmus.molecular_density)):
        unmasked = numpy.ma.masked_array(array, mask=array > 1e9)
        assert numbers_of(function(unmasked)) == numbers_of(function(array))
        expect(ValueError, "masked values", function, numpy.ma.masked_array(array, mask=array > 2.5))
        expect(TypeError, f"{function.__name__}(): ", function, array.astype(complex))
        expect(TypeError, "astype(float)", function, array.astype(object))
    masked = numpy.ma.masked_array(points, mask=points > 0.5)
    expect(ValueError, "points is a numpy array with masked", isthmus.surface_measures, (masked, triangles))
    masked = numpy.ma.masked_array(triangles, mask=triangles == 3)
    expect(ValueError, "triangles is a numpy array with masked", isthmus.surface_measures, (points, masked))
    expect(ValueError, "not whole numbers", isthmus.surface_measures, (points, triangles + 0.4))
    expect(ValueError, "not whole numbers", isthmus.surface_measures, (points, numpy.where(triangles == 3, numpy.nan, triangles)))


def check_no_copies():
    """Points and cells go into the filter, and through it where it passes them on, by address."""
    torus = samples.torus()
    passed = isthmus.surface_curvature(torus)
    for part in ("GetPoints", "GetPolys"):
        assert getattr(passed, part)() is getattr(torus, part)(), f"{part} was copied"
    assert not torus.GetPointData().HasArray("MeanCurvature"), "the input was changed"
    module = functions.pyvista()
    if module is not None:
        assert isinstance(passed, module.PolyData), type(passed)
        address = torus.points.__array_interface__["data"][0]
        assert passed.points.__array_interface__["data"][0] == address
        assert passed.faces.shape == torus.faces.shape
        assert torus.isthmus.choking_loops().loops.n_cells == 2
        assert "choking_loops" in dir(torus.isthmus) and "map_surface" not in dir(torus.isthmus)
        assert isinstance(isthmus.pockets(samples.atoms()).ranking, module.Table)


def check_progress():
    seen = []
    with isthmus.progress(lambda fraction, text: seen.append(fraction)):
        isthmus.choking_loops(samples.torus())
    assert seen == sorted(seen) and seen and seen[-1] <= 1.0

    def interrupt(*_):
        raise KeyboardInterrupt
    try:
        with isthmus.progress(interrupt):
            isthmus.choking_loops(samples.torus())
    except KeyboardInterrupt:
        return
    raise AssertionError("an exception of the callback was lost")


class FakeBar:
    """The calls that tqdm's bars receive."""
    made = []

    def __init__(self, **given):
        self.given, self.n, self.closed = given, 0.0, False
        FakeBar.made.append(self)

    def update(self, more):
        self.n += more

    def close(self):
        self.closed = True


def check_bar():
    """A bar of tqdm after the given time, with someone to see it and no callback; none otherwise."""
    kept = {name: sys.modules.get(name) for name in ("tqdm", "tqdm.auto")}
    sys.modules["tqdm"] = sys.modules["tqdm.auto"] = types.ModuleType("tqdm.auto")
    sys.modules["tqdm.auto"].tqdm = FakeBar
    terminal, after = sys.stderr, notebooks.Bar.AFTER
    try:
        for seconds, seen, callback, bars in ((-1, True, False, 1), (-1, False, False, 0), (1000, True, False, 0), (-1, True, True, 0)):
            notebooks.Bar.AFTER, FakeBar.made = seconds, []
            sys.stderr = io.StringIO()
            sys.stderr.isatty = lambda seen=seen: seen
            with isthmus.progress(lambda *_: None) if callback else contextlib.nullcontext():
                isthmus.choking_loops(samples.torus())
            assert len(FakeBar.made) == bars, (seconds, seen, callback, len(FakeBar.made))
            for bar in FakeBar.made:
                assert bar.closed and 0 < bar.n <= 1 and bar.given["desc"] == "choking_loops", vars(bar)
    finally:
        sys.stderr, notebooks.Bar.AFTER = terminal, after
        for name, module in kept.items():
            sys.modules.pop(name)
            if module is not None:
                sys.modules[name] = module


def check_interrupt():
    """Ctrl-C ends a filter, not the program, and long before its end: in less than a third of the time of a whole run."""
    if not os.path.basename(sys.executable or "").startswith("python"):
        return
    code = """
import signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)
import isthmus, numpy
noise = numpy.random.default_rng(1).normal(size=(144, 144, 144))
seen = []
def tell(fraction, text):
    seen.append(time.perf_counter())
    if len(seen) == 1:
        print("runs", flush=True)
try:
    with isthmus.progress(tell):
        isthmus.denoise_map(noise)
finally:
    print(time.perf_counter() - seen[0], flush=True)
"""
    environment = {**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(isthmus.__file__))}

    def seconds(interrupt):
        # Not in the folder of a build, whose package would be the one imported.
        with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              env=environment, cwd=os.path.dirname(os.path.abspath(__file__))) as child:
            assert child.stdout.readline() == "runs\n"
            if interrupt:
                child.send_signal(signal.SIGINT)
            said, error = child.communicate(timeout=600)
        assert ("KeyboardInterrupt" in error) == interrupt, error
        return float(said)
    whole, interrupted = seconds(False), seconds(True)
    print(f"whole {whole:.2f} s, interrupted {interrupted:.2f} s")
    assert interrupted < whole / 3


def triangles_of(surface):
    points = numpy.array([surface.GetPoint(i) for i in range(surface.GetNumberOfPoints())])
    return points, numpy.array([[surface.GetCell(i).GetPointId(j) for j in range(3)]
                                for i in range(surface.GetNumberOfCells())])


def check_other_libraries():
    """Meshes of trimesh and meshio: the libraries' own where they are installed, and objects like theirs."""
    points, triangles = triangles_of(samples.torus())
    shades = numpy.arange(len(triangles))
    tetrahedra = numpy.array([[0, 1, 2, 3]])
    corners = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    like_trimesh = type("Trimesh", (), {"__module__": "trimesh.base"})()
    like_trimesh.vertices, like_trimesh.faces = points, triangles
    like_trimesh.vertex_attributes, like_trimesh.face_attributes = {"Height": points[:, 2]}, {"Shade": shades}
    block = collections.namedtuple("CellBlock", "type data")

    def like_meshio(places, cells, point_data, cell_data):
        made = type("Mesh", (), {"__module__": "meshio._mesh"})()
        made.points, made.point_data, made.cell_data = places, point_data, cell_data
        made.cells = [block(*entry) for entry in cells]
        return made
    makers, surfaces = [like_meshio], [like_trimesh]
    try:
        import trimesh
        surfaces.append(trimesh.Trimesh(points, triangles, process=False, vertex_attributes={"Height": points[:, 2]},
                                        face_attributes={"Shade": shades}))
        cloud = trimesh.PointCloud(points)
        assert isthmus.functions.take_input(cloud, {"name": "input", "types": ["vtkPointSet"]}, "f").GetNumberOfVerts() == len(points)
    except ImportError:
        pass
    try:
        import meshio
        makers.append(lambda *given: meshio.Mesh(given[0], list(given[1]), point_data=given[2], cell_data=given[3]))
    except ImportError:
        pass
    for maker in makers:
        half = len(triangles) // 2
        surfaces.append(maker(points, [("triangle", triangles[:half]), ("triangle", triangles[half:])],
                              {"Height": points[:, 2]}, {"Shade": [shades[:half], shades[half:]]}))
        mesh = other_libraries.data_of(maker(corners, [("tetra", tetrahedra), ("triangle", tetrahedra[:, :3])], {}, {}), "f")
        assert mesh.IsA("vtkUnstructuredGrid") and [mesh.GetCellType(i) for i in (0, 1)] == [10, 5]
        assert mesh.GetCell(0).IsA("vtkTetra") and [mesh.GetCell(0).GetPointId(i) for i in range(4)] == [0, 1, 2, 3]
        flat = other_libraries.data_of(maker(corners[:3, :2], [("triangle", tetrahedra[:, :3])], {}, {}), "f")
        assert flat.GetPoint(1) == (1, 0, 0)
        expect(ValueError, "cells of the type hexahedron27", isthmus.surface_measures,
               maker(numpy.zeros((27, 3)), [("hexahedron27", numpy.arange(27)[None])], {}, {}))
        expect(TypeError, "it is a vtkUnstructuredGrid", isthmus.choking_loops, maker(corners, [("tetra", tetrahedra)], {}, {}))
    expected = isthmus.surface_measures((points, triangles)).table.GetValueByName(0, "Volume").ToDouble()
    for surface in surfaces:
        measures = isthmus.surface_measures(surface)
        assert measures.table.GetValueByName(0, "Volume").ToDouble() == expected
        data = isthmus.surface_curvature(surface)
        for name, attributes, values in (("Height", data.GetPointData(), points[:, 2]), ("Shade", data.GetCellData(), shades)):
            array = attributes.GetArray(name)
            assert [array.GetTuple1(i) for i in range(array.GetNumberOfTuples())] == list(values), name
        assert isthmus.surface_to_loops(surface).loops.GetNumberOfCells() == 2
    expect(ValueError, "that do not exist", isthmus.surface_measures,
           like_meshio(points[:5], [("triangle", triangles)], {}, {}))


def check_html():
    """Results in notebooks: name and size of each output, the rows of the loops, a picture or the reason for none."""
    found = isthmus.choking_loops(samples.torus())
    said = found._repr_html_()
    for words in ("ChokingLoopsResult", "<code>persistence_diagram</code>", "2 cells", "<th>Radius</th>", "<th>KindName</th>"):
        assert words in said, said[:2000]
    assert said.count("<tr><td>") >= 2
    if "<img" in said:
        picture = base64.b64decode(re.search("base64,([^']+)'", said)[1])
        assert picture[:8] == b"\x89PNG\r\n\x1a\n" and len(picture) > 1000
    else:
        assert "no picture can be drawn here" in said, said[:2000]
    # The contents of arrays are shown as text, not as markup.
    from vtkmodules.vtkCommonCore import vtkStringArray
    from vtkmodules.vtkCommonDataModel import vtkTable
    table, words = vtkTable(), vtkStringArray()
    words.SetName("<i>Name")
    words.InsertNextValue("<script>")
    table.AddColumn(words)
    said = type(found)(None, None, None, table)._repr_html_()
    assert "<script>" not in said and "&lt;script&gt;" in said and "<i>Name" not in said


def check_import():
    """The package alone, in a fresh Python: nothing is loaded that takes long to load."""
    code = ("import sys, isthmus; "
            "print({'numpy', 'paraview', 'pyvista', 'vtkmodules.vtkCommonCore'} & {*sys.modules})")
    if os.path.basename(sys.executable or "").startswith("python"):
        environment = {**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(isthmus.__file__))}
        said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=environment)
        assert said.stdout == "set()\n", said.stdout


def check_without_paraview():
    try:
        import paraview  # noqa: F401
        return
    except ImportError:
        pass
    from isthmus import pipelines
    expect(ImportError, "isthmus.map_to_loops", pipelines.map_to_loops, None)


def main():
    checks = [check for name, check in globals().items() if name.startswith("check_")]
    for check in checks:
        check()
        print(check.__name__, flush=True)


if __name__ == "__main__":
    main()
