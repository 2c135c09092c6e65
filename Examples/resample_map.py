"""A volume on another grid, by trilinear shape functions (thesis 5.17 to 5.20).

Usage: pvpython resample_map.py MAP OUTPUT.vti NX [NY NZ]

It uses ParaView's filter Resample To Image (vtkResampleToImage). Within the volume's bounds (given
as numbers: UseInputBounds shrinks them by 1e-6), node i (from 1) of N along an axis of the N_v nodes of the volume
lies at the volume's

    x_i = (N_v - 1)(i - 1)/(N - 1) + 1                                  (5.17, corrected)

(printed: N_v (i - 1)/N + 1, which never reaches the last node). In the cell below, with x_d the part
of x_i behind the point and xi = 2 x_d - 1, its value is the sum over the cell's eight nodes of

    value * (1 +- xi)(1 +- eta)(1 +- zeta)/8                            (5.18 to 5.20)

which is how VTK's voxel cell interpolates. Where both grids have a node, the value is that of the original.
"""

import sys

from paraview import simple


def resample(volume, nodes):
    """The proxy of `volume` on `nodes` = (nx, ny, nz) nodes over the same bounds."""
    volume.UpdatePipeline()
    bounds = volume.GetDataInformation().GetBounds()
    return simple.ResampleToImage(
        Input=volume, UseInputBounds=0, SamplingBounds=list(bounds), SamplingDimensions=list(nodes))


def main(path, output, *counts):
    if len(counts) not in (1, 3) or not all(count.isdigit() and int(count) > 1 for count in counts):
        sys.exit(__doc__)
    nodes = [int(count) for count in counts]
    volume = simple.OpenDataFile(path)
    volume.UpdatePipeline()
    if volume.GetDataInformation().GetDataSetTypeAsString() != "vtkImageData":
        sys.exit(f"{path} is not a volume that ParaView can read.")
    resampled = resample(volume, nodes * 3 if len(nodes) == 1 else nodes)
    simple.SaveData(output, resampled)
    print(f"{path}: {' x '.join(map(str, resampled.SamplingDimensions))} nodes in {output}")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        print(__doc__)
        sys.exit(not {"-h", "--help"} & set(sys.argv[1:]))
    main(*sys.argv[1:])
