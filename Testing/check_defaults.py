#!/usr/bin/env python3
"""Checks that buttons and menus of the window start filters with the same values.

    check_defaults.py [ROOT]

For each step of the buttons' pipelines (Wrapping/Python/isthmus/steps.py) and each property that it sets: the value must be what
a menu gives a new filter, which is steps.FIRST or else the default of the panel (Plugin/*.xml); and what a menu sets of
a filter, the step must set. EXCEPTIONS lists what differs on purpose, with the reason, and must have no line too many.

Prints one line per error; the exit status is 1 if there are any.
"""
import importlib.util
import pathlib
import sys
import xml.etree.ElementTree

# {(pipeline, step, property): why the button differs from the menu}. * stands for any pipeline.
EXCEPTIONS = {
    ("map_to_loops", "surface", "LargestComponents"): "further components are dust: they take time and have no loops",
    **{("*", "ligands", name): "this Atom Selection is the one of what the chains are without"
       for name in ("IncludeChains", "IncludeLigands", "IncludeIons")},
    ("protein_to_surface", "surface", "AutomaticLevel"): "a molecular density is 1 at the surface, by its definition",
    ("protein_to_surface", "surface", "Level"): "the same",
    ("protein_to_surface", "surface", "MinimumComponentShare"): "small components are cavities, not dust",
    ("protein_to_potential", "surface", "AutomaticLevel"): "as of protein_to_surface",
    ("protein_to_potential", "surface", "Level"): "the same",
    ("protein_to_potential", "surface", "MinimumComponentShare"): "the same",
    ("protein_to_potential", "potential", "Level"): "the same level: the volume is the molecular density",
    **{("*", "loops", name): "functions report all loops; run() asks for the significant ones, as menus do"
       for name in ("MaximumNumberOfLoops", "TrustedOnly")},
}


def defaults_of(root):
    """{proxy: {property: default}} of the panels, as numbers; those of a base proxy included."""
    proxies, bases = {}, {}
    for path in sorted((root / "Plugin").glob("*.xml")):
        for proxy in xml.etree.ElementTree.parse(path).getroot().iter("SourceProxy"):
            values = proxies.setdefault(proxy.get("name"), {})
            bases[proxy.get("name")] = proxy.get("base_proxyname")
            for kind in ("IntVectorProperty", "DoubleVectorProperty"):
                for each in proxy.iter(kind):
                    hint = each.find("./Hints/DefaultWithoutData")
                    words = (each.get("default_values", "") if hint is None else hint.get("values")).split()
                    if len(words) == 1 and words[0] != "none":
                        values[each.get("name")] = float(words[0])
    return {name: {**proxies.get(bases[name], {}), **values} for name, values in proxies.items()}


def complaints(steps, panels, exceptions):
    said, used = [], set()
    for pipeline, parts in steps.PIPELINES.items():
        for part, step in parts.items():
            if step.proxy not in panels:
                said.append(f"{pipeline}, {part}: there is no panel of {step.proxy}")
                continue
            menu = {**panels[step.proxy], **steps.FIRST.get(step.proxy, {})}
            for name in {*step.properties, *steps.FIRST.get(step.proxy, {})}:
                if name not in menu:
                    said.append(f"{pipeline}, {part}: the panel of {step.proxy} has no number {name}")
                    continue
                value = step.properties.get(name, panels[step.proxy].get(name))
                keys = {(pipeline, part, name), ("*", part, name)} & set(exceptions)
                if value != menu[name] and not keys:
                    said.append(f"{pipeline}, {part}: {name} of {step.proxy} is {value} by the button and "
                                f"{menu[name]} by the menu: steps.FIRST has what both set")
                elif value != menu[name]:
                    used |= keys
    for proxy, values in steps.FIRST.items():
        said += [f"steps.FIRST: {proxy} has no number {name} in its panel" for name in values
                 if name not in panels.get(proxy, {})]
    said += [f"EXCEPTIONS of check_defaults.py: {key} is not needed any more" for key in exceptions if key not in used]
    return said


def load_steps(root):
    path = root / "Wrapping" / "Python" / "isthmus" / "steps.py"
    specification = importlib.util.spec_from_file_location("steps", path)
    steps = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(steps)
    return steps


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[1]
    said = complaints(load_steps(root), defaults_of(root), EXCEPTIONS)
    print("\n".join(said))
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
