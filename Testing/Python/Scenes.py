"""Examples/scenes.py: each page opens in headless Chromium without a network, shows the colours that it should,
turns when the mouse drags it, and comes back by its button.

Skipped where Chromium or three.js is not installed.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy
from shared_data import shared_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
import scenes  # noqa: E402

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
SIZE = (700, 500)
# Sent by the page itself, a second after it was drawn, as a mouse would: down, across, up.
DRAG = """
const canvas = document.querySelector("canvas");
const send = (type, x, on) => on.dispatchEvent(new MouseEvent(type,
  {clientX: x, clientY: 250, button: 0, buttons: 1, bubbles: true}));
send("mousedown", 250, canvas);
send("mousemove", 330, document);
send("mousemove", 410, document);
send("mouseup", 410, document);
"""
# What is drawn by then stays: the browser resizes the page before it takes the picture.
HOLD = "renderer.render = renderer.setSize = () => {};"
RESET = 'document.getElementById("reset").click();'
# The share of the pixels, at least, that a scene shows in each of these colours.
COLOURS = {
    "loops": {"orange": 0.002, "grey": 0.05},
    "curvature": {"red": 0.01, "blue": 0.01},
    "sites": {"orange": 0.002, "grey": 0.05},
    "pockets": {"orange": 0.002, "grey": 0.02},
    "pore": {"green": 0.005, "blue": 0.005},
}


def picture(page, script=""):
    """What the browser shows of a page, as height x width x 3, after `script`."""
    copy = page.with_name(f"{page.stem}_shown.html")
    text = page.read_text()
    assert "</body>" in text
    copy.write_text(text.replace("</body>", f"<script>setTimeout(() => {{{script}{HOLD}}}, 1000);</script></body>"))
    shot = page.with_suffix(".png")
    shot.unlink(missing_ok=True)
    home = page.parent / "home"
    done = subprocess.run(
        [BROWSER, "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--proxy-server=127.0.0.1:9", f"--user-data-dir={home}",
         "--window-size={},{}".format(*SIZE), "--virtual-time-budget=5000", f"--screenshot={shot}",
         copy.as_uri()],
        env=dict(os.environ, HOME=str(page.parent)), capture_output=True, text=True, timeout=180, check=False)
    assert shot.exists(), f"{page.name}: no picture: {done.stderr[-2000:]}"
    reader = vtkPNGReader()
    reader.SetFileName(str(shot))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].reshape(height, width, 3)
    return pixels[:int(0.78 * height)].astype(int)  # row 0 is below: without the words and the button


def shares(pixels):
    red, green, blue = numpy.moveaxis(pixels, 2, 0)
    spread = pixels.max(axis=2) - pixels.min(axis=2)
    masks = {"red": (red > green + 40) & (red > blue + 40) & (green < blue + 40),
             "orange": (red > green + 40) & (green > blue + 20),
             "green": (green > red + 40) & (green > blue + 15),
             "blue": (blue > red + 40),
             "grey": (spread < 30) & (red < 252)}
    return {name: mask.mean() for name, mask in masks.items()}


def differing(one, other):
    return (numpy.abs(one - other).max(axis=2) > 12).mean()


folder = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "Scenes"
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
if BROWSER is None or not scenes.THREE.is_dir():
    print("needs Chromium and three.js (Debian: chromium, libjs-three)")
    sys.exit(77)
os.environ["ISTHMUS_DATA_DIR"] = str(shared_data("maps/emd_1832.map").parents[1])
scenes.main(folder, [])
assert set(COLOURS) == set(scenes.SCENES)
for name, expected in COLOURS.items():
    page = folder / f"{name}.html"
    first = picture(page)
    found = shares(first)
    assert all(found[colour] >= least for colour, least in expected.items()), (name, found)
    turned = picture(page, DRAG)
    assert differing(first, turned) > 0.03, (name, "does not turn", differing(first, turned))
    assert shares(turned)["grey"] + sum(shares(turned).values()) > 0.02, (name, "is gone after turning")
    back = picture(page, DRAG + RESET)
    assert differing(first, back) < 0.002, (name, "does not come back", differing(first, back))
    print(name, {colour: round(float(found[colour]), 4) for colour in expected}, differing(first, turned))
