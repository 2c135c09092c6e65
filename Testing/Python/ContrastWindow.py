"""The button beside Inside Is Higher in the real ParaView: a map whose density is darker than its background, Map
Surface, Apply, and one click. The surface is then that of the map as it was, and the button has gone. For the map as
it was there is no button.

The pictures of the window are kept beside the test's other output.
"""

import os
from pathlib import Path

import numpy
from shared_data import shared_data
from window_play import APPLY, PANEL, complaints, entry, play

MAP = shared_data("maps/emd_1832.map")
INSIDE = PANEL + "InsideIsHigher/"
PAUSE = ("pqClientMainWindow", "pause", "2000")
BUTTON = INSIDE + "UseInvertedContrast"


def checked(state):
    return (INSIDE + "CheckBox", "check checked", state)


def button_is(there):
    return (BUTTON, "check visible", "true" if there else "false")


output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "ContrastWindow"
output.mkdir(parents=True, exist_ok=True)
dark = output / "dark.map"
content = bytearray(MAP.read_bytes())
begin = 1024 + int(numpy.frombuffer(content, dtype="<i4", count=256)[23])
assert numpy.frombuffer(content, dtype="<i4", count=4)[3] == 2, "the map is not of floats"
values = numpy.frombuffer(content, dtype="<f4", offset=begin)
values *= -1
dark.write_bytes(content)

MADE = [entry("Map Surface"), PAUSE, button_is(False), APPLY, PAUSE]
SESSIONS = {"bright": (MAP, MADE + [button_is(False), checked("true")]),
            "dark": (dark, MADE + [button_is(True), checked("true"), (BUTTON, "activate", ""), PAUSE,
                                   checked("false"), button_is(False)])}
for name, (data, events) in SESSIONS.items():
    log, picture = play(name, data, events, (), output / name)
    assert "Success =  true" in log, f"{name}: the session could not be played: {log[-2000:]}"
    warnings = complaints(log)
    suspected = [line for line in log.splitlines() if "seems to be inverted" in line]
    # One warning of the surface that opening a map shows, one of the filter.
    assert len(suspected) == (2 if name == "dark" else 0), f"{name}: {suspected}"
    # The first line of the warning names the class and the line.
    others = [line for line in warnings if "vtkMapSurface" not in line]
    assert not others and len(warnings) <= 2 * len(suspected), f"{name}: {warnings}"
    print(f"{name}: {picture}", flush=True)
