"""Molecule Cartoon in ParaView's pipeline: write me."""

from paraview.simple import MoleculeCartoon, Wavelet

result = MoleculeCartoon(Input=Wavelet(), Scalars=["POINTS", "RTData"])
result.UpdatePipeline()
assert "MoleculeCartoon" in result.PointData.keys(), "write me"
