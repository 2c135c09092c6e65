"""1HEW through ParaView's proxies: the best site is the cleft in which the crystal has the sugar."""

import csv
import os
import tempfile

import numpy
from paraview import servermanager, simple

from shared_data import shared_data

with open(shared_data("molecules/1hew.pdb")) as file:
    sugar = numpy.array(
        [
            [float(line[start : start + 8]) for start in (30, 38, 46)]
            for line in file
            if line.startswith("HETATM") and line[17:20] == "NAG"
        ]
    )
assert len(sugar) == 43

atoms = simple.OpenDataFile(str(shared_data("molecules/1hew/1hew.pqr")))
density = simple.MolecularDensity(Input=atoms, Decay=1.2, Spacing=0.6)
contour = simple.Contour(Input=density, ContourBy=["POINTS", "Density"], Isosurfaces=[1.0])
outer = simple.Connectivity(Input=contour, ExtractionMode="Extract Largest Region")
curved = simple.HessianCurvature(Input=density, Surface=simple.ExtractSurface(Input=outer))
potential = simple.OpenDataFile(str(shared_data("molecules/1hew/1hew_potential.dx.gz")))
polarized = simple.PolarizedCurvature(Input=curved, PotentialImage=potential)
sites = simple.BindingSites(Input=polarized)
sites.UpdatePipeline()

table = servermanager.Fetch(sites, idx=1)
rows = [
    {
        table.GetColumnName(c): table.GetValue(r, c).ToDouble()
        for c in range(table.GetNumberOfColumns())
    }
    for r in range(table.GetNumberOfRows())
]
assert len(rows) > 5, len(rows)
assert [row["Rank"] for row in rows] == list(range(1, len(rows) + 1))
scores = [row["Score"] for row in rows]
assert scores == sorted(scores, reverse=True)
best = numpy.array([rows[0][name] for name in ("CenterX", "CenterY", "CenterZ")])
distance = numpy.linalg.norm(sugar - best, axis=1).min()
assert distance <= 4.0, distance
assert rows[0]["MeanPotential"] < 0.0 and rows[0]["SiteClass"] == 4.0  # Glu 35 and Asp 52

surface = servermanager.Fetch(sites, idx=0)
labels = surface.GetPointData().GetArray("BindingSite")
assert labels.GetRange() == (0.0, len(rows))
with tempfile.TemporaryDirectory() as folder:
    path = os.path.join(folder, "sites.csv")
    simple.SaveData(path, simple.OutputPort(sites, 1))
    assert len(list(csv.DictReader(open(path)))) == len(rows)
print(f"the best of {len(rows)} sites is {distance:.1f} angstrom from the sugar")

# With the atoms, sites are pockets: the first is the cleft again, and wants a positive ligand.
protein = simple.OpenDataFile(str(shared_data("molecules/1hew.pdb")))
pockets = simple.BindingSites(Input=polarized, Atoms=protein)
pockets.UpdatePipeline()
ranking = servermanager.Fetch(pockets, idx=1)
first = {
    ranking.GetColumnName(c): ranking.GetValue(0, c).ToDouble()
    for c in range(ranking.GetNumberOfColumns())
}
place = numpy.array([first[name] for name in ("CenterX", "CenterY", "CenterZ")])
distance = numpy.linalg.norm(sugar - place, axis=1).min()
assert distance <= 2.0 and first["SiteClass"] == 4.0 and first["Points"] > 0, (distance, first)
# Its residues are those of the literature: Asp 52 and Glu 35 do the work, Trp 62 and 63 hold the sugar.
names = [ranking.GetColumnName(c) for c in range(ranking.GetNumberOfColumns())]
assert names[:6] == ["Rank", "Score", "SiteClass", "Class", "Residues", "Volume"], names
residues = ranking.GetValueByName(0, "Residues").ToString()
for residue in ("ASP 52", "GLU 35", "TRP 62", "TRP 63"):
    assert residue in residues, (residue, residues)
assert ranking.GetValueByName(0, "Class").ToString() == "for + ligands"
assert 10.0 < first["Volume"] < 2000.0, first["Volume"]  # that water's center can reach
pockets.UsePockets = 0
pockets.UpdatePipeline()
assert servermanager.Fetch(pockets, idx=1).GetNumberOfRows() == len(rows)
weighed = simple.MolecularPockets(Input=protein, Surface=polarized, FindSites=0)
weighed.UpdatePipeline()
means = servermanager.Fetch(weighed, idx=1)
assert abs(means.GetValueByName(0, "MeanPotential").ToDouble() - first["MeanPotential"]) < 1e-12
assert means.GetValueByName(0, "MeanPolarized").ToDouble() > 0.0
