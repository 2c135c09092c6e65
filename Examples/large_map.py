"""Denoises a map larger than memory, block by block, and contours the result.

Usage: pvpython large_map.py MAP OUTPUT.mrc [--level LEVEL] [--memory GB] [--strength 0..1]

MAP is read, denoised by High-Order Diffusion and written as OUTPUT.mrc (floats, any size) with at most
--memory GB resident (default 2.5). The parameters are chosen once, from the block in the middle of the map, where
there is signal and noise, and are used for every block. With --level the surface of the result is written as well,
with one file per block in the folder OUTPUT_surface, and OUTPUT_surface.vtm to open them all.

A block is read with a margin, which is discarded afterwards. The influence of a node at a distance r is the part of
a Gaussian of variance 2 Time that lies beyond r (edge stopping only reduces it), and the Gaussians of PreSmoothing
and ResidualSmoothing add to the range. The margin is therefore MARGIN standard deviations of all three combined,
and the result equals that of a single piece to a few millionths of the map's deviation.

After an interruption (power failure, queue limit, Ctrl-C), the same command resumes the work: OUTPUT.mrc.blocks
lists the finished blocks. A compressed map is unpacked once; later blocks continue from places that are remembered then.
"""

import argparse
import json
import math
import resource
import sys
import time
from pathlib import Path

import find_isthmus  # noqa: F401
import isthmus
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLWriter

try:
    import mrcfile
except ImportError:
    sys.exit("large_map.py writes MRC files by the Python package mrcfile: apt install python3-mrcfile.")

MARGIN = 5.0  # standard deviations: 6e-7 of a Gaussian lie beyond
STENCIL = 3  # nodes that one evaluation looks at on each side: Gaussian, gradient, mean of the coefficient
PROGRAM = 0.4  # GB used by pvpython and its libraries
BYTES_A_NODE = 4 * 9  # the block, its result and the six volumes of vtkHighOrderDiffusion, and one in reserve


