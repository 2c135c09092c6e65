"""Every shared map through the denoising of the example, with the noise before and after."""

import math

import isthmus

from shared_data import shared_data
from volume_quality import as_volume

SUFFIXES = (".map", ".mrc", ".mrcs", ".ccp4", ".map.gz", ".ccp4.gz", ".msk.gz", ".map.bz2")


def read(path):
    """The map as an image; empty if the reader refuses it."""
    said = []
    reader = isthmus.vtkMRCMapReader()
    reader.AddObserver("ErrorEvent", lambda *_: said.append("error"))
    reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: said.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput(), bool(said)


def filtered(algorithm, image, **settings):
    """Result and noise level."""
    said = []
    algorithm.AddObserver("ErrorEvent", lambda *_: said.append("error"))
    algorithm.MaskInvalidOn()
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputData(image)
    algorithm.Update()
    assert not said, "the filter complains"
    field = algorithm.GetOutput().GetFieldData()
    return algorithm.GetOutput(), field.GetArray("NoiseLevel").GetValue(0)


def noise_level(image):
    """The level of white noise, by which an explicit step of the equation, a short one, chooses its Sigma."""
    return filtered(isthmus.vtkHighOrderDiffusion(), image, Time=1e-6, Steps=1, Integrator=0)[1]


folder = shared_data("maps")
done = 0
for path in sorted(folder.iterdir()):
    if not path.name.endswith(SUFFIXES):
        continue
    image, refused = read(path)
    if image.GetNumberOfPoints() == 0 or image.GetPointData().GetScalars() is None:
        assert refused, path.name
        print(f"{path.name:40s} is refused by the reader")
        continue
    scalars = image.GetPointData().GetScalars()
    if scalars.GetNumberOfComponents() != 1:
        print(f"{path.name:40s} has {scalars.GetNumberOfComponents()} components: no density")
        continue
    result, _ = filtered(isthmus.vtkDenoiseMap(), image)
    before, after = (noise_level(one) for one in (image, result))
    given, got = as_volume(image), as_volume(result)
    print(f"{path.name:40s} {'x'.join(map(str, image.GetDimensions())):>12s} noise {before:.3g} -> "
          f"{after:.3g}; deviation {given.std():.4g} -> {got.std():.4g}; mean {given.mean():.4g} -> "
          f"{got.mean():.4g}")
    assert result.GetDimensions() == image.GetDimensions()
    assert math.isfinite(got.std())
    assert abs(got.mean() - given.mean()) <= 1e-4 * (abs(given).mean() + 1e-30)
    # Of a map without noise, the estimate is what little the map itself bends.
    assert after <= before or before < 1e-3 * given.std()
    assert got.std() <= given.std() * (1 + 1e-6)
    done += 1
print(f"{done} maps")
assert done >= 30
