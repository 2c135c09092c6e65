"""Examples/binding_sites.py on 1HEW, its potential by our solver: table, picture, and the cleft first;
without pdb2pqr, which gives the charges, from a potential in a file.

It takes turns (turns.tsv), since BindingSites.py has the same pipeline.
"""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from shared_data import shared_data

protein = shared_data("molecules/1hew.pdb")
potential = shared_data("molecules/1hew/1hew_potential.dx.gz")
script = Path(os.environ["ISTHMUS_EXAMPLES_DIR"]) / "binding_sites.py"
with tempfile.TemporaryDirectory() as folder:
    charges = shutil.which("pdb2pqr") or shutil.which("pdb2pqr30")
    given = [] if charges else [str(potential)]
    command = ["pvpython", str(script), str(protein), *given, "--output", folder]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "Ligand: NAG, 43 heavy atoms." in done.stdout
    best = next(line for line in done.stdout.splitlines() if line.split()[:1] == ["1"])
    assert float(best.split()[-1]) <= 4.0, done.stdout
    with open(Path(folder) / "1hew_sites.csv") as file:
        assert len(list(csv.DictReader(file))) >= 2  # its pockets
    assert (Path(folder) / "1hew_sites.png").stat().st_size > 20000
    # A ligand that is not there is a sentence, not a traceback.
    command += ["--ligand", "XYZ"]
    wrong = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert wrong.returncode != 0 and "has no residue XYZ" in wrong.stdout + wrong.stderr
    assert "Traceback" not in wrong.stderr
print("the example finds the cleft")
