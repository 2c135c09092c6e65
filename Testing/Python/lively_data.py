"""Small inputs on which properties show: good_data.py's are sound and smooth, these have two pieces,
noise, patches of either sign, residues, ligands, water.
"""

import os
import tempfile

import numpy
from paraview import servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource

import good_data
from good_data import add


def surface():
    """A bent ball of 5 angstrom and a small one beside it, with patches of either sign."""
    both = vtkAppendPolyData()
    for radius, x, resolution in ((5.0, 0.0, 24), (1.0, 9.0, 8)):
        ball = vtkSphereSource()
        ball.SetRadius(radius)
        ball.SetCenter(x, 0.0, 0.0)
        ball.SetThetaResolution(resolution)
        ball.SetPhiResolution(resolution)
        ball.SetOutputPointsPrecision(1)
        both.AddInputConnection(ball.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(both.GetOutputPort())
    clean = vtkCleanPolyData()
    clean.SetInputConnection(triangles.GetOutputPort())
    clean.Update()
    result = vtkPolyData()
    result.ShallowCopy(clean.GetOutput())
    points = vtk_to_numpy(result.GetPoints().GetData())
    points[:, 2] += 0.05 * points[:, 0] ** 2
    x, y, z = points.T
    wave = 4 * numpy.sin(0.9 * x) * numpy.cos(0.7 * y) + 0.4 * z
    data = result.GetPointData()
    data.Initialize()
    for name, values in (("Radius", 1.5 + 0.1 * numpy.sin(x)), ("MaximumCurvature", 0.2 + 0.1 * numpy.sin(y)),
                         ("MinimumCurvature", 0.1 * numpy.cos(x)), ("Potential", wave),
                         ("PolarizedCurvature", wave), ("Charge", z)):
        add(data, name, values)
    add(data, "SiteClass", numpy.where(wave > 0, numpy.where(x > 0, 1, 3), numpy.where(x > 0, 2, 4)).astype(numpy.uint8))
    data.SetActiveScalars("Potential")
    return result


def image(seed=1):
    """Two balls of density, one small, with noise; a voxel is 1.2 angstrom."""
    result = vtkImageData()
    result.SetDimensions(16, 14, 14)
    result.SetSpacing(1.2, 1.2, 1.2)
    result.SetOrigin(-7.0, -7.8, -7.8)
    z, y, x = numpy.meshgrid(numpy.arange(14.0), numpy.arange(14.0), numpy.arange(16.0), indexing="ij")
    ball = numpy.exp(-((x - 6) ** 2 + (y - 6.5) ** 2 + (z - 6.5) ** 2) / 10)
    ball += 0.8 * numpy.exp(-((x - 13) ** 2 + (y - 7) ** 2 + (z - 7) ** 2) / 2)
    noise = numpy.random.default_rng(seed).normal(0.0, 0.03, ball.shape)
    add(result.GetPointData(), "Density", (ball + noise).ravel())
    result.GetPointData().SetActiveScalars("Density")
    return result


def pdb_line(record, serial, atom, residue, number, element, place):
    return (f"{record:<6}{serial:>5} {atom:<4} {residue:>3} A{number:>4}    "
            f"{place[0]:8.3f}{place[1]:8.3f}{place[2]:8.3f}{1.0:6.2f}{20.0:6.2f}          {element:>2}\n")


def atoms():
    """A hollow ball of carbon atoms with two openings, hydrogens on it, and within it water, an ion, a
    ligand and a heme, as the reader of molecules gives them; each atom with a charge."""
    lines, serial = [], 0

    def put(record, atom, residue, number, element, place):
        nonlocal serial
        serial += 1
        lines.append(pdb_line(record, serial, atom, residue, number, element, place))

    count = 240
    for i in range(count):
        height = 1 - (2 * i + 1) / count
        angle, across = 2.399963 * i, numpy.sqrt(1 - height * height)
        outward = numpy.array([across * numpy.cos(angle), across * numpy.sin(angle), height])
        if abs(height) < 0.9:
            put("ATOM", " CA ", "ALA", 1 + i // 5, "C", 8.0 * outward)
            if i % 20 == 0:
                put("ATOM", " HA ", "ALA", 1 + i // 5, "H", 9.1 * outward)
    for number, atom, residue, element, place in (
            (100, " O  ", "HOH", "O", (0, 0, 8.5)), (101, "NA  ", " NA", "NA", (1.5, 0, -8.3)),
            (102, " C1 ", "LIG", "C", (0, 2.0, 3.0)), (102, " C2 ", "LIG", "C", (0, 3.4, 3.0)),
            (103, " CHA", "HEM", "C", (0, -2.5, -3.0)), (103, " CHB", "HEM", "C", (0, -3.9, -3.0))):
        put("HETATM", atom, residue, number, element, place)
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shell.pdb")
        with open(path, "w", encoding="ascii") as file:
            file.write("".join(lines) + "END\n")
        reader = servermanager.sources.MacromoleculeReader(FileName=path)
        reader.UpdatePipeline()
        result = vtkPolyData()
        result.ShallowCopy(reader.GetClientSideObject().GetOutputDataObject(0))
    number = numpy.arange(result.GetNumberOfPoints())
    add(result.GetPointData(), "Charge", 0.3 * numpy.sin(number))
    return result


def around_atoms():
    ball = vtkSphereSource()
    ball.SetRadius(12.0)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(24)
    ball.Update()
    return ball.GetOutput()


def flow_volume():
    """What NonpolarSolvation takes beside the atoms: output 1 of their flow surface."""
    flow = servermanager.filters.MolecularFlowSurface(Input=good_data.producer(atoms()))
    flow.UpdatePipeline()
    result = vtkImageData()
    result.ShallowCopy(flow.GetClientSideObject().GetOutputDataObject(1))
    return result


def tetrahedra():
    result = good_data.tetrahedra()
    add(result.GetCellData(), "Part", numpy.arange(result.GetNumberOfCells()) % 3)
    return result


def ring():
    """A ring whose tube is thrice as thick at one side as at two narrows: a handle, a tunnel, bottlenecks."""
    around, across = 48, 16
    u, v = numpy.meshgrid(2 * numpy.pi * numpy.arange(around) / around,
                          2 * numpy.pi * numpy.arange(across) / across, indexing="ij")
    tube = 1.0 + 0.5 * numpy.cos(2 * u) + 0.1 * numpy.cos(u)
    places = numpy.stack([(4 + tube * numpy.cos(v)) * numpy.cos(u), (4 + tube * numpy.cos(v)) * numpy.sin(u),
                          tube * numpy.sin(v)], axis=-1).reshape(-1, 3)
    points, cells = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for place in places:
        points.InsertNextPoint(*place)
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            for corners in ((a, b, c), (a, c, d)):
                cells.InsertNextCell(3, corners)
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


MAKERS = dict(good_data.MAKERS, vtkPolyData=surface, vtkPointSet=surface, vtkImageData=image,
              vtkDataSet=surface, vtkDataObject=surface, vtkUnstructuredGrid=tetrahedra)
TAKE_ATOMS = ("MolecularPockets", "PoreProfile", "MolecularFlowSurface", "MolecularDensity",
              "NonpolarSolvation", "PoissonBoltzmann", "PoissonBoltzmannOnSurface")
SPECIAL = dict(good_data.SPECIAL)
SPECIAL.update({(name, "Input"): atoms for name in TAKE_ATOMS})
SPECIAL.update({("ChokingLoops", "Input"): ring, ("HandleFilling", "Input"): ring,
                ("NonpolarSolvation", "Volume"): flow_volume,
                **{(name, "OtherHalf"): lambda: image(2) for name in ("DenoiseFromHalfMaps", "MapHandles")},
                ("PoissonBoltzmannOnSurface", "Surface"): around_atoms})
for name in ("IonTransport", "IonTransportMovingSurface"):
    del SPECIAL[name, "Surface"]  # computed from the atoms instead


def inputs(name, kind):
    """{port: data} for a proxy whose first input is of type `kind`; ports that may stay empty do, but for
    those in SPECIAL."""
    return {port: SPECIAL.get((name, port), MAKERS.get(kind if number == 0 else accepted[0]))()
            for number, (port, accepted, can_miss) in enumerate(good_data.INPUTS[name])
            if not can_miss or (name, port) in SPECIAL}
