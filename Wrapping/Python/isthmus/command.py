"""The command `isthmus` of the terminal: maps, molecules and surfaces to files, tables and pictures."""
import argparse
import collections
import csv
import json
import os
import sys
import textwrap
import time
import warnings

DONE, FAILED, USAGE, INTERRUPTED = 0, 1, 2, 130
EXIT_CODES = """exit codes:
  0    done
  1    the file cannot be read, or there is nothing to find in it; the message says why
  2    the command line is wrong
  130  interrupted by Ctrl-C"""
MAPS = "a density map (.mrc .map .ccp4, also .gz)"
MOLECULES = "a molecule (.pdb .cif .pqr .gro .mol2 ..., also .gz)"


# ---------------------------------------------------------------------------- progress and messages

class Bar:
    """A line on the terminal that shows the progress; nothing without a terminal."""

    def __init__(self, quiet):
        self.shown = not quiet and sys.stderr.isatty()
        self.start, self.last = time.monotonic(), 0.0

    def __call__(self, fraction, text):
        now = time.monotonic()
        if not self.shown or now - self.start < 0.5 or now - self.last < 0.1:
            return
        self.last = now
        filled = int(30 * min(max(fraction, 0.0), 1.0))
        sys.stderr.write(f"\r[{'#' * filled}{'.' * (30 - filled)}] {100 * fraction:3.0f} %  {text[:40]:40}")
        sys.stderr.flush()

    def clear(self):
        if self.shown and self.last:
            sys.stderr.write("\r" + " " * 84 + "\r")


def _warn(message, *_, **__):
    sys.stderr.write(f"isthmus: warning: {message}\n")


# ---------------------------------------------------------------------------- files

def rows_of(attributes, count):
    """Dictionaries of the arrays of one number or word for each element; nan becomes None."""
    columns = []
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(index)
        if array.GetNumberOfComponents() == 1 and array.GetNumberOfTuples() == count and array.GetName():
            columns.append((array.GetName(), array))
    rows = [{name: array.GetValue(i) for name, array in columns} for i in range(count)]
    return [{name: None if value != value else value for name, value in row.items()} for row in rows]


def write_table(rows, path):
    """A table as .json, or as .csv; - is standard output, in CSV."""
    if path.lower().endswith(".json"):
        with open(path, "w", encoding="utf-8") as file:
            json.dump(rows, file, indent=1)
            file.write("\n")
        return
    names = list(dict.fromkeys(name for row in rows for name in row))
    file = sys.stdout if path == "-" else open(path, "w", encoding="utf-8", newline="")
    try:
        writer = csv.DictWriter(file, names, restval="")
        writer.writeheader()
        writer.writerows(rows)
    finally:
        if file is not sys.stdout:
            file.close()


WRITERS = {".vtp": ("vtkIOXML", "vtkXMLPolyDataWriter"), ".vti": ("vtkIOXML", "vtkXMLImageDataWriter"),
           ".vtu": ("vtkIOXML", "vtkXMLUnstructuredGridWriter"), ".stl": ("vtkIOGeometry", "vtkSTLWriter"),
           ".ply": ("vtkIOPLY", "vtkPLYWriter"), ".obj": ("vtkIOGeometry", "vtkOBJWriter")}
KINDS = {".vti": "vtkImageData", ".vtu": "vtkUnstructuredGrid"}


def write_data(data, path):
    import importlib
    from . import functions
    ending = os.path.splitext(path)[1].lower()
    if ending == ".csv" or ending == ".json":
        return write_table(rows_of(data.GetCellData(), data.GetNumberOfCells()), path)
    if ending == ".off":
        return functions.function("off_surface_writer")(data, path)
    if ending == ".dx":
        return functions.function("open_dx_writer")(data, path)
    if ending not in WRITERS:
        raise ValueError(f"{path}: no writer for {ending or 'a name without an ending'}; take one of "
                         f"{' '.join(WRITERS)} .off .dx .csv .json.")
    if not data.IsA(KINDS.get(ending, "vtkPolyData")):
        raise ValueError(f"{path}: {ending} cannot hold this result, a {data.GetClassName()}.")
    module, name = WRITERS[ending]
    writer = getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
    writer.SetFileName(path)
    writer.SetInputDataObject(data)
    functions.run(writer, "isthmus", writer.Write)
    if not os.path.exists(path):
        raise ValueError(f"{path} could not be written: does the folder exist, and may you write there?")
    return None


# ---------------------------------------------------------------------------- pictures

