"""Super time stepping against forward Euler: the same end time, how far apart and how much faster.

Order 1 with edge stopping under a Gaussian of 1 voxel, on two phantoms and a map with noise, each of
standard deviation 1 before the noise; larger volumes and longer times take turns (long_tests.py).
"""

import time

import isthmus

from long_tests import share
from shared_data import shared_data
from volume_quality import as_volume, filtered, phantom, with_noise

EULER, SUPER = 0, 1


def center(volume, nodes):
    """The middle of a volume, in units of its standard deviation."""
    box = tuple(slice((n - nodes) // 2, (n + nodes) // 2) for n in volume.shape)
    return volume[box] / volume[box].std()


def volumes(nodes):
    for seed in (2, 3):
        yield f"phantom {seed}, SNR 1", with_noise(center(phantom(seed), nodes), 1.0, seed)
        yield f"phantom {seed}, SNR 0.3", with_noise(center(phantom(seed), nodes), 0.3, seed)
    reader = isthmus.vtkMRCMapReader()
    reader.SetFileName(str(shared_data("maps/emd_5043.map")))
    reader.Update()
    yield "EMD-5043, SNR 1", with_noise(center(as_volume(reader.GetOutput()), nodes), 1.0, 7)


def evolve(volume, integrator, sigma, end):
    """Result and seconds."""
    algorithm = isthmus.vtkHighOrderDiffusion()
    algorithm.SetOrder(1)
    algorithm.SetPreSmoothing(1.0)
    algorithm.SetSigma(sigma)
    algorithm.SetTime(end)
    algorithm.SetIntegrator(integrator)
    start = time.perf_counter()
    return filtered(algorithm, volume), time.perf_counter() - start


def compare(nodes, edges, sigma, end):
    for name, volume in volumes(nodes):
        (slow, slow_seconds), (fast, fast_seconds) = (
            evolve(volume, integrator, sigma, end) for integrator in (EULER, SUPER))
        difference = (fast - slow).std() / slow.std()
        print(f"{name:20s} {nodes}^3, {edges} edges, time {end:2d}: difference "
              f"{100 * difference:.2f} %, {slow_seconds / fast_seconds:.1f} times as fast")
        assert difference < 0.01


compare(32, "sharp", 0.3, 10)
for case in share([(48, edges, sigma, end) for edges, sigma in (("sharp", 0.3), ("mild", 1.0))
                   for end in (5, 20, 60)], 6):
    compare(*case)
