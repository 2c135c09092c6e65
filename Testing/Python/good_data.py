"""The filters of the plugin, found in its panels, and small sound inputs for each of their ports."""

import os
import xml.etree.ElementTree as Tree

import numpy
from paraview import servermanager
from paraview.simple import PVTrivialProducer
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_TETRA, vtkCellArray, vtkImageData, vtkMolecule, vtkPolyData, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkDelaunay3D, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource


def panels():
    folder = os.environ["ISTHMUS_PANELS_DIR"]
    for file in sorted(os.listdir(folder)):
        if file.endswith(".xml"):
            yield Tree.parse(os.path.join(folder, file)).getroot()


def ports_of_filters():
    """{proxy: [(input property, accepted types, is optional), ...]} of group 'filters'; a proxy with a
    base has the ports of that, some of them its own way."""
    found, bases = {}, {}
    for root in panels():
        for group in root.iter("ProxyGroup"):
            for proxy in group.iter("SourceProxy"):
                if group.get("name") != "filters":
                    continue
                bases[proxy.get("name")] = proxy.get("base_proxyname")
                found[proxy.get("name")] = [
                    (port.get("name"), [kind.get("value") for kind in port.find("DataTypeDomain").findall("DataType")],
                     port.find("Hints/Optional") is not None)
                    for port in proxy.findall("InputProperty")]
    for name, base in bases.items():
        own = {port[0]: port for port in found[name]}
        if base:
            found[name] = [own.get(port[0], port) for port in found[base]]
    return found


def add(data, name, values, components=1):
    array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
    array.SetName(name)
    (data.AddColumn if hasattr(data, "AddColumn") else data.AddArray)(array)


def surface():
    """A closed sphere of 5 angstrom with what filters of sites and atoms ask for on it."""
    source = vtkSphereSource()
    source.SetRadius(5.0)
    source.SetThetaResolution(10)
    source.SetPhiResolution(8)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.Update()
    result = vtkPolyData()
    result.ShallowCopy(clean.GetOutput())
    z = vtk_to_numpy(result.GetPoints().GetData())[:, 2].astype(float)
    data = result.GetPointData()
    data.Initialize()
    for name, values in (("Radius", 0 * z + 1.5), ("MaximumCurvature", 0 * z + 0.2),
                         ("MinimumCurvature", 0 * z + 0.1), ("Potential", z),
                         ("PolarizedCurvature", 0.2 * z), ("Charge", z)):
        add(data, name, values)
    add(data, "SiteClass", numpy.where(z > 0, 1, 2).astype(numpy.int32))
    data.SetActiveScalars("Potential")
    return result


