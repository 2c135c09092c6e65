#!/usr/bin/env python3
"""The panels of the plugin (Plugin/*.xml), with the formats of molecules of Readers/Molecules/MoleculeFormats.h.

    panel_files.py SOURCE FOLDER

writes the panels of the tree SOURCE into FOLDER, in the form that the plugin build needs. In their sources,
@MOLECULE_FORMATS@ is replaced by the entries of the list of formats, @MOLECULE_NAMES@ by their names, and
@MOLECULE_ENDINGS@ by the file name extensions.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

ROW = re.compile(r'^  FORMAT\((\w+), "([^"]+)", "([^"]+)"\)', re.MULTILINE)
PACKED = ("", ".gz", ".bz2")


def molecule_formats(root):
    """(name, label, endings) of each row of the table."""
    table = (pathlib.Path(root) / "Readers/Molecules/MoleculeFormats.h").read_text()
    rows = [(name, label, endings.split()) for name, label, endings in ROW.findall(table)]
    if not rows or len(rows) != table.count("\n  FORMAT("):
        raise SystemExit("panel_files.py: MoleculeFormats.h has rows that are not of the form FORMAT(NAME, \"...\", \"...\")")
    return rows


def panel_text(path):
    """The text of a panel with all placeholders replaced."""
    path = pathlib.Path(path)
    text = path.read_text()
    if "@MOLECULE_" not in text:
        return text
    rows = molecule_formats(path.parent.parent)
    endings = [ending for *_, endings in rows for ending in endings]
    entries = "\n          ".join(f'<Entry value="{number}" text="{label}"/>' for number, (_, label, _) in enumerate(rows, 1))
    for key, value in (("FORMATS", entries), ("NAMES", ", ".join(label for _, label, _ in rows)),
                       ("ENDINGS", " ".join(ending + packed for packed in PACKED for ending in endings))):
        text = text.replace(f"@MOLECULE_{key}@", value)
    return text


def read_panel(path):
    """The root element of a panel."""
    return ElementTree.fromstring(panel_text(path))


def extensions(proxy):
    """The file name extensions of a reader, without those of compressed files."""
    hint = proxy.find("./Hints/ReaderFactory")
    words = hint.get("extensions").split() if hint is not None else []
    return [word for word in words if not word.endswith(PACKED[1:])]


if __name__ == "__main__":
    source, folder = map(pathlib.Path, sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    for panel in [*sorted((source / "Plugin").glob("*.xml")), source / "Plugin" / "Isthmus.qrc"]:
        written, text = folder / panel.name, panel_text(panel)
        if not written.exists() or written.read_text() != text:  # unchanged files keep their modification time
            written.write_text(text)
    for old in folder.glob("*.xml"):
        if not (source / "Plugin" / old.name).exists():
            old.unlink()