class Blocks:
    """Divides a grid of nodes x, y, z along z and y (rows are not divided) so that a block with its margin has at
    most `most` nodes, with as little overlap as possible."""

    def __init__(self, size, margin, most):
        best = None
        for parts_y in range(1, size[1] + 1):
            height = min(math.ceil(size[1] / parts_y) + 2 * margin, size[1])
            depth = min(most // (size[0] * height), size[2])
            core = size[2] if depth == size[2] else depth - 2 * margin
            if core < 1:
                continue
            parts_z = math.ceil(size[2] / core)
            work = parts_y * height * parts_z * min(math.ceil(size[2] / parts_z) + 2 * margin, size[2])
            if best is None or work < best[0]:
                best = work, parts_y, parts_z
        if best is None:
            sys.exit(f"Memory does not suffice for a row of {size[0]} nodes with a margin of {margin}: increase --memory.")
        self.size, self.margin = size, margin
        self.parts = best[1:]

    def __len__(self):
        return self.parts[0] * self.parts[1]

    def core(self, number):
        """First and last node along x, y, z of a block without its margin."""
        extent = [0, self.size[0] - 1]
        for axis, parts, part in ((1, self.parts[0], number % self.parts[0]),
                                  (2, self.parts[1], number // self.parts[0])):
            extent += [self.size[axis] * part // parts, self.size[axis] * (part + 1) // parts - 1]
        return extent

    def grown(self, number, margin):
        core = self.core(number)
        return [bound for axis in range(3) for bound in
                (max(core[2 * axis] - margin, 0), min(core[2 * axis + 1] + margin, self.size[axis] - 1))]


def made(vtk_class, **properties):
    """An instance with these properties: VTK 9.2 has no such constructor."""
    instance = vtk_class()
    for name, value in properties.items():
        getattr(instance, "Set" + name)(value)
    return instance


class Map:
    """A map on disk, read by extents."""

    def __init__(self, path):
        self.reader = made(isthmus.vtkMRCMapReader, FileName=str(path))
        self.reader.UpdateInformation()
        information = self.reader.GetOutputInformation(0)
        extent = information.Get(self.reader.GetExecutive().WHOLE_EXTENT())
        self.size = [extent[2 * axis + 1] + 1 for axis in range(3)] if extent else [0, 0, 0]
        if min(self.size) < 1:
            sys.exit(f"{path} is not a map that can be read.")

    def read(self, extent):
        self.reader.Modified()  # else a larger extent read before would be kept
        self.reader.UpdateExtent(extent)
        image = self.reader.GetOutput()
        if image.GetNumberOfPoints() == 0:
            sys.exit(f"{self.reader.GetFileName()}: nodes {extent} could not be read.")
        return image


def middle(size, most):
    """The extent in the middle of a map with at most `most` nodes and the map's proportions."""
    part = min(1.0, (most / math.prod(size)) ** (1 / 3))
    return [bound for nodes in size for bound in
            ((nodes - int(nodes * part)) // 2, (nodes + int(nodes * part)) // 2 - 1)]


def number(image, name):
    return image.GetFieldData().GetArray(name).GetValue(0)


def choose(source, strength, most):
    """Parameters of High-Order Diffusion of order 0 for the map, from the noise that Denoise Map finds in the block in
    its middle. Not the equation that Denoise Map chooses: higher orders have too long a range for blocks.

    The powers and factors were fitted to the best parameters for a phantom with white noise, of signal-to-noise ratios
    (of variances) 1, 0.3 and 0.1."""
    block = source.read(middle(source.size, most))
    deviation = float(vtk_to_numpy(block.GetPointData().GetScalars()).std())
    automatic = made(isthmus.vtkDenoiseMap, Strength=strength)
    automatic.SetInputData(block)
    automatic.Update()
    if automatic.GetOutput().GetNumberOfPoints() == 0:
        sys.exit("The block in the middle of the map could not be denoised.")
    noise = number(automatic.GetOutput(), "NoiseLevel")
    if noise == 0.0:
        sys.exit("No noise was found in the block in the middle of the map.")
    signal = math.sqrt(max(deviation ** 2 - noise ** 2, 1e-3 * deviation ** 2))
    ratio = noise / signal
    length = 1.26 * min(ratio, 10.0) ** 0.35 * 2 ** (strength - 0.5)
    return {"Sigma": 0.32 * signal, "PreSmoothing": min(max(0.9 * ratio ** 0.25, 0.5), 3.0),
            "ResidualSmoothing": 1.45 * length, "Time": (1.6 * length) ** 2}


def denoised(source, extent, parameters):
    diffusion = made(isthmus.vtkHighOrderDiffusion, **parameters)
    diffusion.SetInputData(source.read(extent))
    diffusion.Update()
    return diffusion.GetOutput()


def values(image, extent):
    """The scalars of `image` within `extent`, indexed z, y, x."""
    whole = image.GetExtent()
    array = vtk_to_numpy(image.GetPointData().GetScalars())
    array = array.reshape([whole[2 * axis + 1] - whole[2 * axis] + 1 for axis in (2, 1, 0)])
    return array[tuple(slice(extent[2 * axis] - whole[2 * axis], extent[2 * axis + 1] - whole[2 * axis] + 1)
                       for axis in (2, 1, 0))]


class Done:
    """The finished blocks with their parameters, in a file beside the output."""

    def __init__(self, path, job):
        self.path, self.job = Path(path), job
        self.sums = {}
        if self.path.exists():
            known = json.loads(self.path.read_text())
            if known["job"] != job:
                sys.exit(f"{self.path} is of another map, other parameters or other blocks: remove it to start again.")
            self.sums = {int(block): sums for block, sums in known["sums"].items()}

    def add(self, block, sums):
        self.sums[block] = sums
        fresh = self.path.with_suffix(".new")
        fresh.write_text(json.dumps({"job": self.job, "sums": self.sums}))
        fresh.replace(self.path)


def tell(what, done, all_of_them, started, fresh):
    left = (time.time() - started) / fresh * (all_of_them - done) if fresh else 0.0
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2 ** 20
    print(f"{what}: {done} of {all_of_them} blocks, about {left:.0f} s left, {peak:.2f} GB at most", flush=True)


def write(output, image, extent):
    """Writes the part of a block without its margin to the file; returns its minimum, maximum, sum and sum of
    squares."""
    core = values(image, extent)
    with mrcfile.mmap(output, mode="r+") as file:
        file.data[extent[4]:extent[5] + 1, extent[2]:extent[3] + 1, :] = core
    # A plane at a time, since numpy makes a copy in double.
    sums = [(float(plane.sum(dtype="f8")), float((plane.astype("f8") ** 2).sum())) for plane in core]
    return [float(core.min()), float(core.max()), *(math.fsum(column) for column in zip(*sums))]


def create(output, source):
    """Creates an MRC file of floats for the map's grid, without values."""
    image = source.read([0, 0] * 3)
    shape = tuple(reversed(source.size))
    with mrcfile.new_mmap(output, shape, mrc_mode=2, overwrite=True) as file:
        file.voxel_size = image.GetSpacing()
        file.header.origin = tuple(image.GetOrigin())


def finish(output, source, sums):
    """The header's statistics."""
    least, largest, total, squares = zip(*sums)
    nodes = math.prod(source.size)
    mean = math.fsum(total) / nodes
    with mrcfile.mmap(output, mode="r+") as file:
        file.header.dmin, file.header.dmax, file.header.dmean = min(least), max(largest), mean
        file.header.rms = math.sqrt(max(math.fsum(squares) / nodes - mean * mean, 0.0))


def denoise(path, output, strength, most):
    source = Map(path)
    parameters = choose(source, strength, most)
    reach = math.sqrt(2 * parameters["Time"] + parameters["PreSmoothing"] ** 2 + parameters["ResidualSmoothing"] ** 2)
    margin = math.ceil(MARGIN * reach) + STENCIL  # lengths are in voxels
    blocks = Blocks(source.size, margin, most)
    print(", ".join(f"{name} {value:.4g}" for name, value in parameters.items()), f"margin {margin} nodes", sep=", ")
    stamp = Path(path).stat()
    done = Done(output + ".blocks", [str(path), stamp.st_size, stamp.st_mtime, parameters, margin, list(blocks.parts)])
    if not done.sums:
        create(output, source)
    started, fresh = time.time(), 0
    for block in range(len(blocks)):
        if block not in done.sums:
            image = denoised(source, blocks.grown(block, margin), parameters)
            done.add(block, write(output, image, blocks.core(block)))
            fresh += 1
        tell("denoising", block + 1, len(blocks), started, fresh)
    finish(output, source, done.sums.values())
    done.path.unlink()


def contour(output, level, most):
    """The surface of the map at level; adjacent blocks share a plane of nodes, so there are no gaps."""
    source = Map(output)
    blocks = Blocks(source.size, 1, most)
    folder = Path(output).with_suffix("").with_name(Path(output).stem + "_surface")
    folder.mkdir(exist_ok=True)
    entries, triangles, started = [], 0, time.time()
    for block in range(len(blocks)):
        extent = blocks.core(block)
        for axis in (1, 2):  # one plane of the next block
            extent[2 * axis + 1] = min(extent[2 * axis + 1] + 1, source.size[axis] - 1)
        if min(extent[2 * axis + 1] - extent[2 * axis] for axis in range(3)) < 1:
            continue  # the last plane alone: the block before has it
        edges = made(vtkFlyingEdges3D, ComputeNormals=False, ComputeScalars=False)
        edges.SetInputData(source.read(extent))
        edges.SetValue(0, level)
        edges.Update()
        triangles += edges.GetOutput().GetNumberOfCells()
        piece = folder / f"{block:05}.vtp"
        # Not appended: VTK 9.2 cannot read appended data where libexpat defers parsing (2.6, Debian 12 since deb12u2).
        writer = made(vtkXMLPolyDataWriter, FileName=str(piece), DataMode=vtkXMLWriter.Binary)
        writer.SetInputData(edges.GetOutput())
        writer.Write()
        entries.append(f'    <DataSet index="{block}" file="{folder.name}/{piece.name}"/>')
        tell("contour", block + 1, len(blocks), started, block + 1)
    index = folder.with_suffix(".vtm")
    index.write_text("\n".join(['<VTKFile type="vtkMultiBlockDataSet" version="1.0">', "  <vtkMultiBlockDataSet>",
                                *entries, "  </vtkMultiBlockDataSet>", "</VTKFile>", ""]))
    print(f"{triangles} triangles in {index}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map")
    parser.add_argument("output")
    parser.add_argument("--level", type=float)
    parser.add_argument("--memory", type=float, default=2.5)
    parser.add_argument("--strength", type=float, default=isthmus.vtkDenoiseMap().GetStrength())
    given = parser.parse_args()
    most = int((given.memory - PROGRAM) * 1e9 / BYTES_A_NODE)
    if most < 1:
        sys.exit(f"--memory {given.memory}: pvpython alone takes {PROGRAM} GB.")
    denoise(given.map, given.output, given.strength, most)
    print(f"{given.output}: the denoised map")
    if given.level is not None:
        contour(given.output, given.level, most)


if __name__ == "__main__":
    main()
