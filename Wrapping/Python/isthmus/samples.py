"""Small data without a file, for the examples of docstrings and for first tries. Lengths are in angstrom."""
import math

from . import functions


def _shown(data):
    module = functions.pyvista()
    return module.wrap(data) if module is not None and data.IsA("vtkDataSet") else data


def torus(ring=3.0, tube=1.0, around=48, across=24):
    """A closed surface of triangles with one handle and one tunnel.

    >>> from isthmus import samples
    >>> samples.torus().GetNumberOfCells()
    2304
    """
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, triangles = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for i in range(around):
        for j in range(across):
            u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
            distance = ring + tube * math.cos(v)
            points.InsertNextPoint(distance * math.cos(u), distance * math.sin(u), tube * math.sin(v))
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            for corners in ((a, b, c), (a, c, d)):
                triangles.InsertNextCell(3, corners)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return _shown(surface)


def volume(nodes=32, ring=8.0, tube=3.5):
    """A density map: a ring of high density, Density 1 at its middle, with nodes 1 angstrom apart.

    >>> from isthmus import samples
    >>> samples.volume().GetDimensions()
    (32, 32, 32)
    """
    from vtkmodules.vtkCommonCore import vtkDoubleArray
    from vtkmodules.vtkCommonDataModel import vtkImageData
    values = vtkDoubleArray()
    values.SetName("Density")
    middle = (nodes - 1) / 2
    for z in range(nodes):
        for y in range(nodes):
            for x in range(nodes):
                distance = math.hypot(math.hypot(x - middle, y - middle) - ring, z - middle)
                values.InsertNextValue(math.exp(-(distance / tube) ** 2))
    image = vtkImageData()
    image.SetDimensions(nodes, nodes, nodes)
    image.SetOrigin(-middle, -middle, -middle)
    image.GetPointData().SetScalars(values)
    return _shown(image)


def _molecule(places):
    """Atoms of carbon of alternating charge."""
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points, verts = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    arrays = [vtkDoubleArray(), vtkDoubleArray(), vtkIntArray()]
    for array, name in zip(arrays, ("Radius", "Charge", "Element")):
        array.SetName(name)
    for i, place in enumerate(places):
        verts.InsertNextCell(1, [points.InsertNextPoint(place)])
        for array, value in zip(arrays, (1.7, 0.1 if i % 2 else -0.1, 6)):
            array.InsertNextValue(value)
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetVerts(verts)
    for array in arrays:
        data.GetPointData().AddArray(array)
    return _shown(data)


def atoms(count=162, radius=8.0):
    """Atoms around a hollow with an opening, with Radius, Charge and Element.

    >>> from isthmus import samples
    >>> samples.atoms().GetPointData().HasArray("Radius")
    1
    """
    golden = math.pi * (3 - math.sqrt(5))
    places = []
    for i in range(count):
        height = 1 - 2 * (i + 0.5) / count
        if height <= 0.9:  # above is the opening
            across = math.sqrt(1 - height * height)
            places.append((radius * across * math.cos(golden * i), radius * across * math.sin(golden * i),
                           radius * height))
    return _molecule(places)


def channel(radius=5.5, length=24.0):
    """Atoms around an open channel along z, with Radius, Charge and Element.

    >>> from isthmus import samples
    >>> samples.channel().GetNumberOfPoints() > 100
    True
    """
    around, rings = 16, int(length / 2) + 1
    return _molecule([(radius * math.cos(2 * math.pi * (i + ring % 2 / 2) / around),
                       radius * math.sin(2 * math.pi * (i + ring % 2 / 2) / around), 2.0 * ring - length / 2)
                      for ring in range(rings) for i in range(around)])


def tetrahedra():
    """A mesh of two tetrahedra that share a face.

    >>> from isthmus import samples
    >>> samples.tetrahedra().GetNumberOfCells()
    2
    """
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_TETRA, vtkUnstructuredGrid
    points = vtkPoints()
    for point in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)):
        points.InsertNextPoint(point)
    mesh = vtkUnstructuredGrid()
    mesh.SetPoints(points)
    for corners in ((0, 1, 2, 3), (1, 4, 2, 3)):
        mesh.InsertNextCell(VTK_TETRA, 4, corners)
    return _shown(mesh)
