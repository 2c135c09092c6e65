"""Every panel of the plugin: it loads, every property is explained and bounded where it should be, and its label has the
unit that the help names.
"""

import os
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from paraview import servermanager, simple  # noqa: F401 (simple opens the session)

# Optional inputs that are options, not ways of use. HessianCurvature's is for scripts of before;
# BindingSites, PoissonBoltzmann, IonTransport have a second entry each, with the input required.
OPTIONAL = {("HessianCurvature", "Surface"), ("ChokingLoops", "Mesh"), ("SurfaceToGrid", "Grid"),
            ("BindingSites", "Atoms"), ("PoissonBoltzmann", "Surface"),
            ("PoissonBoltzmann", "PotentialInput"), ("PoissonBoltzmannOnSurface", "PotentialInput"),
            ("MolecularPockets", "Surface"), ("FeatureTracks", "Lining"), ("IonTransport", "Surface"),
            ("IonTransportMovingSurface", "Surface"),
            ("MapHandles", "OtherHalf")}
# Outputs that stand beside the main one from the start: what the filter is for, or a reader's other view.
BESIDE = {("BindingSites", 1), ("CellIncidence", 1), ("FeatureTracks", 2), ("MapHandles", 1),
          ("MapHandles", 4), ("MapHandles", 5), ("SurfaceMeasures", 1),
          ("MeshQualityReport", 1), ("MolecularPockets", 1), ("MolecularPockets", 3), ("MoleculeCartoon", 1), ("PoreProfile", 5),
          ("PoissonBoltzmann", 1), ("NonpolarSolvation", 1), ("TetCutaway", 1), ("MacromoleculeReader", 1),
          ("IonTransport", 1), ("IonTransportMovingSurface", 2)}
ICONS = {":/Isthmus/" + file.get("alias") for file in ElementTree.parse(
    Path(os.environ["ISTHMUS_PANELS_DIR"]) / "Isthmus.qrc").getroot().iter("file")}
NUMERIC = ("IntVectorProperty", "DoubleVectorProperty", "IdTypeVectorProperty")

# Units in a help text, the first that fits, and how the label shows them. Where the unit depends on the input, the label
# has none.
UNITS = (("kcal/mol per square angstrom", "kcal/(mol Å²)"), ("kcal/mol per cubic angstrom", "kcal/(mol Å³)"),
         (r"kT/\(e angstrom\)", "kT/(e Å)"), ("per cubic angstrom", "1/Å³"), ("kcal/mol", "kcal/mol"),
         (r"angstrom\^3", "Å³"), (r"angstrom\^2|square angstrom", "Å²"), ("angstrom", "Å"), (r"\bmV\b", "mV"),
         ("kelvin", "K"), ("mol/l", "mol/l"), ("in degrees", "°"), ("kT/e", "kT/e"), ("seconds", "s"), ("MiB", "MiB"))
DEPENDS = re.compile("for molecular|for curvatures|for potentials|angstrom for|no unit|percent|unit of the array")


def is_shown(element):
    return element.get("panel_visibility") != "never" and element.get("information_only") != "1"


def complaints_about_entry(group, proxy_element):
    """What keeps a user from finding and starting it."""
    name = proxy_element.get("name")
    help_element = proxy_element.find("Documentation")
    for attribute in ("short_help", "long_help"):
        if help_element is None or len((help_element.get(attribute) or "").split()) < 3:
            yield f"{name}: no {attribute}"
    hints = proxy_element.find("Hints")
    menus = {} if hints is None else {
        menu.get("category"): menu.get("icon") for menu in hints.iter("ShowInMenu")}
    if group == "filters" and "Isthmus" not in menus:
        yield f"{name}: not in the menu Isthmus"
    elif group == "filters" and menus["Isthmus"] not in ICONS:
        yield f"{name}: no icon of Isthmus.qrc in the menu"
    views = [] if hints is None else [int(view.get("port", 0)) for view in hints.iter("View")]
    for port in proxy_element.iter("OutputPort"):
        number = int(port.get("index"))
        if number > 0 and number not in views and (name, number) not in BESIDE:
            yield f"{name}: {port.get('name')} is shown unasked beside the main output"
    for element in proxy_element.iter("InputProperty"):
        if element.get("name") == "Input" and element.get("label", "Input") != "Input":
            yield f"{name}.Input: scripts know an input by its label, and all write Input="
        if element.find("Hints/Optional") is not None and (
                (name, element.get("name")) not in OPTIONAL):
            yield f"{name}.{element.get('name')}: an optional input, which the window never asks for"


def complaints_about(proxy_element):
    """What a user would miss in this panel, one sentence each."""
    name = proxy_element.get("name")
    if len((proxy_element.findtext("Documentation") or "").split()) < 8:
        yield f"{name}: no documentation of the filter or reader itself"
    for element in proxy_element:
        if not element.tag.endswith("Property") or not is_shown(element):
            continue
        label = f"{name}.{element.get('name')}"
        if len((element.findtext("Documentation") or "").split()) < 4:
            yield f"{label}: no help text"
        for decorator in element.iter("PropertyWidgetDecorator"):
            if decorator.get("mode", "visibility") != "visibility":
                yield f"{label}: shown, but ignored in some modes (mode is not visibility)"
        if element.tag in NUMERIC and not any(child.tag.endswith("Domain") for child in element):
            yield f"{label}: a number without a range"
        shown, said = unit_of_label(element), unit_of_help(element)
        if shown != said:
            yield f"{label}: the unit of the label is {shown or 'missing'}, that of the help is {said or 'missing'}"


def unit_of_label(element):
    """The unit behind the label, which the decorator IsthmusUnitLabel writes; "" without one, or if it depends on another
    property."""
    found = [decorator.get("unit") for decorator in element.iter("PropertyWidgetDecorator")
             if decorator.get("type") == "isthmus_unit" and not decorator.get("when")]
    return found[0] if found else ""


def unit_of_help(element):
    """The unit in the help of a number, as the label should show it; "" without one, or if it depends on the input."""
    text = " ".join((element.findtext("Documentation") or "").split())
    is_number = element.tag in ("IntVectorProperty", "DoubleVectorProperty") and (
        element.get("repeat_command") != "1" and element.find("BooleanDomain") is None and
        element.find("EnumerationDomain") is None)
    if not is_number or DEPENDS.search(text):
        return ""
    return next((unit for words, unit in UNITS if re.search(words, text)), "")


def check_live(group, name):
    """The proxy exists in ParaView, takes all its defaults, and has every declared property."""
    proxy = servermanager.ProxyManager().NewProxy(group, name)
    assert proxy is not None, f"ParaView does not know {group}/{name}"
    proxy.UpdateVTKObjects()
    return proxy


complaints = []
proxies = 0
for panel in sorted(Path(os.environ["ISTHMUS_PANELS_DIR"]).glob("*.xml")):
    for group in ElementTree.parse(panel).getroot().iter("ProxyGroup"):
        for proxy_element in [*group.iter("SourceProxy"), *group.iter("PSWriterProxy"),
                              *group.iter("WriterProxy")]:
            proxies += 1
            complaints += complaints_about(proxy_element)
            complaints += complaints_about_entry(group.get("name"), proxy_element)
            check_live(group.get("name"), proxy_element.get("name"))

assert proxies > 0, "no panel found"
assert not complaints, "\n".join(complaints)
print(f"{proxies} panels checked")
