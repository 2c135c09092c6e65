"""Choking loops in the window: a text that says how many of them are shown.

    from isthmus import loop_views                # or: from isthmus_plugin, with the plugin loaded
    loop_views.words(loops)                       # "20 of 557 loops shown"

Buttons and menus of the window set the properties in steps.SIGNIFICANT, so that only significant loops are shown;
functions in scripts report all loops. look.py calls count() for each result that is new or has changed.
"""

try:
    from paraview import servermanager, simple
except ImportError:
    servermanager = simple = None  # with pip's vtk alone, isthmus.pipelines can still be imported

LOOPS = ("ChokingLoops",)
STALE = "the loops follow when the slider is released"
COUNT = " shown"  # ends the names of the texts in the pipeline browser


def _number(source, name):
    field = source.FieldData[name]
    return int(field.GetRange(0)[0]) if field else None


def words(loops):
    """A text that says how many of the loops are shown; "" without a result, or if it has several blocks."""
    proxy = servermanager._getPyProxy(loops.SMProxy)
    if proxy.GetDataInformation().DataInformation.GetCompositeDataSetType() != -1:
        return ""
    shown, found, untrusted = (_number(proxy, name) for name in (
        "NumberOfShownFeatures", "NumberOfFeatures", "NumberOfUntrustedFeatures"))
    if shown is None or found is None:
        return ""
    lines = [f"{shown} of {found} loops shown"]
    if untrusted and proxy.TrustedOnly:
        lines[0] += f", {untrusted} not trusted"
    gain = _gain_of_denoising(proxy)
    if gain is not None:
        lines.append(f"map denoised first, estimated gain {gain:.1f} dB")
    return "\n".join(lines)


def _gain_of_denoising(loops):
    """The estimated gain of the Denoise Map upstream; None if there is none."""
    proxy = loops.SMProxy
    while proxy is not None and proxy.GetNumberOfProducers():
        proxy = proxy.GetProducerProxy(0)
        if proxy.GetXMLName() == "DenoiseMap":
            gain = servermanager._getPyProxy(proxy).FieldData["EstimatedGain"]
            return gain.GetRange(0)[0] if gain else None
    return None


def registered_name(proxy):
    """The name in the pipeline browser; "" for a source that is not registered."""
    names = [name for (name, _), known in simple.GetSources().items() if known.SMProxy == proxy.SMProxy]
    return names[0] if names else ""


def count(loops, view):
    """Creates or updates the text in the view that says how many loops are shown, and hides it together with the
    loops. Returns whether anything has changed."""
    loops = servermanager._getPyProxy(loops.SMProxy)
    name = registered_name(loops)
    if not name or not hasattr(view, "HiddenLineRemoval"):  # no render view
        return False
    text = simple.FindSource(name + COUNT)
    said = words(loops)
    if text is None:
        if not said:
            return False
        selected = simple.GetActiveSource()
        text = simple.Text(registrationName=name + COUNT, Text=said)
        simple.SetActiveSource(selected)
        _place(simple.Show(text, view))
        return True
    has_changed = text.Text != said
    if has_changed:
        text.Text = said
    visible = any(display.Visibility for display in view.Representations
                  if getattr(getattr(display, "Input", None), "SMProxy", None) == loops.SMProxy and
                  getattr(display.Input, "Port", 0) == 0)
    shown = simple.GetRepresentation(text, view)
    if bool(shown.Visibility) != (visible and bool(said)):
        shown.Visibility = int(visible and bool(said))
        return True
    return has_changed


def _place(display):
    """Places the text in the upper left corner, so that it is complete in flat views and with large letters."""
    display.WindowLocation = "Upper Left Corner" if "Upper Left Corner" in display.GetProperty(
        "WindowLocation").Available else "UpperLeftCorner"
    display.FontSize, display.Justification = 14, "Left"


def mark_stale(depends):
    """Replaces the texts of those loops for which `depends` is true by a note that they wait for a new level."""
    for (name, _), text in list(simple.GetSources().items()):
        loops = simple.FindSource(name[:-len(COUNT)]) if name.endswith(COUNT) else None
        if loops is not None and text.SMProxy.GetXMLName() == "TextSource" and depends(loops.SMProxy):
            text.Text = STALE


def forget():
    """Deletes the texts of loops that have been deleted."""
    names = {name for name, _ in simple.GetSources()}
    for (name, _), text in list(simple.GetSources().items()):
        if name.endswith(COUNT) and text.SMProxy.GetXMLName() == "TextSource" and (
                name[:-len(COUNT)] not in names):
            simple.Delete(text)