NO_PICTURE = ("no picture can be drawn here: VTK found no OpenGL. Install it (Debian and Ubuntu: apt install libegl1 "
              "libgl1-mesa-dri libxrender1), or leave --picture out; the other results do not need it.")
NO_DISPLAY = ("no picture can be drawn here: there is no display, and this VTK draws to X11 only. Run it with xvfb-run, or "
              "leave --picture out; the other results do not need it.")
VERMILION, BLUE, ORANGE, GREY = (0.835, 0.369, 0.0), (0.0, 0.447, 0.698), (0.902, 0.624, 0.0), (0.8, 0.8, 0.8)


def _rendering():
    """VTK's rendering classes with OpenGL; ValueError without its libraries."""
    try:
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, before any rendering object is created
        from vtkmodules import vtkRenderingCore
    except ImportError as error:
        raise ValueError(f"{NO_PICTURE} ({error})") from None
    return vtkRenderingCore


def _actor(data, colour=GREY, opacity=1.0, scalars=None, limits=None, tube=0.0):
    core = _rendering()
    mapper, actor = core.vtkPolyDataMapper(), core.vtkActor()
    mapper.SetInputDataObject(data)
    if tube:
        from vtkmodules.vtkFiltersCore import vtkTubeFilter
        tubes = vtkTubeFilter()
        tubes.SetInputDataObject(data)
        tubes.SetRadius(tube)
        tubes.SetNumberOfSides(12)
        mapper.SetInputConnection(tubes.GetOutputPort())
    mapper.ScalarVisibilityOff()
    if scalars:
        association, name, colours = scalars
        mapper.ScalarVisibilityOn()
        getattr(mapper, f"SetScalarModeToUse{association}FieldData")()
        mapper.SelectColorArray(name)
        mapper.SetLookupTable(colours)
        mapper.SetUseLookupTableScalarRange(True)
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def _lookup(colours, low, high, diverging=False):
    function = _rendering().vtkColorTransferFunction()
    if diverging:
        function.SetColorSpaceToDiverging()
    for index, colour in enumerate(colours):
        function.AddRGBPoint(low + (high - low) * index / max(len(colours) - 1, 1), *colour)
    return function


def draw(actors, path, size=1200):
    """A picture of VTK's actors, without a window."""
    if os.path.splitext(path)[1].lower() != ".png":
        raise ValueError(f"{path}: pictures are .png files.")
    from vtkmodules.vtkCommonCore import vtkLogger
    from vtkmodules.vtkIOImage import vtkPNGWriter
    core = _rendering()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_ERROR)  # without a display, VTK warns but still draws
    renderer, window, image, writer = (core.vtkRenderer(), core.vtkRenderWindow(), core.vtkWindowToImageFilter(),
                                       vtkPNGWriter())
    if window.IsA("vtkXOpenGLRenderWindow") and not os.environ.get("DISPLAY"):
        raise ValueError(NO_DISPLAY)  # VTK would end the program; from 9.4 on it has a window without X11 for this
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(20)
    renderer.GetActiveCamera().Elevation(25)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()
    window.Render()
    if not window.SupportsOpenGL():
        raise ValueError(NO_PICTURE)
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer.SetFileName(path)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    if not os.path.exists(path):
        raise ValueError(f"{path} could not be written: does the folder exist, and may you write there?")


def _picture_of_loops(surface, loops, path):
    kinds = _lookup((VERMILION, BLUE, ORANGE), 0, 2)
    draw([_actor(surface, opacity=0.35),
          _actor(loops, tube=surface.GetLength() / 150, scalars=("Cell", "Kind", kinds))], path)


def _picture_of_ranks(surface, features, name, path):
    ranks = _lookup((VERMILION, BLUE, (0.0, 0.62, 0.451), ORANGE, (0.8, 0.475, 0.655), GREY), 1, 6)
    association = "Cell" if features.GetCellData().HasArray(name) else "Point"
    draw([_actor(surface, opacity=0.25), _actor(features, scalars=(association, name, ranks))], path)


def _picture_of_scalars(surface, name, limit, path):
    colours = _lookup(((0.23, 0.30, 0.75), (0.87, 0.87, 0.87), (0.71, 0.02, 0.15)), -limit, limit, True)
    draw([_actor(surface, scalars=("Point", name, colours))], path)


# ---------------------------------------------------------------------------- the commands
# Each returns a Result: the printed text, the rows of the table, the output of -o, and a function that draws.

Result = collections.namedtuple("Result", "summary rows shape picture")


