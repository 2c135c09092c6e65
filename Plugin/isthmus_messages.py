"""What the window says when something can't be done, in sentences: never an exception's text or a line of a
script, which is written to a file for reports."""

import functools
import tempfile
import traceback

from vtkmodules.vtkCommonCore import vtkOutputWindow


def show_error(message):
    """An error in the window's messages, which open for it as for a filter's."""
    vtkOutputWindow.GetInstance().DisplayErrorText(f"Isthmus: {message}\n")


def reports_faults(what):
    """Decorator of what the window calls: no exception gets out of it."""
    def decorate(function):
        @functools.wraps(function)
        def called(*arguments):
            try:
                return function(*arguments)
            except Exception:
                fault(what)
                return None
        return called
    return decorate


def fault(what):
    """Called in an except clause: `what` failed for a reason that nobody has foreseen."""
    with tempfile.NamedTemporaryFile("w", prefix="isthmus-fault-", suffix=".txt", delete=False) as report:
        report.write(traceback.format_exc())
    show_error(f"{what} failed. This is a fault in Isthmus: please report it with the file {report.name} and, if "
               "you can, the data that was open.")
