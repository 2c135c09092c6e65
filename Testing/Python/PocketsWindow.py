"""Pockets and pores in the real ParaView, by mouse: a PDB file, one button, and clicks.

ParaView opens shared data and plays Apply and a button of the toolbar (--test-script); then the mouse
clicks on rows of the table, and on a pocket in the view. A script of the session writes down what each
click has chosen. The pictures before and after are kept beside the test's other output.
"""

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy
import window_home
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from window_play import asks_for_apply

PATIENCE = 240  # seconds for one step, on a machine with other things to do
WIDTH, HEIGHT = 1600, 1000
BUTTON = "pqClientMainWindow/Isthmus/1QToolButton%d"


def start(folder, data, button):
    """ParaView with the data, Apply and the button of that place in the toolbar."""
    window_home.prepare(folder)
    events = (("pqClientMainWindow", "pause", "12000"),
              (BUTTON % button, "activate", ""), ("pqClientMainWindow", "pause", "1000"))
    lines = ['  <pqevent object="%s" command="%s" arguments="%s"/>' % event for event in events]
    (folder / "session.xml").write_text(
        '<?xml version="1.0" ?>\n<pqevents>\n' + "\n".join(lines) + "\n</pqevents>\n")
    environment = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder),
                       ISTHMUS_SESSION_DIR=str(folder), ISTHMUS_SESSION_DATA=str(data))
    environment.pop("XDG_CONFIG_HOME", None)
    script = Path(__file__).parent / "pockets_session.py"
    with (folder / "paraview.log").open("w") as sink:
        return subprocess.Popen(
            ["paraview", "--dr", f"--script={script}", f"--test-script={folder / 'session.xml'}",
             f"--test-directory={folder}"],
            env=environment, cwd=folder, stdout=sink, stderr=sink)


def wait(paraview, folder, what, until):
    began = time.monotonic()
    while not until():
        if complaints(folder) or paraview.poll() is not None or time.monotonic() - began > PATIENCE:
            picture(folder / "failed.png")
            log = (folder / "paraview.log").read_text(errors="replace")
            sys.exit(f"{folder.name}: {what} did not happen; {log[-2000:]}")
        time.sleep(0.5)


def fill_screen():
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "ParaView"],
                           capture_output=True, text=True).stdout.split()
    for window in found[-1:]:
        subprocess.run(["xdotool", "windowmove", window, "0", "0", "windowsize", window,
                        str(WIDTH), str(HEIGHT)], capture_output=True)


def picture(path):
    """The whole window, as numbers."""
    subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3]
    return pixels.reshape(HEIGHT, WIDTH, 3)[::-1].astype(int)


def click(x, y, *keys):
    subprocess.run(["xdotool", "mousemove", str(x), str(y)], check=True)
    time.sleep(1.0)
    for key in keys:
        subprocess.run(["xdotool", "key", key], check=True)
        time.sleep(1.0)
    subprocess.run(["xdotool", "click", "1"], check=True)


def chosen(folder):
    path = folder / "chosen.txt"
    return [line.split() for line in path.read_text().splitlines()] if path.exists() else []


def is_coloured(pixels, colour, slack=30):
    return (abs(pixels - numpy.array(colour)) < slack).all(axis=-1)


def has_hue(pixels, colour, within=20, least_chroma=0.35):
    """Pixels of the hue of `colour`, in degrees, whatever the light and what shines through: ParaView 6.1 draws on
    another grey than 5.11 does."""
    def hue_of(rgb):
        red, green, blue = numpy.moveaxis(rgb.astype(float), -1, 0)
        return numpy.arctan2(numpy.sqrt(3) * (green - blue), 2 * red - green - blue)

    largest, smallest = pixels.max(axis=-1), pixels.min(axis=-1)
    away = numpy.angle(numpy.exp(1j * (hue_of(pixels) - hue_of(numpy.array(colour)))), deg=True)
    return (abs(away) < within) & (largest - smallest > least_chroma * largest)


