"""Writes scenes that can be rotated in a browser: one self-contained page for each.

Usage: pvpython scenes.py [FOLDER [NAME...]]. FOLDER: output folder; default: a temporary folder, which is printed.
NAME: only these (loops, curvature, sites, pockets, pore). Reads the data from $ISTHMUS_DATA_DIR, else from
../shared/data beside the clone. Needs three.js (Debian's libjs-three), which is copied into each page.
"""

import html
import json
import re
import sys
from pathlib import Path

from paraview import simple

sys.path.insert(0, str(Path(__file__).resolve().parent))
import gallery  # noqa: E402
from output_folder import output_folder  # noqa: E402

HERE = Path(__file__).resolve().parent
TEMPLATE = HERE.parent / "Documentation" / "site" / "scene.html"
THREE = Path("/usr/share/javascript/three")
SCRIPTS = ("three.min.js", "examples/js/controls/OrbitControls.js", "examples/js/loaders/GLTFLoader.js")
# name: pipeline, data, direction from which it is seen first, title, caption
SCENES = {
    "loops": ("map_to_loops", "maps/emd_1832.map", (0.0, 0.0, 1.0), "Choking loops of EMD-1832",
              "Handles, tunnels and bottlenecks on the translucent surface."),
    "curvature": ("map_to_curvature", "maps/emd_5170.map", (0.0, -1.0, 0.4), "Mean curvature of EMD-5170",
                  "Red is convex, blue concave."),
    "sites": ("protein_to_sites", "molecules/1hew/1hew.pqr", (0.3, 0.2, -1.0), "Binding sites of lysozyme",
              "1HEW with its charges: the best site is vermilion."),
    "pockets": ("protein_to_pockets", "molecules/1hew.pdb", (0.0, 0.0, 1.0), "Pockets of lysozyme",
                "The three most probable sites of 1HEW, vermilion first."),
    "pore": ("protein_to_pores", "molecules/channels/1grm_hole_example.pdb", (1.0, 0.0, 0.0), "The pore of gramicidin",
             "Red: too narrow for water, green: one water, blue: wider; 1GRM."),
}


def model_of(view, page):
    """The view as a glTF file with embedded data."""
    for shown in view.Representations:
        if hasattr(shown, "InterpolateScalarsBeforeMapping"):
            shown.InterpolateScalarsBeforeMapping = 0  # its texture would not be exported
    path = page.with_suffix(".gltf")
    simple.ExportView(str(path), view=view, InlineData=1, SaveNormal=1)
    model = json.loads(path.read_text())
    path.unlink()
    # VTK gives only the first primitive of an actor its material.
    for mesh in model["meshes"]:
        for primitive in mesh["primitives"]:
            primitive.setdefault("material", mesh["primitives"][0].get("material"))
    return model


def write_page(view, page, title, caption):
    """Writes the contents of the render view as a self-contained page: glTF exported by ParaView, drawn by
    three.js."""
    missing = [name for name in SCRIPTS if not (THREE / name).exists()]
    if missing:
        sys.exit(f"There is no {THREE / missing[0]}: install three.js (Debian's libjs-three).")
    parts = {"title": html.escape(title), "caption": html.escape(caption), "model": json.dumps(model_of(view, page)),
             "scripts": "\n".join((THREE / name).read_text() for name in SCRIPTS)}
    # "</script" ends a script wherever it stands.
    for name in ("model", "scripts"):
        parts[name] = re.sub("</(script)", r"<\\/\1", parts[name], flags=re.IGNORECASE)
    page.write_text(re.sub("@(title|caption|model|scripts)@", lambda name: parts[name[1]], TEMPLATE.read_text()))


def main(folder, names):
    unknown = [name for name in names if name not in SCENES]
    if unknown:
        sys.exit(f"There is no scene {unknown[0]}: one of {', '.join(SCENES)}.")
    for name in names or SCENES:
        function, path, direction, title, caption = SCENES[name]
        view = gallery.view_of(function, gallery.data_folder() / path, direction)
        write_page(view, folder / f"{name}.html", title, caption)
        simple.Delete(view)
        print(folder / f"{name}.html")


if __name__ == "__main__":
    if {"-h", "--help"} & set(sys.argv[1:]):
        print(__doc__)
        sys.exit()
    main(output_folder(sys.argv[1] if len(sys.argv) > 1 else None), sys.argv[2:])
