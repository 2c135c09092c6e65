"""Random actions by mouse and keys in the real ParaView: buttons, clicks, undo, delete, reset, states, files, Escape. By hand:

    xvfb-run -a -s "-screen 0 1600x1000x24" pvpython Testing/Python/random_play.py FOLDER ACTIONS SEED...

For each seed FOLDER has the actions, the log with ParaView's own stack of calls where it ends (--enable-bt), and the last
picture. The same seed gives the same actions; how far the program is with each of them depends on the machine. One line
for each seed: played, ended or frozen, and after which action. A window that does not open the dialog of Ctrl+O within
FREEZE seconds is frozen.
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import window_home
from shared_data import shared_data
from window_play import PANELS, STATUS_BAR, place_of, place_of_button, widen

FILES = ("maps/emd_1832.map", "molecules/1hew.pdb", "surfaces/torus.obj", "surfaces/sphere.off", "molecules/1ubq.pdb",
         "molecules/channels/1grm_hole_example.pdb", "maps/1ake.mrc")
FREEZE = 240  # seconds, for a window that computes
BUTTONS = 13  # of the toolbar
# In a window of 1600 x 1000
BROWSER, PANEL, VIEWS = (10, 180, PANELS - 10, 420), (10, 480, PANELS - 10, 950), (PANELS + 10, 190, 1590, 950)


def xdotool(*arguments):
    subprocess.run(["xdotool", *map(str, arguments)], capture_output=True, timeout=60)


def within(box, draw):
    return draw.randint(box[0], box[2]), draw.randint(box[1], box[3])


def keyboard():
    xdotool("mousemove", *STATUS_BAR, "click", 1)


def in_dialog(title, path):
    """Types a path into a dialog of files, if that has opened."""
    began = time.monotonic()
    while time.monotonic() - began < 8:
        if place_of(title):
            time.sleep(0.5)
            xdotool("type", "--delay", 15, path)
            time.sleep(0.5)
            xdotool("key", "Return")
            time.sleep(1.5)
            xdotool("key", "Return")  # of a second question
            return
        time.sleep(0.5)


class Play:
    def __init__(self, folder, seed):
        self.draw, self.folder, self.done = random.Random(seed), folder, []
        window_home.prepare(folder)
        environment = dict(os.environ, HOME=str(folder), XDG_RUNTIME_DIR=str(folder))
        environment.pop("XDG_CONFIG_HOME", None)
        with (folder / "paraview.log").open("w") as sink:
            self.paraview = subprocess.Popen(["paraview", "--dr", "--enable-bt"], env=environment, cwd=folder, stdout=sink,
                                             stderr=sink)
        self.kinds = [(8, self.button), (6, self.open_file), (5, self.browser), (4, self.view), (3, self.undo), (2, self.redo),
                      (3, self.delete), (1, self.reset), (2, self.save), (2, self.load), (5, self.escape), (4, self.twice),
                      (3, self.panel), (3, self.apply), (3, self.wheel), (2, self.drag)]

    def button(self):
        number = self.draw.randrange(BUTTONS)
        xdotool("mousemove", *place_of_button(number), "sleep", 0.3, "click", 1)
        return number

    def open_file(self):
        name = self.draw.choice(FILES)
        keyboard()
        xdotool("key", "ctrl+o")
        in_dialog("Open File", shared_data(name))
        xdotool("key", "alt+a")
        return name

    def browser(self):
        place = within(BROWSER, self.draw)
        xdotool("mousemove", *place, "click", 1)
        return place

    def view(self):
        place = within(VIEWS, self.draw)
        xdotool("mousemove", *place, "click", 1)
        if self.draw.random() < 0.4:
            xdotool("key", "s")
        return place

    def undo(self):
        keyboard()
        for _ in range(self.draw.randint(1, 4)):
            xdotool("key", "ctrl+z")

    def redo(self):
        keyboard()
        for _ in range(self.draw.randint(1, 3)):
            xdotool("key", "ctrl+shift+z")

    def delete(self):
        place = within(BROWSER, self.draw)
        xdotool("mousemove", *place, "click", 1, "sleep", 0.3, "key", "Delete")
        return place

    def reset(self):
        keyboard()
        xdotool("key", "alt+e", "sleep", 0.5, "key", "Up", "key", "Escape")
        xdotool("key", "ctrl+r")
        time.sleep(1)
        xdotool("key", "Return")

    def save(self):
        keyboard()
        xdotool("key", "ctrl+s")
        in_dialog("Save State", self.folder / "random.pvsm")

    def load(self):
        if (self.folder / "random.pvsm").exists():
            keyboard()
            xdotool("key", "alt+f", "sleep", 0.5, "key", "l")
            in_dialog("Load State", self.folder / "random.pvsm")

    def escape(self):
        for _ in range(self.draw.randint(1, 3)):
            xdotool("key", "Escape")

    def twice(self):
        place = within(self.draw.choice((BROWSER, PANEL, VIEWS)), self.draw)
        xdotool("mousemove", *place, "click", "--repeat", 2, "--delay", 60, 1)
        return place

    def panel(self):
        place = within(PANEL, self.draw)
        xdotool("mousemove", *place, "click", 1)
        if self.draw.random() < 0.5:  # out of a list that may have opened
            xdotool("sleep", 0.4, "key", "Escape")
        return place

    def apply(self):
        keyboard()
        xdotool("key", "alt+a")

    def wheel(self):
        place = within(self.draw.choice((PANEL, VIEWS)), self.draw)
        xdotool("mousemove", *place, "click", "--repeat", 3, self.draw.choice((4, 5)))
        return place

    def drag(self):
        start, end = within(VIEWS, self.draw), within(VIEWS, self.draw)
        xdotool("mousemove", *start, "mousedown", 1, "sleep", 0.2, "mousemove", *end, "sleep", 0.2, "mouseup", 1)
        return start, end

    def ended(self):
        return self.paraview.poll() is not None

    def is_frozen(self):
        """Whether the window opens its dialog of files no more."""
        began = time.monotonic()
        while time.monotonic() - began < FREEZE and not self.ended():
            xdotool("key", "Escape")
            keyboard()
            xdotool("key", "ctrl+o")
            time.sleep(3)
            if place_of("Open File"):
                xdotool("key", "Escape")
                return False
        return not self.ended()

    def run(self, actions):
        began = time.monotonic()
        while not place_of("ParaView") and time.monotonic() - began < 60:
            time.sleep(1)
        time.sleep(4)
        widen()
        acts = [act for weight, act in self.kinds for _ in range(weight)]
        with (self.folder / "actions.txt").open("w") as file:
            for number in range(actions):
                act = self.open_file if number == 0 else self.draw.choice(acts)
                what = act()
                print(number, act.__name__, what, file=file, flush=True)
                time.sleep(self.draw.choice((0.2, 0.5, 1.0, 3.0)))
                if self.ended():
                    return f"ended with {self.paraview.returncode} after action {number} ({act.__name__})"
                if number % 50 == 49 and self.is_frozen():
                    return f"frozen after action {number} ({act.__name__})"
        if self.is_frozen():
            return "frozen at the end"
        return "played" if not self.ended() else f"ended with {self.paraview.returncode} at the end"

    def close(self):
        subprocess.run(["import", "-window", "root", str(self.folder / "last.png")], capture_output=True, timeout=60)
        if not self.ended():
            self.paraview.send_signal(signal.SIGKILL)
        self.paraview.wait()


if __name__ == "__main__":
    base, count = Path(sys.argv[1]), int(sys.argv[2])
    failures = 0
    for seed in map(int, sys.argv[3:]):
        shutil.rmtree(base / f"seed_{seed}", ignore_errors=True)
        (base / f"seed_{seed}").mkdir(parents=True)
        play = Play(base / f"seed_{seed}", seed)
        outcome = "failed"
        try:
            outcome = play.run(count)
        finally:
            play.close()
        failures += outcome != "played"
        print(f"seed {seed}: {outcome}", flush=True)
    sys.exit(int(failures > 0))
