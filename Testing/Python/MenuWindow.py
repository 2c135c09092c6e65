"""The menu Isthmus in the real ParaView, by its submenus: a map, a button and a filter by their tasks. The filter's chart
closes when the filter is deleted, and a second view names the legend as the first one does.
"""

import os
import re
from pathlib import Path

from shared_data import shared_data
from window_play import APPLY, complaints, play

FOLDER = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "MenuWindow"
PANELS = Path(os.environ["ISTHMUS_PANELS_DIR"])
BAR = "pqClientMainWindow/menubar"
DELETE = ("pqClientMainWindow/propertiesDock/propertiesPanel/Delete", "activate", "")
PAUSE = ("pqClientMainWindow", "pause", "2000")


def by_task(task, entry):
    return [(BAR, "activate", "menuIsthmus"), (BAR + "/menuIsthmus", "activate", task),
            (f"{BAR}/menuIsthmus/{task}", "activate", entry)]


# Each filter has a task.
toolbar = (Path(__file__).parents[2] / "Plugin" / "IsthmusToolbar.cxx").read_text()
for panel in PANELS.glob("*.xml"):
    for name, body in re.findall(r'<SourceProxy name="(\w+)"(.*?)</SourceProxy>', panel.read_text(), re.S):
        assert "<ShowInMenu" not in body or f'"{name}"' in toolbar, f"{name} is in no submenu of the menu Isthmus"

log, picture = play(
    "MenuWindow", shared_data("maps/emd_1832.map"),
    [*by_task("Loops_handles_and_persistence", "ScalarPersistence"), APPLY, PAUSE, DELETE, PAUSE,
     *by_task("Curvature", "Isthmus_map_to_curvature"), PAUSE], (), FOLDER,
    script=Path(__file__).parent / "menu_session.py")
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
lines = (FOLDER / "views.txt").read_text().splitlines()
print(*lines, picture, sep="\n")
assert "RenderView XYChartView | " in lines, "no chart was opened"
assert "RenderView | " in lines[lines.index("RenderView XYChartView | "):], "the chart stays without its filter"
assert any(line.endswith("second view: Mean curvature (1/Å)") for line in lines), "a legend without its title"
