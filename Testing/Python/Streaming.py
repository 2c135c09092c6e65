"""Image filters asked for a part after the other, on one rank: the bits of the whole.

By extents, and by pieces as ParaView streams them. And the documented rule for blocks of a map that is
larger than memory: with as many nodes around them as the steps reach, they have the bits of the whole.
"""

import isthmus
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageChangeInformation, vtkRTAnalyticSource

WHOLE = (-12, 13, -9, 10, -14, 15)
PARTS = ((-12, -3, -9, 10, -14, 15), (-2, 13, -9, 10, 0, 3), (0, 4, 1, 5, -3, 2), (13, 13, 10, 10, 15, 15))


def made(name, **properties):
    instance = getattr(isthmus, name)()
    for key, value in properties.items():
        getattr(instance, "Set" + key)(value)
    return instance


def source():
    wavelet = vtkRTAnalyticSource()
    wavelet.SetWholeExtent(*WHOLE)
    return wavelet


def filters():
    """Name, filter, its arrays, and how many nodes more than an extent it asks for: None for all."""
    for accuracy, reach in ((2, 1), (4, 2)):
        yield (f"curvature {accuracy}", made("vtkHessianCurvature", Accuracy=accuracy, AutomaticScale=False),
               ["MeanCurvature", "GaussianCurvature", "CurvatureValid"], reach)
    yield "curvature, automatic scale", made("vtkHessianCurvature"), ["MeanCurvature", "CurvatureError"], None
    yield "denoise", made("vtkDenoiseMap"), ["RTData"], None
    yield "diffusion, order 1", made("vtkHighOrderDiffusion", Order=1, Time=1.0), ["RTData"], None
    yield "high-pass", made("vtkDiffusionHighPass"), ["HighPass"], None
    halves = made("vtkDenoiseFromHalfMaps")
    other = source()
    other.SetStandardDeviation(0.4)
    halves.SetInputConnection(1, other.GetOutputPort())
    yield "half maps", halves, ["RTData"], None
    yield "transform", made("vtkPDETransform", NumberOfModes=2), ["Mode1", "Residue"], None


def extent_nodes(extent):
    return [extent[2 * axis + 1] - extent[2 * axis] + 1 for axis in (2, 1, 0)]


def within(image, name, extent):
    """An array of the image within an extent, indexed z, y, x."""
    held = image.GetExtent()
    array = vtk_to_numpy(image.GetPointData().GetArray(name)).reshape(extent_nodes(held))
    return array[tuple(slice(extent[2 * axis] - held[2 * axis], extent[2 * axis + 1] - held[2 * axis] + 1)
                       for axis in (2, 1, 0))].copy()


def places(extent):
    """Where an extent lies in an array of the whole."""
    return tuple(slice(extent[2 * axis] - WHOLE[2 * axis], extent[2 * axis + 1] - WHOLE[2 * axis] + 1)
                 for axis in (2, 1, 0))


def same(one, other):
    return one.shape == other.shape and one.tobytes() == other.tobytes()


def contains(outer, inner):
    return all(outer[2 * axis] <= inner[2 * axis] and inner[2 * axis + 1] <= outer[2 * axis + 1] for axis in range(3))


def grown(extent, reach, whole):
    return tuple(max(bound - reach, limit) if side % 2 == 0 else min(bound + reach, limit)
                 for side, (bound, limit) in enumerate(zip(extent, whole)))


def check_extents(name, algorithm, arrays, reach):
    wavelet = source()
    algorithm.SetInputConnection(wavelet.GetOutputPort())
    algorithm.Update()
    whole = {array: within(algorithm.GetOutput(), array, WHOLE) for array in arrays}
    for part in PARTS:
        algorithm.Modified()
        wavelet.Modified()
        algorithm.UpdateExtent(part)
        image = algorithm.GetOutput()
        asked = WHOLE if reach is None else grown(part, reach, WHOLE)
        assert wavelet.GetOutput().GetExtent() == asked, (name, part, wavelet.GetOutput().GetExtent())
        assert contains(image.GetExtent(), part), (name, part, image.GetExtent())
        for array in arrays:
            assert same(within(image, array, part), whole[array][places(part)]), (name, array, part)
    return whole


