"""The tables of output arrays in the sources of the vtk classes (Filters/Core/OutputArrays.h)."""
import pathlib
import re

# A string of several parts counts as one.
STRING = r'((?:"(?:[^"\\]|\\.)*"\s*)+)'
ROW = re.compile(r"\{ (-?\d+), ArrayPlace::(\w+), " + STRING + r",\s*(\d+), " + STRING + r",\s*ArrayChoice::(\w+),\s*" +
                 STRING + r"\}")
TABLE = re.compile(r"& (vtk\w+)::OutputArrayTable\(\)\n\{(.*?)\n\}\n", re.DOTALL)
# Rows of several tables, in the headers NAMEArrays.h; of different outputs with their number as the parameter Port.
MACRO = re.compile(r"#define (ISTHMUS_\w+_ARRAY_ROWS)(?:\(Port\))? +\\\n((?:.*\\\n)*.*)\n")


def _text(literals):
    return "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literals)).replace('\\"', '"').replace("\\\\", "\\")


def rows_of(text):
    """Rows of a table as dictionaries."""
    text = re.sub(r"\s*\\?\n\s*", " ", text)
    return [{"port": int(port), "place": place.lower(), "name": _text(name), "components": int(components),
             "unit": _text(unit), "choice": choice.lower(), "text": _text(meaning)}
            for port, place, name, components, unit, choice, meaning in ROW.findall(text)]


def read_tables(root):
    """The rows of each class that has a table."""
    tables = {}
    for path in sorted(pathlib.Path(root).glob("[FR]*/*/vtk*.cxx")):
        for name, body in TABLE.findall(path.read_text()):
            for header in path.parent.glob("*Arrays.h"):
                for macro, rows in MACRO.findall(header.read_text()):
                    body = re.sub(macro + r"(?:\((\d+)\))?", lambda use, rows=rows: rows.replace("Port", use[1] or "Port"), body)
            tables[name] = rows_of(body)
            if body.count("ArrayPlace::") != len(tables[name]):
                raise SystemExit(f"{path}: rows of {name}::OutputArrayTable() that are not of the form in OutputArrays.h")
    return tables


def optional(rows):
    return [row for row in rows if row["choice"] != "none"]
