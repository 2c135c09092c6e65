"""Compares Denoise Map with its default settings against other denoising methods whose settings are tuned
with the true volume.

Usage: pvpython evaluate_denoising.py DATA [--volumes NAME ...] [--rows ROWS] [--slow one] [--halves] [--picture FILE]

DATA is the folder of the shared data (maps, molecules). Volumes of four kinds (public maps, model densities,
phantoms, masked maps), each with white noise of 0.1, 0.3 and 1 standard deviations of the volume and with
noise under a Gaussian of 1 voxel, of the same levels, and of 2 voxels. The other methods (from scipy and skimage:
Gaussian, median, total variation and wavelets) use the setting with the smallest true error. Slow columns, which
take a minute per row each: non-local means, BM4D and the oracle, the best of the filter's own family (linear:
orders 0 to 3, 25 times; edge stopping: orders 0 to 2, four Sigmas, four presmoothings, five times). They are
computed with --slow one (only for white noise of 0.3) or --slow all. Denoise Map is evaluated for both goals, and for
volumes also with the noise level given. Prints Markdown: PSNR in dB, ratio of estimated to true noise level,
estimated and true gain, and the table of the guide's page.

With --halves: pairs of half maps. One half map is denoised without the other, and its Fourier shell correlation
with the other half, up to the first shell below 0.143, is compared before and after; the mean of both is denoised
and compared with the true volume.

Half of the volumes of each kind were set aside before tuning (ASIDE, drawn with Python's random.Random(38)).
BM4D is not in Debian; if the Python package bm4d is installed, it is an additional column, with the true noise level.
"""

import argparse
import sys
from pathlib import Path

import numpy
from scipy import fft, ndimage

import study_paths  # noqa: F401 (before isthmus)
import isthmus
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOImage import vtkPNGWriter
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the rendering classes)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

try:
    from skimage import restoration
except ImportError:
    restoration = None
try:
    import bm4d
except ImportError:
    bm4d = None

# Drawn with random.Random(38). EMD-5170 and the 70S ribosome are each in only one of the two sets.
ASIDE = {"map EMD-5043", "map EMD-1155", "map GroEL subunit", "map 70S", "model lysozyme 1.5 A",
         "model 1UBQ 4 A", "model ubiquitin 8.5 A", "phantom sharp 2", "phantom gyroid", "masked EMD-5170",
         "masked ubiquitin"}
ROWS = ((0.1, 0), (0.3, 0), (1.0, 0), (0.1, 1.0), (0.3, 1.0), (1.0, 1.0), (1.0, 2.0))


def image_of(volume):
    image = vtkImageData()
    image.SetDimensions(volume.shape[::-1])
    scalars = numpy_to_vtk(numpy.ascontiguousarray(volume, numpy.float32).ravel(), deep=True)
    scalars.SetName("Density")
    image.GetPointData().SetScalars(scalars)
    return image


def volume_of(image):
    scalars = vtk_to_numpy(image.GetPointData().GetScalars())
    return scalars.reshape(image.GetDimensions()[::-1]).astype(float)


def center(volume, side=64):
    """The central part of a volume, with at most side nodes along each axis."""
    begins = [max(0, (n - side) // 2) for n in volume.shape]
    return volume[tuple(slice(begin, begin + side) for begin in begins)].copy()


def public_map(data, name, side=64):
    reader = isthmus.vtkMRCMapReader()
    reader.SetFileName(str(data / "maps" / name))
    reader.Update()
    return center(volume_of(reader.GetOutput()), side)


def model_density(data, name, resolution, spacing, side):
    """Gaussians at the atoms of a PDB file other than hydrogen, 0.225 resolutions wide."""
    atoms = numpy.array([[float(line[start : start + 8]) for start in (30, 38, 46)]
                         for line in open(data / "molecules" / name)
                         if line.startswith("ATOM") and line[76:78].strip() != "H"])
    width = 0.225 * resolution
    axes = atoms.mean(axis=0)[:, None] + spacing * (numpy.arange(side) - (side - 1) / 2)
    volume = numpy.zeros((side,) * 3)
    for atom in atoms:
        spans, factors = [], []
        for axis, place in zip(axes, atom):
            near = numpy.flatnonzero(abs(axis - place) < 4 * width)
            spans.append(slice(near[0], near[-1] + 1) if len(near) else slice(0, 0))
            factors.append(numpy.exp(-((axis[spans[-1]] - place) ** 2) / (2 * width**2)))
        volume[spans[2], spans[1], spans[0]] += (
            factors[2][:, None, None] * factors[1][:, None] * factors[0])
    return volume


def sharp_phantom(seed, side=64):
    """Blobs, balls and boxes with sharp edges at random places."""
    chance = numpy.random.default_rng(seed)
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(side)] * 3, indexing="ij")).astype(float)
    volume = numpy.zeros((side,) * 3)
    for kind in range(18):
        offset = grid - chance.uniform(0.2 * side, 0.8 * side, 3)[:, None, None, None]
        radius = numpy.sqrt((offset**2).sum(axis=0))
        size = chance.uniform(4, 9)
        if kind % 3 == 0:
            volume += chance.uniform(0.6, 1.2) * numpy.exp(-(radius**2) / (0.7 * size**2))
        elif kind % 3 == 1:
            volume = numpy.maximum(volume, abs(radius - size) < 1.6)
        else:
            volume = numpy.maximum(volume, (abs(offset).max(axis=0) < size) * chance.uniform(0.8, 1.2))
    return volume