def loop():
    """The equator of the surface as a closed polyline."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    angles = numpy.arange(10) * numpy.pi / 5
    lines = vtkCellArray()
    for angle in angles:
        points.InsertNextPoint(4.9 * numpy.cos(angle), 4.9 * numpy.sin(angle), 0.7)
    lines.InsertNextCell(11, list(range(10)) + [0])
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    return result


def image():
    """A ball of density that falls off smoothly, 12 nodes each way, 1 angstrom apart."""
    result = vtkImageData()
    result.SetDimensions(12, 12, 12)
    result.SetOrigin(-5.5, -5.5, -5.5)
    axis = numpy.arange(12) - 5.5
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    add(result.GetPointData(), "Density", numpy.exp(-(x * x + y * y + z * z) / 12).ravel())
    result.GetPointData().SetActiveScalars("Density")
    return result


def tetrahedra():
    """The points of the surface and its middle, as tetrahedra."""
    delaunay = vtkDelaunay3D()
    delaunay.SetInputData(surface())
    delaunay.Update()
    result = vtkUnstructuredGrid()
    result.SetPoints(delaunay.GetOutput().GetPoints())
    cells = delaunay.GetOutput()
    for i in range(cells.GetNumberOfCells()):
        cell = cells.GetCell(i)
        if cell.GetCellType() == VTK_TETRA:
            result.InsertNextCell(VTK_TETRA, 4, [cell.GetPointId(k) for k in range(4)])
    z = vtk_to_numpy(result.GetPoints().GetData())[:, 2].astype(float)
    add(result.GetPointData(), "Height", z)
    result.GetPointData().SetActiveScalars("Height")
    return result


def features():
    """Three places, as filters that rank features give them."""
    result = vtkTable()
    for name in ("CenterX", "CenterY", "CenterZ", "Radius", "Score"):
        add(result, name, numpy.array([1.0, 5.0, 9.0]))
    return result


def molecule():
    """Three carbon atoms in a row."""
    result = vtkMolecule()
    for x in (0.0, 1.5, 3.0):
        result.AppendAtom(6, x, 0.0, 0.0)
    return result


def channel():
    """A tube of atoms, six rings of eight, that ions pass."""
    result = vtkPolyData()
    result.SetPoints(vtkPoints())
    result.GetPoints().SetDataTypeToDouble()
    for ring in range(6):
        for i in range(8):
            angle = (i + 0.5 * (ring % 2)) * numpy.pi / 4
            result.GetPoints().InsertNextPoint(4.5 * numpy.cos(angle), 4.5 * numpy.sin(angle), 2.0 * ring - 5.0)
    count = result.GetNumberOfPoints()
    add(result.GetPointData(), "Radius", numpy.full(count, 1.7))
    add(result.GetPointData(), "Charge", numpy.where(numpy.arange(count) % 2, 0.2, -0.3))
    add(result.GetPointData(), "WellDepth", numpy.full(count, 0.1))
    return result


def channel_surface():
    """A closed tube around the axis, 2.5 to 6.5 angstrom from it, 14 long."""
    inner, outer, half, count = 2.5, 6.5, 7.0, 16
    points, polygons = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    corners = ((inner, -half), (outer, -half), (outer, half), (inner, half))
    for i in range(count):
        angle = 2 * numpy.pi * i / count
        for radius, z in corners:
            points.InsertNextPoint(radius * numpy.cos(angle), radius * numpy.sin(angle), z)
    for i in range(count):
        here, there = 4 * i, 4 * ((i + 1) % count)
        for k in range(4):
            a, b = here + k, here + (k + 1) % 4
            c, d = there + k, there + (k + 1) % 4
            polygons.InsertNextCell(3, [a, b, c])
            polygons.InsertNextCell(3, [b, d, c])
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(polygons)
    return result


MAKERS = {"vtkTable": features, "vtkMolecule": molecule, "vtkPolyData": surface, "vtkPointSet": surface, "vtkImageData": image,
          "vtkUnstructuredGrid": tetrahedra, "vtkDataSet": surface, "vtkDataObject": surface}
ION_TRANSPORT = ("IonTransport", "IonTransportOnSurface", "IonTransportMovingSurface")
# Ports whose type does not tell what they want.
SPECIAL = {("LoopShortening", "Input"): loop,
           **{(name, port): make for name in ION_TRANSPORT
              for port, make in (("Input", channel), ("Surface", channel_surface))}}
# Properties of filters that must be given, or whose defaults are for more than small data.
COARSE = {"HighOrderDiffusion": {"Time": 1.0},
          **{name: {"Spacing": 1.5, "Padding": 4.0, "MembraneThickness": 8.0} for name in ION_TRANSPORT}}
INPUTS = ports_of_filters()


def filters():
    return sorted(INPUTS)


def kinds(name):
    """The types that the first input of a filter takes."""
    return INPUTS[name][0][1]


def producer(data):
    source = PVTrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def sound(name, port, kind):
    return SPECIAL.get((name, port), MAKERS.get(kind))()


def made(name, kind=None, replaced=None, optional=True):
    """A fresh proxy with sound inputs, of type `kind` on the first port; `replaced` gives other data
    for some ports. Ports that may stay empty are filled unless `optional` is off.
    """
    inputs = {}
    for number, (port, accepted, can_miss) in enumerate(INPUTS[name]):
        if replaced and port in replaced:
            inputs[port] = producer(replaced[port])
        elif optional or not can_miss:
            of_kind = kind if kind and number == 0 else accepted[0]
            inputs[port] = producer(sound(name, port, of_kind))
    proxy = getattr(servermanager.filters, name)(**inputs, **COARSE.get(name, {}))
    proxy.UpdateVTKObjects()
    return proxy


# The first proxy of a process takes a tenth of a second. Trials run in children: theirs is made here.
made(filters()[0])
