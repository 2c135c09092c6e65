"""Recreates the thesis' pictures of meshes from the shared data: figures 4.4 to 4.7, 4.13, and 4.18 to 4.22.

Usage: pvpython mesh_figures.py [FOLDER]. FOLDER: where the pictures go (the repository's are in
Examples/gallery); default: a temporary folder. Prints the path of each.
Each column shows a mesh with its number of cells and range of angles and, in some figures, a histogram of these
angles: corner angles for triangles, dihedral angles for tetrahedra.
"""

import subprocess
import sys
from pathlib import Path

from paraview import servermanager, simple

from gallery import data_folder
from output_folder import output_folder

MAPS = (("emd_5043.map", "EMD-5043"), ("emd_5170.map", "EMD-5170"), ("emd_1832.map", "EMD-1832"),
        ("1tyq_10.mrc", "Arp2/3, simulated"), ("clean70SRibosome_vol_65p.mrc", "Ribosome"),
        ("1oel_10.mrc", "GroEL, simulated"))
COLOUR = [0.62, 0.72, 0.86]


def white(view):
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0


def caption(name, report):
    fields = servermanager.Fetch(report).GetFieldData()
    measures = fields.GetArray("QualityMeasures")
    cells = report.GetDataInformation().GetNumberOfCells()
    return f"{name}\n{cells:,} cells, {measures.GetValue(0):.1f} to {measures.GetValue(1):.1f} degrees"


def words_view(view, name, report, size):
    """The caption in its own view, since it could not be read over a mesh that fills the view."""
    white(view)
    words = simple.Show(simple.Text(Text=caption(name, report)), view)
    words.Color = [0.0, 0.0, 0.0]
    words.FontSize = size
    words.WindowLocation = "Lower Left Corner"


def mesh_view(view, mesh, direction, zoom, camera):
    """Shows the mesh with its edges, seen from direction or with the given camera."""
    white(view)
    display = simple.Show(mesh, view)
    display.Representation = "Surface With Edges"
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = COLOUR
    display.EdgeColor = [0.15, 0.15, 0.25]
    if camera:
        view.CameraPosition, view.CameraFocalPoint = camera.CameraPosition, camera.CameraFocalPoint
        view.CameraViewUp, view.CameraViewAngle = camera.CameraViewUp, camera.CameraViewAngle
        return
    simple.ResetCamera(view)
    view.CameraPosition = [f + 300.0 * d for f, d in zip(view.CameraFocalPoint, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0]
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)


def bars(view, report):
    table = simple.Show(simple.OutputPort(report, 1), view)
    table.XArrayName = "Angle"
    table.UseIndexForXAxis = 0
    table.SeriesVisibility = ["Fraction"]
    view.ShowLegend = 0
    view.BottomAxisTitle = "angle (degrees)"
    view.LeftAxisTitle = "share"
    view.BottomAxisUseCustomRange = 1
    view.BottomAxisRangeMinimum, view.BottomAxisRangeMaximum = 0.0, 180.0


def split(layout, cell, parts, into):
    """Divides a cell of a layout into equal parts; into: the method that splits it."""
    cells = []
    while parts > 1:
        first = into(cell, 1.0 / parts)
        cells.append(first)
        cell, parts = first + 1, parts - 1
    return cells + [cell]


def figure(picture, columns, direction, zoom=1.3, size=(1200, 620), histograms=True, same=True):
    """`columns`: (name, mesh to show, mesh to report on)."""
    layout = simple.CreateLayout(picture.stem)
    camera = None
    for cell, (name, shown, mesh) in zip(split(layout, 0, len(columns), layout.SplitHorizontal), columns):
        if histograms:
            cell = layout.SplitVertical(cell, 0.68)
        below = cell + 1
        report = simple.MeshQualityReport(Input=mesh)
        report.UpdatePipeline()
        words = simple.CreateView("RenderView")
        cell = layout.SplitVertical(cell, 0.14)
        simple.AssignViewToLayout(words, layout, cell)
        words_view(words, name, report, 14 if histograms else 10)
        view = simple.CreateView("RenderView")
        simple.AssignViewToLayout(view, layout, cell + 1)
        mesh_view(view, shown, direction, zoom, camera if same else None)
        camera = camera or view
        if histograms:
            chart = simple.CreateView("XYBarChartView")
            simple.AssignViewToLayout(chart, layout, below)
            bars(chart, report)
    simple.SaveScreenshot(str(picture), layout, ImageResolution=list(size))
    subprocess.run(["convert", str(picture), "-colors", "64", str(picture)], check=False)
    print(picture)