def _field(data, name):
    array = data.GetFieldData().GetArray(name)
    return array.GetValue(0) if array is not None and array.GetNumberOfValues() else None


def _as_surface(data):
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
    if data.IsA("vtkPolyData"):
        return data
    outside = vtkDataSetSurfaceFilter()
    outside.SetInputDataObject(data)
    outside.Update()
    return outside.GetOutput()


def _table_rows(table):
    return rows_of(table.GetRowData(), table.GetNumberOfRows())


def surface(arguments, isthmus):
    made = isthmus.map_to_surface(isthmus.read(arguments.file), arguments.level)
    summary = {"level": _field(made, "Level"), "points": made.GetNumberOfPoints(),
               "triangles": made.GetNumberOfCells()}
    return Result(summary, _table_rows(isthmus.surface_measures(made).table), made,
                  lambda path: draw([_actor(made, (0.337, 0.706, 0.914))], path))


def curvature(arguments, isthmus):
    made = isthmus.map_to_curvature(isthmus.read(arguments.file), arguments.level).curvature
    return Result({"level": _field(made, "Level"), "points": made.GetNumberOfPoints()},
                  rows_of(made.GetPointData(), made.GetNumberOfPoints()), made,
                  lambda path: _picture_of_scalars(made, "MeanCurvature", _limit(made, "MeanCurvature"), path))


def _limit(data, name):
    values = data.GetPointData().GetArray(name)
    sizes = sorted(abs(values.GetValue(i)) for i in range(values.GetNumberOfValues())
                   if values.GetValue(i) == values.GetValue(i))
    return (sizes[int(0.95 * (len(sizes) - 1))] if sizes else 0.0) or 1.0


def loops(arguments, isthmus):
    data = isthmus.read(arguments.file)
    if data.IsA("vtkPolyData") and data.GetNumberOfPolys():
        shape, found = data, isthmus.surface_to_loops(data)
    else:
        found = isthmus.map_to_loops(data, arguments.level)
        shape = found.surface
    rows = rows_of(found.loops.GetCellData(), found.loops.GetNumberOfCells())
    count = {word: sum(row.get("Kind") == kind for row in rows)
             for kind, word in enumerate(("handles", "tunnels", "additional"))}
    return Result({"level": _field(shape, "Level"), "loops": len(rows), **count}, rows, found.loops,
                  lambda path: _picture_of_loops(shape, found.loops, path))


def pockets(arguments, isthmus):
    atoms = isthmus.read(arguments.file)
    found = isthmus.protein_to_pockets(atoms)
    rows = _table_rows(found.ranking)
    as_volume = (arguments.output or "").endswith(".vtu")
    return Result({"pockets": len(rows)}, rows, found.pockets if as_volume else _as_surface(found.pockets),
                  lambda path: _picture_of_ranks(isthmus.protein_to_surface(atoms).surface, _as_surface(found.pockets),
                                                 "PocketId", path))


def pores(arguments, isthmus):
    atoms = isthmus.read(arguments.file)
    found = isthmus.protein_to_pores(atoms)
    rows = _table_rows(found.pores)
    return Result({"pores": len(rows)}, rows, found.tubes, lambda path: draw(
        [_actor(isthmus.protein_to_surface(atoms).surface, opacity=0.25), _actor(found.tubes, VERMILION)], path))


def potential(arguments, isthmus):
    found = isthmus.protein_to_potential(isthmus.read(arguments.file), arguments.potential)
    rows = _table_rows(found.sites)
    on_grid = os.path.splitext(arguments.output or "")[1].lower() in (".vti", ".dx")
    return Result({"sites": len(rows)}, rows, found.potential if on_grid else found.surface,
                  lambda path: _picture_of_scalars(found.surface, "Potential", 5.0, path))