def smooth_phantom(kind, side=64):
    axis = numpy.arange(side) - (side - 1) / 2
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    if kind == "torus":
        distance = numpy.hypot(numpy.hypot(x, y) - 18, z) - 8
        return 1 / (1 + numpy.exp(distance / 2))
    x, y, z = (2 * numpy.pi * a / 24 for a in (x, y, z))
    return numpy.tanh(2 * (numpy.sin(x) * numpy.cos(y) + numpy.sin(y) * numpy.cos(z)
                           + numpy.sin(z) * numpy.cos(x)))


def volumes(data):
    """Name: function that makes it. Masked volumes are cut to a mask around high values."""
    return {
        "map EMD-5043": lambda: public_map(data, "emd_5043.map"),
        "map EMD-1832": lambda: public_map(data, "emd_1832.map"),
        "map EMD-5170": lambda: public_map(data, "emd_5170.map"),
        "map EMD-1703": lambda: public_map(data, "emd_1703.map"),
        "map EMD-1155": lambda: public_map(data, "emd_1155.ccp4"),
        "map GroEL subunit": lambda: public_map(data, "gorgon_groel_densityMap.mrc"),
        "map 70S": lambda: public_map(data, "clean70SRibosome_vol_65p.mrc"),
        "map X-ray": lambda: public_map(data, "pymol_web_map_bigendian.ccp4"),
        "model 1OEL 10 A": lambda: public_map(data, "1oel_10.mrc"),
        "model ubiquitin 8.5 A": lambda: public_map(data, "Ubi-8.5.mrc"),
        "model 1AKE": lambda: public_map(data, "1ake.mrc"),
        "model lysozyme 1.5 A": lambda: model_density(data, "2LYZ.pdb", 1.5, 0.6, 64),
        "model 1UBQ 4 A": lambda: model_density(data, "1ubq.pdb", 4.0, 1.0, 56),
        "model 4PTI 2.5 A": lambda: model_density(data, "4pti.pdb", 2.5, 0.8, 56),
        "phantom sharp 2": lambda: sharp_phantom(2),
        "phantom sharp 5": lambda: sharp_phantom(5),
        "phantom torus": lambda: smooth_phantom("torus"),
        "phantom gyroid": lambda: smooth_phantom("gyroid"),
        "masked EMD-5170": lambda: public_map(data, "emd_5170.map"),
        "masked ubiquitin": lambda: public_map(data, "Ubi-8.5.mrc"),
        "masked 70S": lambda: public_map(data, "clean70SRibosome_vol_65p.mrc"),
        "masked lysozyme": lambda: model_density(data, "2LYZ.pdb", 3.0, 1.0, 56),
    }


def mask_of(volume):
    smooth = ndimage.gaussian_filter(volume, 2)
    return ndimage.binary_dilation(smooth > numpy.quantile(smooth, 0.7), iterations=3)


def noise_of(shape, correlation, seed):
    noise = numpy.random.default_rng(seed).normal(size=shape)
    if correlation > 0:
        noise = ndimage.gaussian_filter(noise, correlation, mode="wrap")
    return noise / noise.std()


def peak_ratio(volume, truth):
    return 10 * numpy.log10(numpy.ptp(truth) ** 2 / numpy.mean((volume - truth) ** 2))


