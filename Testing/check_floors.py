#!/usr/bin/env python3
"""Checks the include graph of the library against the floors of the house.

    check_floors.py [ROOT]

An arrow leads from a file to a header it includes. Between rooms, arrows lead to lower floors only;
within a room they never run in a circle, a concept (X.h and X.cxx) counting as one place. Readers
use Filters/Support alone of all Filters. Every source stands in its room's sources.cmake, and every
name there is a file. Headers that are installed (vtkX.h and those under HEADERS in a sources.cmake)
include no others. No two headers define a class of one name: the linker would take either. Prints
what is wrong, a line each, and ends with 1 then.
"""
import collections
import pathlib
import re
import sys

# Each floor uses those below it only; rooms of one floor do not know each other.
FILTER_FLOORS = [
    ["Support"],
    ["Imaging", "CellComplex", "Measures", "Persistence"],
    ["Meshing", "Curvature"],
    ["ChokingLoops"],
    ["Molecular"],
    ["Electrostatics"],
    ["Solvation"],
]
READER_FLOORS = [["Files"], ["Maps", "Potentials", "Molecules", "Meshes"]]
SHARED_ROOM = "Filters/Support"


def floors_of_rooms():
    """{room: floor}; Readers stand on Support, beside the Filters."""
    floors = {f"Filters/{room}": i for i, rooms in enumerate(FILTER_FLOORS) for room in rooms}
    floors.update(
        {f"Readers/{room}": i + 1 for i, rooms in enumerate(READER_FLOORS) for room in rooms})
    return floors


def library_files(root):
    files = [path for folder in ("Filters", "Readers") for path in (root / folder).rglob("*")]
    return sorted(path for path in files if path.suffix in (".h", ".cxx"))


def included_names(path):
    return re.findall(r'^\s*#\s*include\s+"([^"]+)"', path.read_text(), re.MULTILINE)


def may_use(room, other, floors):
    """Whether a file of `room` may include a header of `other`."""
    if other == room or other == SHARED_ROOM:
        return True
    if room.split("/")[0] != other.split("/")[0]:
        return False
    return floors[other] < floors[room]


def circles(graph):
    """The strongly connected components of more than one place (R. Tarjan, 1972), each sorted."""
    order, low, path, on_path, found = {}, {}, [], set(), []

    def visit(place):
        order[place] = low[place] = len(order)
        path.append(place)
        on_path.add(place)
        for other in sorted(graph.get(place, ())):
            if other not in order:
                visit(other)
                low[place] = min(low[place], low[other])
            elif other in on_path:
                low[place] = min(low[place], order[other])
        if low[place] == order[place]:
            component = []
            while not component or component[-1] != place:
                component.append(path.pop())
                on_path.discard(component[-1])
            if len(component) > 1:
                found.append(sorted(component))

    for place in sorted(graph):
        if place not in order:
            visit(place)
    return found


def words_of(listing):
    """{heading: names under it} of the call of isthmus_room in a sources.cmake."""
    call = re.search(r"isthmus_room\((.*?)\)", listing.read_text(), re.DOTALL)
    found, heading = collections.defaultdict(set), ""
    for word in re.sub(r"#.*", "", call.group(1) if call else "").split():
        if word.isupper():
            heading = word
        else:
            found[heading].add(word)
    return found


def check_sources(root, rooms):
    """Complaints about files that no sources.cmake names, and names without a file."""
    complaints = []
    for room in sorted(rooms):
        listing = root / room / "sources.cmake"
        if not listing.exists():
            complaints.append(f"{room} has no sources.cmake")
            continue
        words = words_of(listing)
        named = set().union(*(names for heading, names in words.items() if heading != "HEADERS"))
        there = {path.stem for path in (root / room).glob("*.cxx")}
        complaints += [f"{room}/sources.cmake names {name}.h, which is not there"
                       for name in sorted(words["HEADERS"]) if not (root / room / f"{name}.h").exists()]
        complaints += [f"{room}/{name}.cxx is not in sources.cmake" for name in sorted(there - named)]
        complaints += [f"{room}/sources.cmake names {name}, which is not there"
                       for name in sorted(named - there)]
    return complaints


def classes_of(path):
    """Names of the classes that a header defines in the namespace itself, not within another."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", path.read_text(), flags=re.DOTALL)
    found = re.finditer(r"\b(?:struct|class)\s+(?:VTKISTHMUS_EXPORT\s+)?(\w+)\s*(?:final\s*)?"
                        r"(?::[^;{()]*)?\{", text)
    return [match.group(1) for match in found
            if text[:match.start()].count("{") - text[:match.start()].count("}") == 1]


def check_names(headers):
    """Complaints about classes that two headers define, each of them in namespace isthmus."""
    places = collections.defaultdict(set)
    for path in headers:
        for name in classes_of(path):
            places[name].add(path.name)
    return [f"class {name} is defined in " + " and in ".join(sorted(names))
            for name, names in sorted(places.items()) if len(names) > 1]


def check(root):
    """All complaints about the tree under `root`, and how many arrows were looked at."""
    floors = floors_of_rooms()
    complaints, by_name, rooms = [], {}, set()
    for path in library_files(root):
        room = path.parent.relative_to(root).as_posix()
        if room not in floors:
            complaints.append(f"{path.relative_to(root)} lies in no room of the plan")
            continue
        rooms.add(room)
        if path.name in by_name:
            complaints.append(f"{path.name} is in {by_name[path.name][0]} and in {room}: includes "
                              "go by bare names")
        by_name[path.name] = (room, path)

    installed = {f"{name}.h" for room in rooms if (root / room / "sources.cmake").exists()
                 for name in words_of(root / room / "sources.cmake")["HEADERS"]}
    installed |= {name for name in by_name if re.match(r"vtk.*\.h$", name)}
    arrows = 0
    graph = collections.defaultdict(set)
    for room, path in by_name.values():
        for name in included_names(path):
            if name not in by_name:
                continue
            arrows += 1
            other = by_name[name][0]
            if path.name in installed and name not in installed:
                complaints.append(f"{room}/{path.name} includes {name}, which is not installed")
            if not may_use(room, other, floors):
                complaints.append(f"{room}/{path.name} includes {name} of {other}: not a lower floor")
            if path.stem != pathlib.Path(name).stem:
                graph[f"{room}/{path.stem}"].add(f"{other}/{pathlib.Path(name).stem}")
    complaints += ["a circle of includes: " + ", ".join(circle) for circle in circles(graph)]
    complaints += check_names(path for _, path in by_name.values() if path.suffix == ".h")
    return complaints + check_sources(root, rooms), arrows


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, arrows = check(root)
    if arrows == 0:
        complaints.append(f"no include of a header of ours was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{arrows} includes looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
