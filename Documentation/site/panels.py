"""The panels of the plugin (Plugin/*.xml) as the guide shows them: one page for each proxy."""

import re
from dataclasses import dataclass, field

import panel_files

KINDS = {"filters": "filter", "sources": "reader", "writers": "writer"}


@dataclass
class Property:
    """One property of a panel."""

    name: str
    label: str
    default: str
    values: str  # what it may be: a range, the entries of a list, on or off
    help: str
    advanced: bool
    is_input: bool
    optional: bool
    port: int
    types: list


@dataclass
class Panel:
    """A proxy that users can choose in a menu or in a file dialog."""

    name: str
    label: str
    kind: str
    vtk_class: str
    file: str
    short_help: str
    documentation: str
    properties: list
    outputs: list  # (number, name)
    extensions: list = field(default_factory=list)

    @property
    def python_name(self):
        """The name of the proxy in paraview.simple."""
        return re.sub(r"\W", "", self.label)


def words(text):
    return " ".join((text or "").split())


def shown_number(text):
    """A number of a domain in readable form."""
    try:
        number = float(text)
    except ValueError:
        return text
    return f"{number:g}" if abs(number) < 1e9 else text


def range_of(domain):
    low, high = (domain.get(end, "").split() for end in ("min", "max"))
    low, high = (sorted(set(map(shown_number, end))) for end in (low, high))
    if len(low) > 1 or len(high) > 1:
        return ""
    if low and high:
        return f"{low[0]} to {high[0]}"
    if low:
        return f"at least {low[0]}"
    return f"at most {high[0]}" if high else ""


def values_and_default(element):
    """The allowed values of a property, and its default in the same form."""
    hint = element.find("./Hints/DefaultWithoutData")
    defaults = ((element.get("default_values") if hint is None else hint.get("values")) or "").strip()
    if element.find("BooleanDomain") is not None:
        return "on, off", {"1": "on", "0": "off"}.get(defaults, defaults)
    for tag in ("EnumerationDomain", "StringListDomain"):
        domain = element.find(tag)
        if domain is not None and domain.findall("Entry"):
            entries = {e.get("value"): e.get("text") for e in domain.findall("Entry")}
            return ", ".join(entries.values()), entries.get(defaults, defaults)
    for tag in ("DoubleRangeDomain", "IntRangeDomain"):
        domain = element.find(tag)
        if domain is not None:
            return range_of(domain), defaults
    if element.find("ArraySelectionDomain") is not None:
        return "names of arrays, listed below" if element.get("si_class") else "", defaults
    if element.find("ArrayListDomain") is not None:
        return "an array", defaults
    return "", defaults


def property_of(element):
    name = element.get("name")
    values, default = values_and_default(element)
    is_input = element.tag == "InputProperty"
    return Property(
        name=name,
        label=element.get("label") or re.sub(r"(?<=[a-z0-9])(?=[A-Z])", " ", name),
        default=default,
        values=values,
        help=words(element.findtext("Documentation")),
        advanced=element.get("panel_visibility") == "advanced",
        is_input=is_input,
        optional=element.find("Hints/Optional") is not None,
        port=int(element.get("port_index") or 0),
        types=[t.get("value") for t in element.findall("DataTypeDomain/DataType")])


def is_for_users(element):
    return element.get("panel_visibility") != "never" and element.get("information_only") != "1"


def elements_of(folder):
    """(file name, group, element) of all proxies."""
    for path in sorted(folder.glob("*.xml")):
        for group in panel_files.read_panel(path).iter("ProxyGroup"):
            for element in group:
                if element.get("name") and element.find("Documentation") is not None:
                    yield path.name, group.get("name"), element


def property_elements(element, known):
    """The properties of a proxy and of its base proxy, by name."""
    found = {}
    base = known.get((element.get("base_proxygroup"), element.get("base_proxyname")))
    if base is not None:
        found.update(property_elements(base, known))
    for child in element:
        if child.tag.endswith("Property") and child.get("name"):
            found[child.get("name")] = child
    for inner in element.findall("SubProxy"):
        proxy = inner.find("Proxy")
        exposed = {p.get("name"): p.get("exposed_name") or p.get("name")
                   for p in inner.findall("ExposedProperties/Property")}
        if proxy is None:
            continue
        target = known.get((proxy.get("proxygroup"), proxy.get("proxyname")))
        if target is not None:
            for name, child in property_elements(target, known).items():
                if name in exposed:
                    found[exposed[name]] = child
    return found


def class_of(element, known):
    """The VTK class of the proxy; for readers of file series, that of the reader of a single file."""
    if element.get("class") != "vtkFileSeriesReader" and element.get("class"):
        return element.get("class")
    for inner in element.findall("SubProxy/Proxy"):
        target = known.get((inner.get("proxygroup"), inner.get("proxyname")))
        if target is not None:
            return class_of(target, known)
    base = known.get((element.get("base_proxygroup"), element.get("base_proxyname")))
    return class_of(base, known) if base is not None else element.get("class") or ""


def outputs_of(element, known):
    ports = [(int(port.get("index") or 0), port.get("name")) for port in element.findall("OutputPort")]
    base = known.get((element.get("base_proxygroup"), element.get("base_proxyname")))
    return sorted(ports) if ports or base is None else outputs_of(base, known)


def read_panels(folder):
    """All panels of the menu, the readers and the writers, by name.

    Readers that redefine one of ParaView's own names in order to replace it are omitted, since they have no
    extensions of their own.
    """
    everything = list(elements_of(folder))
    known = {(group, element.get("name")): element for _, group, element in everything}
    panels = {}
    for file, group, element in everything:
        if group not in KINDS:
            continue
        text = element.find("Documentation")
        factory = [*element.iter("ReaderFactory"), *element.iter("WriterFactory")]
        panels[element.get("name")] = Panel(
            name=element.get("name"),
            label=element.get("label") or element.get("name"),
            kind=KINDS[group],
            vtk_class=class_of(element, known),
            file=file,
            short_help=words(text.get("short_help")),
            documentation=words(text.text),
            properties=[property_of(child) for child in property_elements(element, known).values()
                        if is_for_users(child) or child.tag == "InputProperty"],
            outputs=outputs_of(element, known),
            extensions=sorted({e for hint in factory for e in hint.get("extensions", "").split()}))
    return {name: panel for name, panel in panels.items()
            if panel.kind != "reader" or panel.extensions}