def middle_of(coloured, corner):
    """Place in the window of what has most of these pixels around it; corner: of their picture in the window."""
    size = 16
    rows, columns = (length // size for length in coloured.shape)
    tiles = coloured[:rows * size, :columns * size].reshape(rows, size, columns, size).sum(axis=(1, 3))
    row, column = numpy.unravel_index(numpy.argmax(tiles[:-1, :-1] + tiles[1:, :-1] + tiles[:-1, 1:] + tiles[1:, 1:]),
                                      (rows - 1, columns - 1))
    return corner[0] + int(column + 1) * size, corner[1] + int(row + 1) * size


def complaints(folder):
    return [line for line in (folder / "paraview.log").read_text(errors="replace").splitlines()
            if "ERR|" in line or "WARN|" in line or "rror:" in line or "Traceback" in line or "critical:" in line]


def choose_until(paraview, folder, what, act, number):
    """Acts, again where a busy window did not heed it, until that number has been chosen."""
    count = len(chosen(folder))
    for _ in range(4):
        act()
        for _ in range(20):
            found = chosen(folder)[count:]
            if any(int(line[1]) == number for line in found):
                return int(next(line for line in found if int(line[1]) == number)[2])
            assert paraview.poll() is None, f"{what}: paraview ended"
            time.sleep(0.5)
    sys.exit(f"{what}: {number} was not chosen, but {chosen(folder)}; {complaints(folder)}")


# Places in a window of WIDTH x HEIGHT; the camera is the first look's.
VIEW = (slice(210, 960), slice(360, 1040))
BODIES = (slice(210, 800), slice(360, 1040))  # without the legend
CORNER = (360, 210)
ROW_OF_POCKET_2, EMPTY_PLACE = (1200, 288), (400, 900)
ROW_OF_PORE_4, CHART = (1200, 830), (slice(210, 640), slice(1070, 1590))
VERMILION, BLUE, GREEN, ROW_BLUE, LINE = (
    (213, 94, 0), (0, 114, 178), (0, 158, 115), (48, 140, 198), (77, 175, 74))


def session(name, data, button, play):
    folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "PocketsWindow" / name
    paraview = start(folder, shared_data(data), button)
    try:
        wait(paraview, folder, "the button's work", lambda: (
            fill_screen() or "is finished" in (folder / "paraview.log").read_text(errors="replace")))
        time.sleep(8)  # the window paints after the script
        play(paraview, folder)
        said = complaints(folder)
        assert not said, said
    finally:
        paraview.kill()
        paraview.wait()


def pockets(paraview, folder):
    before = picture(folder / "first.png")
    for colour in (VERMILION, BLUE):
        count = has_hue(before[VIEW], colour).sum()
        assert count > 2000, f"{count} pixels in the colour of a pocket"
    pocket_1, pocket_2 = (middle_of(has_hue(before[BODIES], colour, least_chroma=0.2), CORNER) for colour in (VERMILION, BLUE))

    def in_view(place, key):
        click(*EMPTY_PLACE)
        click(*place, key)

    def row_is_marked():
        return is_coloured(picture(folder / "row.png")[280:310, 1090:1460], ROW_BLUE).sum() > 2000

    second = choose_until(paraview, folder, "a row", lambda: click(*ROW_OF_POCKET_2), 2)
    time.sleep(3)
    wait(paraview, folder, "the mark of the row", row_is_marked)
    after = picture(folder / "row.png")
    changed = (abs(after[VIEW] - before[VIEW]).max(axis=-1) > 60).sum()
    assert changed > 1000, f"only {changed} pixels of the view follow the row"
    first = choose_until(
        paraview, folder, "a pocket in the view", lambda: in_view(pocket_1, "s"), 1)
    time.sleep(3)
    back = picture(folder / "pocket.png")
    assert (abs(back[VIEW] - after[VIEW]).max(axis=-1) > 60).sum() > 1000
    assert not asks_for_apply(back), "Apply is green without an edit"
    choose_until(paraview, folder, "the other pocket", lambda: in_view(pocket_2, "s"), 2)
    print(f"residues of the first pocket: {first} atoms, of the second: {second}; {changed} pixels changed")
    assert min(first, second) > 20 and first != second


def pores(paraview, folder):
    before = picture(folder / "first.png")
    for colour in (GREEN, BLUE):
        count = has_hue(before[VIEW], colour).sum()
        assert count > 2000, f"{count} pixels in the colour of a class of width"
    line = is_coloured(before[CHART], LINE, 20)
    assert line.any(axis=0).sum() > 200, "no line in the chart"
    atoms = choose_until(paraview, folder, "a row", lambda: click(*ROW_OF_PORE_4), 4)
    time.sleep(3)
    after = picture(folder / "row.png")
    moved = (is_coloured(after[CHART], LINE, 20) != line).sum()
    print(f"residues of the fourth pore: {atoms} atoms; {moved} pixels of the chart changed")
    assert moved > 300, "the chart does not follow the row"


SESSIONS = {"pockets": ("molecules/1hew.pdb", 7, pockets), "pores": ("molecules/2kix.pdb", 8, pores)}
for session_name, arguments in SESSIONS.items():
    if len(sys.argv) < 2 or session_name in sys.argv[1:]:
        session(session_name, *arguments)