def tuned_rivals(noisy, truth, level, slow):
    """For each method, the PSNR with the best setting."""
    best = {
        "Gauss": max(peak_ratio(ndimage.gaussian_filter(noisy, width), truth)
                     for width in numpy.geomspace(0.3, 4, 18)),
        "median": max(peak_ratio(ndimage.median_filter(noisy, size), truth) for size in (3, 5)),
    }
    if restoration:
        best["TV"] = max(
            peak_ratio(restoration.denoise_tv_chambolle(noisy, weight=weight * level, max_num_iter=100), truth)
            for weight in (0.2, 0.4, 0.6, 0.9, 1.3, 2.0, 3.0))
        try:
            best["wavelet"] = max(
                peak_ratio(restoration.denoise_wavelet(noisy, sigma=factor * level, mode=mode), truth)
                for factor in (0.5, 1.0) for mode in ("soft", "hard"))
        except ImportError:
            pass  # needs PyWavelets
        if slow:
            best["NLM"] = max(
                peak_ratio(restoration.denoise_nl_means(
                    noisy, patch_size=3, patch_distance=4, h=h * level, sigma=level, fast_mode=True), truth)
                for h in (0.3, 0.6, 1.0))
    if bm4d and slow:
        best["BM4D"] = peak_ratio(bm4d.bm4d(noisy, level), truth)
    return best


def family_oracle(noisy, truth, level):
    """The best of the filter's own parameters."""
    modes = [4 * numpy.sin(numpy.pi * numpy.arange(n) / (2 * n)) ** 2 for n in noisy.shape]
    eigenvalues = sum(numpy.meshgrid(*modes, indexing="ij"))
    waves, true_waves = (fft.dctn(v, norm="ortho") for v in (noisy, truth))
    best = min(numpy.mean((numpy.exp(-((length**2 * eigenvalues) ** (order + 1))) * waves - true_waves) ** 2)
               for order in range(4) for length in numpy.geomspace(0.3, 5, 25))
    least = 10 * numpy.log10(numpy.ptp(truth) ** 2 / best)
    for order, times in ((0, (0.3, 1, 2, 4, 8)), (1, (0.03, 0.1, 0.3, 1, 3)), (2, (0.01, 0.03, 0.1, 0.3, 1))):
        for sigma in (0.5, 1, 2, 4):
            for smoothing in (0, 0.35, 0.7, 1.4):
                before, volume = 0, noisy
                for time in times:
                    volume, _ = filtered(isthmus.vtkHighOrderDiffusion, volume, Order=order, Sigma=sigma * level,
                                         PreSmoothing=smoothing, Time=time - before)
                    before = time
                    least = max(least, peak_ratio(volume, truth))
    return least


def denoised(volume, **settings):
    return filtered(isthmus.vtkDenoiseMap, volume, **settings)


def filtered(vtk_class, volume, **settings):
    """The result and its field data."""
    algorithm = vtk_class()
    for name, value in settings.items():
        getattr(algorithm, "Set" + name)(value)
    algorithm.SetInputData(image_of(volume))
    algorithm.Update()
    field = algorithm.GetOutput().GetFieldData()
    fields = {field.GetArrayName(n): field.GetArray(n).GetValue(0) for n in range(field.GetNumberOfArrays())
              if field.GetArray(n) and field.GetArray(n).GetNumberOfTuples()}
    return volume_of(algorithm.GetOutput()), fields


def judge(name, truth, level, correlation, options):
    mask = mask_of(truth) if name.startswith("masked") else numpy.ones(truth.shape, bool)
    truth = truth * mask
    deviation = level * truth[mask].std()
    noisy = truth + deviation * mask * noise_of(truth.shape, correlation, [1, sum(map(ord, name)), int(100 * level),
                                                                         int(10 * correlation)])
    noisy = noisy.astype(numpy.float32).astype(float)
    row = {"aside": "yes" if name in ASIDE else "", "volume": name, "noise": level, "corr.": correlation,
           "noisy": peak_ratio(noisy, truth)}
    slow = options.slow == "all" or options.slow == "one" and (level, correlation) == (0.3, 0)
    rivals = tuned_rivals(noisy, truth, deviation, slow)
    row.update({"NLM": numpy.nan, "BM4D": numpy.nan}, **rivals)
    row["oracle"] = family_oracle(noisy, truth, deviation) if slow else numpy.nan
    surfaces, _ = denoised(noisy, Goal=0)
    chosen, fields = denoised(noisy, Goal=1)
    known, fields_known = denoised(noisy, Goal=1, KnownNoise=deviation)
    row["surfaces"], row["volumes"] = peak_ratio(surfaces, truth), peak_ratio(chosen, truth)
    row["known"] = peak_ratio(known, truth)
    row["found/true noise"] = fields["NoiseLevel"] / deviation
    row["estimated gain"] = fields_known["EstimatedGain"]
    row["true gain"] = row["known"] - row["noisy"]
    row["its s.e."] = fields_known["EstimatedGainError"]
    row["choice"] = (f"{int(fields['UsedOrder'])} {'edges' if fields['UsedEdgeStopping'] else 'linear'} "
                     f"{fields['UsedTime']:.3g}")
    row["lead"] = row["volumes"] - max(value for key, value in rivals.items() if key != "BM4D")
    return row


