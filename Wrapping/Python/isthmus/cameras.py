"""Cameras of views, and updates when they move: names of residues, scale bars.

    from isthmus import cameras                   # or: from isthmus_plugin, with the plugin loaded
    cameras.when_moved(act)                       # act(view, ended) is called for each view that is followed
    cameras.follow(view)
"""

from . import messages

POSITION = ("Position", "FocalPoint", "ViewUp", "ViewAngle", "ParallelScale")
_actions = []
_followed = {}  # address of the interactor of each followed view: a view recreated by undo has a new one


def position_of(view):
    """Where the camera of a view is, for set_position()."""
    camera = view.GetActiveCamera()
    return {name: getattr(camera, f"Get{name}")() for name in POSITION}


def set_position(view, position):
    for name, value in position.items():
        getattr(view.GetActiveCamera(), f"Set{name}")(value)


def when_moved(act):
    """Registers act(view, ended), which returns whether the view must be rendered again; ended: False during a rotation.

    The camera also moves while ParaView updates or draws a view, and a pipeline that is updated from within its own update
    ends the program. So an action sets properties and must not update a pipeline or fetch data; the next rendering does."""
    _actions.append(act)
    return act


def follow(view):
    """Calls the registered actions whenever the camera of this render view moves, by the mouse or by a command."""
    number = view.SMProxy.GetGlobalID()
    interactor = view.SMProxy.GetInteractor() if hasattr(view.SMProxy, "GetInteractor") else None
    if interactor is None or _followed.get(number) == interactor.__this__:
        return
    _followed[number] = interactor.__this__

    def moved(_, event):
        ended = event != "InteractionEvent"
        try:
            if any([act(view, ended) for act in _actions]) and ended and event != "ResetCameraEvent":
                view.SMProxy.StillRender()
        except Exception:  # moving the camera must not fail
            messages.fault("Placing what follows the camera")

    for event in ("InteractionEvent", "EndInteractionEvent", "MouseWheelForwardEvent", "MouseWheelBackwardEvent"):
        interactor.AddObserver(event, moved)
    view.SMProxy.AddObserver("ResetCameraEvent", moved)
