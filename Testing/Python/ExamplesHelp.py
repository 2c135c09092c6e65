"""Every example and study for people runs with PV_PLUGIN_PATH alone and prints its usage; mmCIF files become the
same atoms as PDB files for the programs that read PDB only."""

import os
import subprocess
import sys
from pathlib import Path

from shared_data import shared_data

examples = Path(os.environ["ISTHMUS_EXAMPLES_DIR"])
studies = Path(os.environ["ISTHMUS_STUDIES_DIR"])
environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
scripts = [path for path in sorted([*examples.glob("*.py"), *examples.glob("figures/*.py"), *studies.glob("*.py")])
           if "Usage:" in path.read_text()]
assert len(scripts) >= 8, scripts
for script in scripts:
    done = subprocess.run(["pvpython", str(script), "--help"], env=environment, capture_output=True,
                          text=True, timeout=120)
    assert done.returncode == 0, f"{script.name}: {done.returncode}: {done.stderr}"
    assert "sage" in done.stdout, f"{script.name} --help says {done.stdout!r}"

sys.path.insert(0, str(examples))
import apbs_potential  # noqa: E402

path = shared_data("molecules/1FAS.cif")
lines = list(apbs_potential.atom_lines(path))
assert len(lines) > 400, len(lines)
for line in lines:
    assert line.startswith(("ATOM  ", "HETATM")) and len(line) == 79, repr(line)
    assert all(abs(x) < 1000 for x in apbs_potential.position_of(line))
name, chain, number = apbs_potential.residue_of(lines[0])
assert len(name) == 3 and chain and int(number) == 1, lines[0]
print(f"{len(scripts)} examples tell their usage; {len(lines)} atoms of {path.name}")