def check_pieces(name, algorithm, arrays, whole):
    algorithm.UpdateExtent(WHOLE)  # what is split
    for pieces in (2, 3):
        seen = numpy.zeros(extent_nodes(WHOLE), int)
        for piece in range(pieces):
            algorithm.UpdatePiece(piece, pieces, 0)
            extent = algorithm.GetOutput().GetExtent()
            assert contains(WHOLE, extent) and extent != WHOLE, (name, pieces, extent)
            seen[places(extent)] += 1
            for array in arrays:
                part = within(algorithm.GetOutput(), array, extent)
                assert same(part, whole[array][places(extent)]), (name, array, pieces, piece)
        assert seen.min() >= 1, (name, pieces)


for name, algorithm, arrays, reach in filters():
    results = check_extents(name, algorithm, arrays, reach)
    check_pieces(name, algorithm, arrays, results)
    print(f"{name}: parts have the bits of the whole", flush=True)


def image_of(values, extent):
    image = vtkImageData()
    image.SetExtent(extent)
    array = numpy_to_vtk(values.ravel(), deep=True)
    array.SetName("Density")
    image.GetPointData().SetScalars(array)
    return image


def block_differs(make, result, extent, halo, values):
    """Whether a block that was filtered with a halo has other bits than the whole has there."""
    nodes = values.shape
    whole = (0, nodes[2] - 1, 0, nodes[1] - 1, 0, nodes[0] - 1)
    outputs = []
    for part in (whole, grown(extent, halo, whole)):
        algorithm = make()
        cut = values[part[4]:part[5] + 1, part[2]:part[3] + 1, part[0]:part[1] + 1]
        algorithm.SetInputData(image_of(numpy.ascontiguousarray(cut), part))
        algorithm.Update()
        outputs.append(within(algorithm.GetOutput(), result, extent))
    return not same(*outputs)


# One evaluation looks max(order + 1, 2) nodes far, so many explicit steps as many times that. Of a
# wave of white noise every step changes every node, so half the halo is not enough.
STEPS = 4
noise = numpy.random.default_rng(5).normal(0, 1, (60, 20, 24)).astype("f4")
for order, length in ((0, 0.1), (1, 0.01)):
    def explicit(order=order, length=length):
        return made("vtkHighOrderDiffusion", Order=order, Integrator=0, Steps=STEPS, Time=STEPS * length, Sigma=1.0)

    block = (0, 23, 0, 19, 28, 31)
    halo = STEPS * max(order + 1, 2)
    assert not block_differs(explicit, "Density", block, halo, noise), order
    assert block_differs(explicit, "Density", block, halo // 2 - 1, noise), order
    print(f"order {order}, {STEPS} explicit steps: {halo} nodes around a block give the bits of the whole", flush=True)

# The persistence of a volume is global: it asks for all of it, whatever part is wanted. Its simplified
# volume is a volume like any other.
persistence = made("vtkScalarPersistence", Simplify=True, MinimumPersistence=20.0)
SIMPLIFIED = 4  # of its outputs
wavelet = source()
persistence.SetInputConnection(wavelet.GetOutputPort())
persistence.Update()
pairs = persistence.GetDiagram().GetNumberOfRows()
whole = within(persistence.GetOutputDataObject(SIMPLIFIED), "RTData", WHOLE)
assert pairs > 1
simplified = vtkImageChangeInformation()
simplified.SetInputConnection(persistence.GetOutputPort(SIMPLIFIED))
check_pieces("simplified", simplified, ["RTData"], {"RTData": whole})
for piece in (2, 1, 0):
    persistence.Modified()
    persistence.UpdatePiece(piece, 3, 0)
    assert wavelet.GetOutput().GetExtent() == WHOLE, wavelet.GetOutput().GetExtent()
    assert persistence.GetDiagram().GetNumberOfRows() == (pairs if piece == 0 else 0), piece
print("persistence: the first piece has the pairs of the whole")
print("passed")
