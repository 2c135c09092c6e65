"""Filters of whole surfaces on 1, 2, 3 and 4 ranks: what one rank says, or a sentence.

The contour of a volume in pieces, bare and with ghost cells, which are not to be counted twice.
"""

import json
import os
import subprocess
import tempfile
from pathlib import Path

MEASURED = ("Area", "Volume", "Genus", "OpenEdges", "Components", "EulerCharacteristic")


def run_on(ranks, folder):
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), "pvbatch", "--sym",
                    str(Path(__file__).parent / "rank_surfaces.py"), str(folder)],
                   check=True, timeout=180, env=environment)
    return [json.loads((folder / f"{ranks}.{rank}.json").read_text()) for rank in range(ranks)]


def near(a, b):
    return abs(a - b) <= 1e-9 * max(abs(a), abs(b), 1e-300)


with tempfile.TemporaryDirectory() as made:
    whole = run_on(1, Path(made))[0]
    for name, one in whole.items():
        assert not one["errors"], (name, one["errors"])
        assert one["points"] > 0, name
    refused = set()
    for ranks in (2, 3, 4):
        parts = run_on(ranks, Path(made))
        for name, one in whole.items():
            mine = [part[name] for part in parts]
            sentences = [sentence for part in mine for sentence in part["errors"]]
            if sentences:
                assert all("rank" in sentence for sentence in sentences), (name, sentences)
                assert not any(part["area"] for part in mine), name
                refused.add(name)
                continue
            if name.startswith("SurfaceMeasures"):
                tables = [part["table"] for part in mine if part["table"]]
                assert len(tables) == 1, (name, ranks, tables)
                for column in MEASURED:
                    if column in one["table"]:
                        assert near(tables[0][column], one["table"][column]), (
                            name, ranks, column, tables[0][column], one["table"][column])
                continue
            if name.startswith("MeshQualityReport"):
                # Ghosts are measured, and not counted: the line and the table are of the whole.
                tables = [part["quality"] for part in mine if part["quality"]]
                assert tables == [one["quality"]], (name, ranks, tables, one["quality"])
                continue
            assert near(sum(part["area"] for part in mine), one["area"]) or (
                # Remeshing starts at another triangle; the surface is the same.
                name.startswith("SurfaceRemesh")
                and abs(sum(part["area"] for part in mine) / one["area"] - 1) < 0.01), (
                    name, ranks, [part["area"] for part in mine], one["area"])
            if one["inside"]:
                # Pieces of an image share a layer of nodes.
                assert sum(part["inside"] for part in mine) >= one["inside"], (name, ranks)
    print("refused with a sentence:", sorted(refused))
    assert refused <= {"SurfaceToGrid, pieces", "SurfaceToGrid, ghosts", "SurfaceMeasures, volume"}
