"""What other readers make of a map: gemmi where it can, mrcfile (permissive) where gemmi refuses.

Neither gives all: gemmi 0.5.7 ignores ORIGIN and repairs nothing, mrcfile leaves file axes as they
are. Here the header's words, as gemmi or mrcfile give them, are put together to x, y, z arrays.
"""

import bz2
import tempfile
import warnings

import gemmi
import mrcfile
import numpy


class Reference:
    """One map: `values` (x, y, z order), `spacing`, `origin` of node 0, `cell`, `grid` of gemmi."""

    def __init__(self, path):
        with tempfile.NamedTemporaryFile(suffix=".map") as plain:
            self.path = str(path)
            if self.path.endswith(".bz2"):  # gemmi has no bzip2
                plain.write(bz2.decompress(path.read_bytes()))
                plain.flush()
                self.path = plain.name
            try:
                self._with_gemmi()
            except (RuntimeError, ValueError):
                self._with_mrcfile()

    def _with_gemmi(self):
        self.by = "gemmi"
        ccp4 = gemmi.read_ccp4_map(self.path)
        values = numpy.array(ccp4.grid, copy=True)
        self._arrange(values, [ccp4.header_i32(word) for word in range(1, 25)],
                      [ccp4.header_float(word) for word in range(1, 53)])
        ccp4.setup(float("nan"), gemmi.MapSetup.NoSymmetry)
        self.grid = ccp4.grid

    def _with_mrcfile(self):
        self.by = "mrcfile"
        self.grid = None
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with mrcfile.open(self.path, permissive=True) as file:
                values = numpy.array(file.data).transpose(2, 1, 0)
                raw = file.header.tobytes()
                kind = file.header.nx.dtype.byteorder.replace("=", "<")
        self._arrange(values, numpy.frombuffer(raw, kind + "i4"), numpy.frombuffer(raw, kind + "f4"))

    def _arrange(self, values, ints, floats):
        order = list(ints[16:19])
        self.order = order if sorted(order) == [1, 2, 3] else [1, 2, 3]
        axes = [self.order.index(axis) for axis in (1, 2, 3)]
        self.values = values.transpose(axes)
        self.sampling = numpy.array(ints[7:10])
        self.start = numpy.array(ints[4:7])[axes]
        self.lengths = numpy.array(floats[10:13], float)
        self.angles = numpy.array(floats[13:16], float)
        self.orthogonal = bool(numpy.all(numpy.abs(self.angles - 90) <= 0.01))
        self.stated_origin = numpy.array(floats[49:52], float)
        good = (self.lengths > 0) & (self.sampling > 0)
        self.spacing = numpy.where(good, self.lengths / numpy.where(good, self.sampling, 1), 1.0)
        self.cell = gemmi.UnitCell(*numpy.where(good, self.lengths, self.sampling), *self.angles)
        self.origin = self.stated_origin if self.stated_origin.any() else self.node(0, 0, 0)

    def node(self, i, j, k):
        """Position of node i, j, k by NSTART alone, as gemmi has it."""
        fraction = (self.start + (i, j, k)) / self.sampling
        return numpy.array(self.cell.orthogonalize(gemmi.Fractional(*fraction)).tolist())

    def shift(self):
        """What ORIGIN adds to gemmi's positions."""
        return self.origin - self.node(0, 0, 0)

    def interpolated(self, position):
        """Gemmi's trilinear interpolation in the cell, NaN where the file has no values."""
        return self.grid.interpolate_value(gemmi.Position(*position))