COMMANDS = {
    "surface": (surface, MAPS, "the closed surface of a density map",
                "Finds the closed surface of a density map, without the dust of noise around it. The level is the one "
                "that the depositors recommend (emd-NNNN.xml beside the map), or one that separates the molecule from "
                "its surroundings. Table: area and volume of each part, in angstrom."),
    "curvature": (curvature, MAPS, "where the surface of a map is bulging, hollow or saddle-shaped",
                  "Computes the curvature of the map at its surface: bulges are positive, hollows negative. Table: a row "
                  "for each point of the surface."),
    "loops": (loops, f"{MAPS}, or a closed surface (.stl .ply .off .vtp)",
              "rings where the shape narrows: handles, tunnels and bottlenecks",
              "Finds each place where the inside or the outside of the shape is narrow, with a ring around it. Table: a "
              "row for each ring with its kind, its radius (angstrom: of the ball that gets stuck there) and its "
              "persistence (angstrom: how much wider the space behind it is)."),
    "pockets": (pockets, MOLECULES, "pockets of a protein, the likeliest binding site first",
                "Finds the pockets of a molecule, ranked. Water and ligands are excluded if the file identifies them. Table: a row for each site of the size of a ligand with its probability, its volume (cubic "
                "angstrom) and its residues."),
    "pores": (pores, MOLECULES, "channels that run through a protein",
              "Finds the channels that run through a molecule. Table: a row for each with its length and the radius of "
              "its bottleneck (angstrom)."),
    "potential": (potential, MOLECULES, "electrostatic potential of a protein, and likely binding sites",
                  "Solves the Poisson-Boltzmann equation in 0.15 mol/l of salt. Charges are those of a .pqr file, or of a "
                  "force field by the program pdb2pqr, where it is installed. -o FILE.dx or .vti writes the potential "
                  "(kT/e) on its grid, .vtp the surface. Table: a row for each binding site."),
}
EXAMPLES = """examples:
  isthmus loops map.mrc -o loops.vtp --picture loops.png
  isthmus pockets 1abc.cif --table pockets.csv
  isthmus surface emd_5043.map.gz --level 2.4 -o surface.stl

`isthmus COMMAND --help` describes each."""


def parser():
    from . import __version__
    made = argparse.ArgumentParser(
        prog="isthmus", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Shapes of density maps and proteins: surfaces, the rings where they narrow, pockets, pores, "
                    "potentials.", epilog=f"{EXAMPLES}\n\n{EXIT_CODES}")
    made.add_argument("--version", action="version", version=f"isthmus {__version__}")
    commands = made.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name, (_, what, short, text) in COMMANDS.items():
        command = commands.add_parser(name, help=short, description=textwrap.fill(text, 80), epilog=EXIT_CODES,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
        command.add_argument("file", help=what)
        command.add_argument("-o", "--output", metavar="FILE",
                             help="write the shape: .vtp (all numbers), .stl, .ply, .obj, .off for other programs")
        command.add_argument("--table", metavar="FILE", help="write the table: .csv or .json; - prints it as CSV")
        command.add_argument("--picture", metavar="FILE.png", help="draw a picture")
        command.add_argument("--json", action="store_true", help="print summary and table as JSON")
        command.add_argument("--quiet", action="store_true", help="print no summary and no progress")
        if "map" in what:
            command.add_argument("--level", type=float, metavar="NUMBER",
                                 help="contour level of the map; automatic where not given")
        if name == "potential":
            command.add_argument("--potential", metavar="FILE.dx", help="use this potential instead of computing one")
    return made


def report(parsed, made):
    """Writes and prints the output requested on the command line."""
    if parsed.output:
        write_data(made.shape, parsed.output)
    if parsed.table:
        write_table(made.rows, parsed.table)
    if parsed.json:
        print(json.dumps({"file": parsed.file, **made.summary, "rows": made.rows}, indent=1))
    elif not parsed.quiet and parsed.table != "-":
        numbers = ", ".join(f"{name} {value:g}" if isinstance(value, float) else f"{name} {value}"
                            for name, value in made.summary.items() if value is not None)
        print(f"{parsed.file}: {numbers}")
    sys.stdout.flush()


def main(arguments=None):
    """Runs the command line; returns the exit code."""
    parsed = parser().parse_args(arguments)
    import isthmus
    bar = Bar(parsed.quiet)
    warnings.showwarning = lambda message, *_, **__: (bar.clear(), _warn(message))
    warnings.simplefilter("ignore")
    warnings.simplefilter("always", isthmus.IsthmusWarning)
    try:
        with isthmus.progress(bar):
            made = COMMANDS[parsed.command][0](parsed, isthmus)
            bar.clear()
            report(parsed, made)
            # Last, since a driver of OpenGL may crash the program.
            if parsed.picture:
                made.picture(parsed.picture)
        return DONE
    except KeyboardInterrupt:
        bar.clear()
        sys.stderr.write("isthmus: interrupted.\n")
        return INTERRUPTED
    except (ValueError, TypeError, OSError, MemoryError) as error:
        bar.clear()
        text = f"{error.filename}: {error.strerror}" if isinstance(error, OSError) and error.filename else str(error)
        sys.stderr.write(f"isthmus: {text or type(error).__name__}\n")
        return FAILED


if __name__ == "__main__":
    sys.exit(main())