def half_maps_denoised(one, other, goal):
    algorithm = isthmus.vtkDenoiseFromHalfMaps()
    algorithm.SetGoal(goal)
    algorithm.SetInputData(image_of(one))
    algorithm.SetOtherHalfData(image_of(other))
    algorithm.Update()
    return volume_of(algorithm.GetOutput())


def shell_correlation(one, other):
    """Fourier shell correlation, shell by shell, and how many independent waves each shell has."""
    a, b = (fft.fftn(volume - volume.mean()) for volume in (one, other))
    shells = numpy.sqrt(sum(numpy.meshgrid(*[(fft.fftfreq(n) * min(one.shape)) ** 2 for n in one.shape],
                                           indexing="ij"))).round().astype(int).ravel()
    sums = [numpy.bincount(shells, values.ravel())
            for values in ((a * b.conj()).real, abs(a) ** 2, abs(b) ** 2)]
    last = min(one.shape) // 2 + 1
    return (sums[0] / numpy.sqrt(sums[1] * sums[2]))[1:last], (numpy.bincount(shells) / 2)[1:last]


def judge_halves(name, truth, level, correlation):
    """Compares half 1, denoised by itself, with half 2, and the mean of the halves with the true volume."""
    deviation = level * truth.std()
    seed = [2, sum(map(ord, name)), int(100 * level), int(10 * correlation)]
    one, other = (truth + deviation * noise_of(truth.shape, correlation, [*seed, half]) for half in (1, 2))
    before, waves = shell_correlation(one, other)
    below = numpy.flatnonzero(before < 0.143)
    limit = below[0] if len(below) else len(before)
    error = (1 - before**2) / numpy.sqrt(waves)
    mean = (one + other) / 2
    row = {"volume": name, "noise": level, "corr.": correlation, "shells": str(limit)}
    for goal, title in enumerate(("surfaces", "volumes")):
        change = shell_correlation(denoised(one, Goal=goal)[0], other)[0] - before
        row[title + ": mean change"] = f"{change[:limit].mean():+.5f}"
        row[title + ": least change / s.e."] = f"{(change / error)[:limit].min():+.2f}"
    row["mean of halves"] = peak_ratio(mean, truth)
    row["Gauss"] = max(peak_ratio(ndimage.gaussian_filter(mean, width), truth)
                       for width in numpy.geomspace(0.3, 4, 18))
    for goal, title in enumerate(("surfaces", "volumes")):
        row["from halves, " + title] = peak_ratio(half_maps_denoised(one, other, goal), truth)
    row["Denoise Map, volumes"] = peak_ratio(denoised(mean, Goal=1)[0], truth)
    return row


def print_row(row, first):
    if first:
        print("| " + " | ".join(row) + " |\n" + "|---" * len(row) + "|")
    print("| " + " | ".join(cell(value) for value in row.values()) + " |", flush=True)


