"""Fullerene Stability in ParaView: molecules from XYZ files, the exact values and the grid's."""

import math

from paraview import servermanager
from paraview.simple import FullereneStability, OpenDataFile

from shared_data import shared_data


def row(table, at=0):
    return {table.GetColumnName(i): table.GetColumn(i).GetValue(at)
            for i in range(table.GetNumberOfColumns())}


reference = {"C20-Ih.xyz": (20, 11, 5.2402), "C60_Ih-ANGS.xyz": (60, 31, 19.410)}
molecules = [OpenDataFile(str(shared_data(f"fullerenes/{name}"))) for name in reference]
stability = FullereneStability(Input=molecules)
stability.UpdatePipeline()
table = servermanager.Fetch(stability, idx=0)
assert table.GetNumberOfRows() == 2, table.GetNumberOfRows()
proxies = []
for at, (atoms, bars, integral) in enumerate(reference.values()):
    values = row(table, at)
    print(values)
    assert values["Atoms"] == atoms and values["Bars"] == bars
    assert abs(values["FilteredIntegral"] - integral) < 6e-4
    assert math.isclose(values["EnergyProxy"], -values["FilteredIntegral"] / atoms, rel_tol=1e-12)
    proxies.append(values["EnergyProxy"])
assert proxies[1] < proxies[0]

bars = servermanager.Fetch(stability, idx=1)
lengths = [bars.GetColumnByName("Death").GetValue(i) - bars.GetColumnByName("Birth").GetValue(i)
           for i in range(bars.GetNumberOfRows())
           if bars.GetColumnByName("Molecule").GetValue(i) == 0
           and bars.GetColumnByName("Dimension").GetValue(i) == 1]
assert abs(sum(lengths) - row(table)["Integral"]) < 1e-9

# The grid of the thesis: below the exact value, and near it.
stability.Method = "Grid"
stability.Spacing = 0.1
stability.UpdatePipeline()
grid = row(servermanager.Fetch(stability, idx=0))
assert grid["Bars"] == 11 and 5.05 < grid["FilteredIntegral"] < 5.2402, grid