def chosen_level(volume):
    """The level that Map Surface uses: the recommended one, or else one estimated from the values."""
    surface = servermanager.Fetch(simple.MapSurface(Input=volume))
    return surface.GetFieldData().GetArray("Level").GetValue(0)


def marching_cubes(volume, level):
    contour = simple.Contour(Input=volume, ContourBy=["POINTS", "Density"], Isosurfaces=[level])
    return simple.Triangulate(Input=contour)


def surfaces(volume, level, **criteria):
    cubes = marching_cubes(volume, level)
    return [(name, mesh, mesh) for name, mesh in (
        ("Marching cubes", cubes),
        ("Delaunay Isosurface", simple.DelaunayIsosurface(Input=volume, Level=level, **criteria)),
        ("Marching cubes, remeshed", simple.SurfaceRemesh(Input=cubes)))]


def tetrahedra(volume, level, **criteria):
    surface = simple.DelaunayIsosurface(Input=volume, Level=level, **criteria)
    meshes = (("TetGen", simple.TetrahedralMesher(Input=surface, Library="TetGen", RadiusEdgeRatio=1.4)),
              ("CGAL", simple.TetrahedralMesher(Input=surface, Library="CGAL")),
              ("Isosurface Stuffing", simple.IsosurfaceStuffing(Input=volume, Level=level)))
    columns = []
    for name, mesh in meshes:
        mesh.UpdatePipeline()
        columns.append((name, half(mesh), mesh))
    return columns


def half(mesh):
    """The uncut cells on one side of the middle."""
    bounds = mesh.GetDataInformation().GetBounds()
    clip = simple.Clip(Input=mesh, ClipType="Plane", Crinkleclip=1)
    clip.ClipType.Origin = [0.5 * (bounds[2 * a] + bounds[2 * a + 1]) for a in range(3)]
    clip.ClipType.Normal = [0.0, 0.0, 1.0]
    return clip


def main(folder):
    data = data_folder()
    maps = [simple.OpenDataFile(str(data / "maps" / file)) for file, _ in MAPS]

    figure(folder / "mesh_map.png", surfaces(maps[2], chosen_level(maps[2])), (0.0, 0.0, 1.0))
    figure(folder / "mesh_map_tetrahedra.png", tetrahedra(maps[2], chosen_level(maps[2])),
           (0.3, 0.2, 1.0))
    collection = []
    for source, (_, name) in zip(maps, MAPS):
        mesh = simple.DelaunayIsosurface(Input=source, Level=chosen_level(source))
        collection.append((name, mesh, mesh))
    for number, part in enumerate((collection[:3], collection[3:]), 1):
        figure(folder / f"mesh_collection{number}.png", part, (0.2, -0.4, 1.0), 1.1, (1200, 460), False,
               False)

    atoms = simple.OpenDataFile(str(data / "molecules/1hew/1hew.pqr"))
    protein = simple.MolecularDensity(Input=atoms, Spacing=1.0)
    level = chosen_level(protein)
    columns = surfaces(protein, level)
    figure(folder / "mesh_protein.png", columns, (0.0, 0.0, 1.0))
    figure(folder / "mesh_protein_close.png", columns, (0.0, 0.0, 1.0), 4.0, (900, 320), False)
    figure(folder / "mesh_protein_tetrahedra.png", tetrahedra(protein, level), (0.2, 0.1, 1.0))


if __name__ == "__main__":
    if {"-h", "--help"} & set(sys.argv[1:]):
        print(__doc__)
        sys.exit()
    main(output_folder(sys.argv[1] if len(sys.argv) > 1 else None))
