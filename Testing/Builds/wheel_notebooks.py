"""Runs the notebooks from top to bottom; each must draw its pictures.

    wheel_notebooks.py NOTEBOOKS OUTPUT
"""
import base64
import pathlib
import sys

import nbclient
import nbformat


def run(path, output):
    notebook = nbformat.read(path, as_version=4)
    work = output / path.stem
    work.mkdir(parents=True, exist_ok=True)
    nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3",
                            resources={"metadata": {"path": str(work)}}).execute()
    pictures = [data["image/png"] for cell in notebook.cells for found in cell.get("outputs", [])
                if "image/png" in (data := found.get("data", {}))]
    for number, picture in enumerate(pictures):
        (work / f"{number}.png").write_bytes(base64.b64decode(picture))
    nbformat.write(notebook, work / path.name)
    drawn = sum("plotter.show()" in cell.source or "plt.show()" in cell.source for cell in notebook.cells)
    assert len(pictures) == drawn > 2, f"{path.name}: {len(pictures)} pictures of {drawn}"
    print(f"{path.name}: {len(pictures)} pictures")


def main():
    notebooks = sorted(pathlib.Path(sys.argv[1]).glob("*.ipynb"))
    assert len(notebooks) >= 2, "no notebooks"
    for path in notebooks:
        run(path, pathlib.Path(sys.argv[2]))


if __name__ == "__main__":
    main()
