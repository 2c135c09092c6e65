"""What VTK's output window receives, for tests of warnings and errors."""

import contextlib

from vtkmodules.vtkCommonCore import VTK_STRING, vtkOutputWindow


@contextlib.contextmanager
def said(event):
    """A list of the texts of an event, "WarningEvent" or "ErrorEvent", within a with block."""
    texts = []

    def keep(_, __, text):
        texts.append(text)

    keep.CallDataType = VTK_STRING
    window = vtkOutputWindow.GetInstance()
    observer = window.AddObserver(event, keep)
    try:
        yield texts
    finally:
        window.RemoveObserver(observer)
