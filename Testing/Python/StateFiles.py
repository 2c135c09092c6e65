"""Each state file of Examples/states opens with any data: the example in $ISTHMUS_DATA_DIR, another file by
$ISTHMUS_FILE, and says what to set where there is neither.
"""

import os
import runpy
from pathlib import Path

from paraview import simple
from shared_data import shared_data

states = sorted((Path(os.environ["ISTHMUS_EXAMPLES_DIR"]) / "states").glob("*.py"))
assert len(states) == 6, states
OTHERS = {"map": "maps/EMD-3001.map", "protein": "molecules/1AJJ_pH7_PARSE.pqr",
          "surface": "surfaces/two-tori.obj"}


def load(path):
    """Points shown by the last source of the state."""
    runpy.run_path(str(path))
    source = simple.GetActiveSource()
    points = source.GetDataInformation().GetNumberOfPoints()
    opened = [proxy for proxy in simple.GetSources().values() if proxy.GetProperty("FileName") or
              proxy.GetProperty("FileNames")]
    assert simple.GetRepresentation(source, simple.GetActiveView()).Visibility, path.name
    names = opened[0].GetProperty("FileName") or opened[0].GetProperty("FileNames")
    for proxy in list(simple.GetSources().values()):
        simple.Delete(proxy)
    return points, str(names)


os.environ["ISTHMUS_DATA_DIR"] = str(shared_data("maps").parent)
for path in states:
    os.environ.pop("ISTHMUS_FILE", None)
    points, _ = load(path)
    other = shared_data(OTHERS[path.stem.split("_")[0]])
    os.environ["ISTHMUS_FILE"] = str(other)
    others, opened = load(path)
    assert other.name in opened, (other, opened)
    print(f"{path.name}: {points} points, with {other.name} {others}", flush=True)
    assert points > 100 and others > 20, path.name

os.environ["ISTHMUS_FILE"] = "/no/such/file.map"
try:
    load(states[0])
    raise SystemExit("a file that is not there was opened")
except ValueError as refusal:
    assert "ISTHMUS_DATA_DIR" in str(refusal), refusal
    print(refusal)