def picture(data, path):
    """GroEL at one level: the map, the map with noise of the same strength, and the latter denoised with the
    defaults."""
    truth = public_map(data, "emd_5043.map", 100)
    noisy = (truth + truth.std() * noise_of(truth.shape, 0, 1)).astype(numpy.float32).astype(float)
    smooth, _ = denoised(noisy)
    level = truth.mean() + 2.0 * truth.std()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(1200, 440)
    for column, (name, volume) in enumerate((("map", truth), ("noise added", noisy), ("denoised", smooth))):
        contour = vtkFlyingEdges3D()
        contour.SetInputData(image_of(volume))
        contour.SetValue(0, level)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(contour.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.62, 0.72, 0.86)
        words = name if volume is truth else f"{name}: {peak_ratio(volume, truth):.1f} dB"
        label = vtkTextActor()
        label.SetInput(words)
        label.GetTextProperty().SetColor(0.1, 0.1, 0.12)
        label.GetTextProperty().SetFontSize(22)
        label.SetPosition(12, 10)
        renderer = vtkRenderer()
        renderer.SetViewport(column / 3, 0, (column + 1) / 3, 1)
        renderer.SetBackground(1, 1, 1)
        renderer.AddActor(actor)
        renderer.AddViewProp(label)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(49.5, 49.5, 49.5)
        camera.SetPosition(49.5, 49.5, 300)
        camera.SetViewAngle(20)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def cell(value):
    return value if isinstance(value, str) else f"{value:.2f}"


def summary(rows, title):
    lead = numpy.array([row["lead"] for row in rows])
    behind = numpy.array([row["oracle"] - row["volumes"] for row in rows])
    white = [row for row in rows if row["corr."] == 0]
    close = [abs(row["estimated gain"] - row["true gain"]) <= max(0.3, 2 * row["its s.e."]) for row in white]
    lost = [row["known"] - row["volumes"] for row in white]
    print(f"\n{title}: {len(rows)} rows. Lead over the best tuned rival: at least 0 in "
          f"{(lead >= 0).mean():.0%}, least {lead.min():+.2f}, mean {lead.mean():+.2f} dB.")
    if not numpy.isnan(behind).all():
        print(f"Below the best of the family: mean {numpy.nanmean(behind):+.2f}, most {numpy.nanmax(behind):+.2f} dB.")
    if white:
        print(f"White noise: estimated gain right within 0.3 dB or two standard errors in {numpy.mean(close):.0%}; "
              f"lost by estimating the noise: {numpy.mean(lost):+.2f} dB on average.")


def print_leads(rows):
    """The table of the guide's page: the lead over the best tuned rival, in dB."""
    noises = [noise for noise in ROWS if any((row["noise"], row["corr."]) == noise for row in rows)]
    print("\n| volume | " + " | ".join(f"{level:g}" + (f", {length:g} voxels" if length else ", white")
                                     for level, length in noises) + " |\n" + "|---" * (len(noises) + 1) + "|")
    leads = {(row["volume"], row["noise"], row["corr."]): row["lead"] for row in rows}
    for name in sorted(dict.fromkeys(row["volume"] for row in rows), key=lambda name: name not in ASIDE):
        print(f"| {name}{' (held out)' if name in ASIDE else ''} | "
              + " | ".join(f"{leads[(name, *noise)]:+.1f}" for noise in noises) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path)
    parser.add_argument("--volumes", nargs="*", help="only these")
    parser.add_argument("--rows", type=int, default=len(ROWS), help="only the first of the noises")
    parser.add_argument("--slow", choices=("none", "one", "all"), default="none",
                        help="non-local means, BM4D and the family's oracle, for which rows")
    parser.add_argument("--halves", action="store_true", help="only simulated pairs of half maps, of noise 0.5")
    parser.add_argument("--picture", type=Path, help="write only the picture of Filters/Imaging/README.md, to this file")
    options = parser.parse_args()
    if options.picture:
        picture(options.data, options.picture)
        return
    makers = volumes(options.data)
    if options.halves:
        pairs = [(name, level, correlation) for name in options.volumes or makers
                 for level, correlation in ((0.5, 0), (0.5, 1.0))]
        for pair in pairs:
            print_row(judge_halves(pair[0], makers[pair[0]](), *pair[1:]), pair == pairs[0])
        return
    if restoration is None:
        print("skimage is not installed: total variation and wavelets are left out.", file=sys.stderr)
    rows = []
    for name in options.volumes or makers:
        truth = makers[name]()
        for level, correlation in ROWS[: options.rows]:
            row = judge(name, truth, level, correlation, options)
            print_row(row, not rows)
            rows.append(row)
    for title, part in (("Tuned on", [r for r in rows if not r["aside"]]), ("Put aside", [r for r in rows if r["aside"]]),
                        ("White noise", [r for r in rows if r["corr."] == 0]),
                        ("Coloured noise", [r for r in rows if r["corr."] > 0])):
        if part:
            summary(part, title)
    print_leads(rows)


main()
