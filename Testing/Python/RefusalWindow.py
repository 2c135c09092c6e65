"""What a button of the real ParaView does with a file that it cannot use: one sentence in the messages, no text of a Python
exception.

The picture of the window is kept beside the test's other output, for people to look at.
"""

import os
from pathlib import Path

from shared_data import shared_data
from window_play import button, complaints, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "RefusalWindow"
SITES = button(4)
PAUSE = ("pqClientMainWindow", "pause", "2000")

log, picture = play("refused", shared_data("maps/emd_1832.map"), [SITES, PAUSE], (), FOLDER / "refused")
said = complaints(log)
print(said, picture)
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert said and all("This needs a molecule with radii: open a PDB, mmCIF or PQR file" in line for line in said), said
assert "File \"" not in log and "<string>" not in log, log[-2000:]
