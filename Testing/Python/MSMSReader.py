"""An MSMS surface opened through ParaView's file dialogue's way, cavities and all."""

from paraview import servermanager, simple

from shared_data import shared_data

source = simple.OpenDataFile(str(shared_data("surfaces/lysozyme_msms/Lys1.vert")))
assert source.GetXMLName() == "MSMSReader", source.GetXMLName()
surface = servermanager.Fetch(source)
assert surface.GetNumberOfCells() == 14398 + 66 + 312 + 70
assert surface.GetCellData().GetArray("Component").GetRange() == (0.0, 3.0)
