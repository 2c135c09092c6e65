"""What notebooks show: results as HTML with a picture and their main numbers, and a bar while a filter runs."""
import base64
import contextlib
import html
import os
import sys
import tempfile
import time
import warnings

ROWS, COLUMNS, PIXELS = 6, 8, 420


# ---------------------------------------------------------------------------- progress

class Bar:
    """A bar of tqdm, where that is installed and someone looks: from the third second of a filter on."""

    AFTER = 2.0  # seconds

    def __init__(self, name):
        self.name, self.bar = name, None
        self.start = time.monotonic()
        self.wanted = "ipykernel" in sys.modules or (sys.stderr is not None and sys.stderr.isatty())

    def advance(self, fraction):
        if self.bar is None and self.wanted and time.monotonic() - self.start > self.AFTER:
            self.bar = self._open()
            self.wanted = self.bar is not None
        if self.bar is not None:
            self.bar.update(max(0.0, min(fraction, 1.0) - self.bar.n))

    def _open(self):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # tqdm's own, about notebooks without widgets
                from tqdm.auto import tqdm
                return tqdm(total=1.0, desc=self.name, leave=False,
                            bar_format="{desc}: {percentage:3.0f} %|{bar}| {elapsed}")
        except ImportError:
            return None

    def close(self):
        if self.bar is not None:
            self.bar.close()


# ---------------------------------------------------------------------------- results

def shows_html(kind):
    """Gives a class of named tuples its form in notebooks."""
    kind._repr_html_ = html_of
    return kind


def html_of(result):
    parts = [f"<b>{html.escape(type(result).__name__)}</b>", _picture(result), "<table>"]
    for name, data in zip(result._fields, result):
        parts.append(f"<tr><td style='text-align:left'><code>{name}</code></td>"
                     f"<td style='text-align:left'>{html.escape(_size(data))}</td></tr>")
    return "".join([*parts, "</table>", *map(_rows, result._fields, result)])


def _size(data):
    if data is None:
        return "none"
    if not hasattr(data, "IsA"):
        return f"{type(data).__name__} of shape {getattr(data, 'shape', '')}"
    if data.IsA("vtkTable"):
        return f"{data.GetNumberOfRows():,} rows"
    words = f"{data.GetNumberOfPoints():,} points, {data.GetNumberOfCells():,} cells"
    level = data.GetFieldData().GetArray("Level")
    return words + (f", level {level.GetValue(0):.4g}" if level is not None and level.GetNumberOfValues() else "")


def _rows(name, data):
    """The first rows of a table, and of the features of a geometry: those whose cells have numbers."""
    from .command import rows_of
    if data is None or not hasattr(data, "IsA"):
        return ""
    if data.IsA("vtkTable"):
        rows = rows_of(data.GetRowData(), data.GetNumberOfRows())
    elif data.IsA("vtkPolyData") and data.GetNumberOfLines() == data.GetNumberOfCells() <= 1000:
        rows = rows_of(data.GetCellData(), data.GetNumberOfCells())
    else:
        return ""
    if not rows:
        return ""
    columns = list(rows[0])[:COLUMNS]
    lines = ["<tr>" + "".join(f"<th>{html.escape(column)}</th>" for column in columns) + "</tr>"]
    for row in rows[:ROWS]:
        lines.append("<tr>" + "".join(f"<td>{html.escape(_text(row[column]))}</td>" for column in columns) + "</tr>")
    more = len(rows) - ROWS
    return (f"<details open><summary><code>{name}</code></summary><table>{''.join(lines)}</table>"
            f"{f'and {more:,} more' if more > 0 else ''}</details>")


def _text(value):
    return "" if value is None else f"{value:.4g}" if isinstance(value, float) else str(value)


def _picture(result):
    """The shapes of the result, or the sentence that says why there is no picture."""
    from . import command
    colours = iter((command.GREY, command.VERMILION, command.BLUE, command.ORANGE, (0.0, 0.62, 0.451)))
    try:
        shapes = [data if data.IsA("vtkPolyData") else command._as_surface(data) for data in result
                  if hasattr(data, "IsA") and (data.IsA("vtkPolyData") or data.IsA("vtkUnstructuredGrid")) and
                  data.GetNumberOfCells()]
        if not shapes:
            return ""
        size = max(shape.GetLength() for shape in shapes)
        actors = []
        for shape, colour in zip(shapes, colours):
            lines = shape.GetNumberOfPolys() == 0 and shape.GetNumberOfLines() > 0
            actors.append(command._actor(shape, colour, 1.0 if lines else 0.4, tube=size / 200 if lines else 0.0))
        with tempfile.TemporaryDirectory() as folder, _quiet():
            path = os.path.join(folder, "picture.png")
            command.draw(actors, path, PIXELS)
            with open(path, "rb") as file:
                content = base64.b64encode(file.read()).decode()
    except ValueError as reason:
        return f"<p><i>{html.escape(str(reason))}</i></p>"
    return f"<br><img alt='the result' width='{PIXELS // 2}' src='data:image/png;base64,{content}'>"


@contextlib.contextmanager
def _quiet():
    """Without the verbosity that draw() sets for the rest of the program."""
    from vtkmodules.vtkCommonCore import vtkLogger
    before = vtkLogger.GetCurrentVerbosityCutoff()
    try:
        yield
    finally:
        vtkLogger.SetStderrVerbosity(before)
