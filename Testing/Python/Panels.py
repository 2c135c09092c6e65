"""Every panel of the plugin: it loads, every property is explained and bounded where it should be."""

import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from paraview import servermanager, simple  # noqa: F401 (simple opens the session)

NUMERIC = ("IntVectorProperty", "DoubleVectorProperty", "IdTypeVectorProperty")


def is_shown(element):
    return element.get("panel_visibility") != "never" and element.get("information_only") != "1"


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
        if element.tag in NUMERIC and not any(child.tag.endswith("Domain") for child in element):
            yield f"{label}: a number without a range"


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
        for proxy_element in group.iter("SourceProxy"):
            proxies += 1
            complaints += complaints_about(proxy_element)
            check_live(group.get("name"), proxy_element.get("name"))

assert proxies > 0, "no panel found"
assert not complaints, "\n".join(complaints)
print(f"{proxies} panels checked")
