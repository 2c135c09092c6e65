"""Messages of the window in plain language. The text of an unexpected exception is written to a file, which the user can
send with a report.

Where a message goes: an error where there is no result; a warning where the result is not what was requested, or not to be trusted
as it is, so that the user has to decide something (both open the window's messages); a note for all else that
explains a correct result. Filters put notes into the field data Notes, which the Information panel keeps, the functions
of the buttons call show_note(); the window shows both in its status bar."""

import functools
import tempfile
import traceback

from vtkmodules.vtkCommonCore import vtkOutputWindow


def show_error(message):
    """Shows an error in the window Output Messages, which opens as for an error of a filter."""
    vtkOutputWindow.GetInstance().DisplayErrorText(f"Isthmus: {message}\n")


def show_note(text):
    """A note in the window's status bar; nothing in scripts."""
    vtkOutputWindow.GetInstance().InvokeEvent("UserEvent", text)


# Events that the window observes (IsthmusProgress): a step; the result of a button is about to be shown.
STEP, SHOWS = 1100, 1101


class Cancelled(Exception):
    """The user has cancelled the button."""


def step(what=""):
    """A button reports the step that begins, for the window's status bar, which keeps the last one if `what` is "".
    Raises Cancelled if the user has pressed Cancel. Does nothing in scripts."""
    if is_cancelled(what):
        raise Cancelled


def is_cancelled(what=""):
    """step(), for callers that must not raise."""
    return bool(vtkOutputWindow.GetInstance().InvokeEvent(STEP, what))


def begin_showing():
    """From here on the button cannot be cancelled: filters that its result is shown by would be left without data, and
    ParaView ends if that happens to the input of Extract Selection."""
    vtkOutputWindow.GetInstance().InvokeEvent(SHOWS)


def reports_faults(what):
    """Decorator for functions that the window calls: catches all exceptions."""
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
    """Called in an except clause: `what` failed for an unforeseen reason."""
    with tempfile.NamedTemporaryFile("w", prefix="isthmus-fault-", suffix=".txt", delete=False) as report:
        report.write(traceback.format_exc())
    show_error(f"{what} failed. This is a fault in Isthmus: please report it with the file {report.name} and, if "
               "you can, the data that was open.")
