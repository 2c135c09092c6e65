"""Shared code of the scripts of this folder: the data, and the file of a figure."""

import os
import subprocess
import sys
from pathlib import Path

from paraview import simple

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from output_folder import output_folder  # noqa: E402


def data(relative):
    """Opens a file of the shared data: $ISTHMUS_DATA_DIR, otherwise ../shared/data beside the clone."""
    for folder in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), HERE.parents[2] / "shared" / "data")):
        if (Path(folder) / relative).exists():
            return simple.OpenDataFile(str(Path(folder) / relative))
    sys.exit(f"There is no {relative}: set ISTHMUS_DATA_DIR.")


def new_view(width=1000, height=760):
    view = simple.CreateView("RenderView")
    simple.AssignViewToLayout(view)
    view.ViewSize = [width, height]
    return view


def look_from(view, direction, zoom=1.0):
    """Turns the camera, without perspective, so that the scale bar holds everywhere."""
    focus = view.CameraFocalPoint
    view.CameraPosition = [f + 300 * d for f, d in zip(focus, direction)]
    view.CameraViewUp = [0.0, 1.0, 0.0] if abs(direction[1]) < 0.9 else [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    simple.ResetCamera(view)
    simple.GetActiveCamera().Zoom(zoom)


def write(view, name, **options):
    """Writes the figure, 85 mm wide at 300 dpi, into the folder named on the command line, otherwise a temporary one."""
    folder = output_folder(sys.argv[1] if len(sys.argv) > 1 else None)
    png, _ = pipelines.figure(view, 85, 300, str(folder / f"{name}.png"), **options)
    # 128 colours keep a picture small; without ImageMagick it is larger.
    subprocess.run(["convert", png, "-colors", "128", png], check=False)
    print(png)


if {"-h", "--help"} & set(sys.argv[1:]):
    print(sys.modules["__main__"].__doc__)
    sys.exit()
