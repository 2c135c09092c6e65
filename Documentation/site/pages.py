"""Creates the source folder of the guide from the hand-written pages and from texts of the repository.

Pages of Documentation keep their paths. Every other .md file of the repository becomes a page below
repository/, and the links between all of them are adapted. A page of filters/ consists of its hand-written part and
of the texts of the panel, the header and the module.
"""

import ast
import os
import re
import shutil
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "Wrapping" / "Python"))
import headers  # noqa: E402
import output_arrays  # noqa: E402
import panels  # noqa: E402

GUIDE = Path("Documentation")
LINK = re.compile(r"(!?\[(?:[^\[\]`]|`[^`]*`|!\[[^\]]*\]\([^)]*\))*\]\()([^)\s]+)(\))")
COMMUNITY = (".github/SECURITY.md", ".github/CODE_OF_CONDUCT.md")
HIDDEN = re.compile(r"(^|/)(\.|build|__pycache__)")


def cell(text):
    """Text in a cell of a table."""
    return headers.escaped(text).replace("|", "\\|").replace("*", "\\*")


def outside_code(text, change):
    """`change` applied to the parts of a page that are neither blocks of code nor code in a line."""
    parts = re.split(r"(^```.*?^```|^(?:    .*\n)+|`[^`\n]*`)", text, flags=re.DOTALL | re.MULTILINE)
    return "".join(part if i % 2 else change(part) for i, part in enumerate(parts))


class Site:
    """The pages of the guide and their sources."""

    def __init__(self, root, version, scenes=()):
        """`scenes`: (name of the page, title) of those that Examples/scenes.py wrote."""
        self.root = root
        self.version = version
        self.scenes = scenes
        self.panels = panels.read_panels(root / "Plugin")
        self.classes = headers.read_classes(root)
        self.arrays = output_arrays.read_tables(root)
        self.modules = headers.declared_modules(root)
        self.gpl = headers.uses_cgal(root, self.modules)
        self.pages = {}  # site path -> text
        self.files = {}  # site path -> file of the repository

    # Where files of the repository are on the site.

    def place_of(self, path):
        """Site path of a file of the repository."""
        relative = path.relative_to(self.root)
        if relative.is_relative_to(GUIDE):
            return str(relative.relative_to(GUIDE))
        return str(Path("repository") / str(relative).replace(".github", "github"))

    def turned_link(self, link, page, place):
        """A link on a page of the repository, adapted to the site; None for a folder without a page.
        A broken link is kept, so that Sphinx warns about it."""
        if re.match(r"[a-z]+:", link) or link.startswith("#"):
            return link
        name, mark, fragment = link.partition("#")
        target = Path(os.path.normpath(page.parent / name))
        if target.is_dir():
            target = target / "README.md"
            if not target.exists():
                return None
        if not target.exists():
            return link
        there = self.place_of(target)
        if target.suffix != ".md":
            self.files[there] = target
        return os.path.relpath(there, Path(place).parent) + mark + fragment

    def turned(self, text, page, place):
        """A page of the repository with adapted links; links to folders without a page become plain text."""
        def change(match):
            link = self.turned_link(match.group(2), page, place)
            if link is None:
                return re.sub(r"^\[(.*)\]\($", r"\1", match.group(1))
            return match.group(1) + link + match.group(3)
        blocks = re.split(r"(^```.*?^```)", text, flags=re.DOTALL | re.MULTILINE)
        for i in range(0, len(blocks), 2):
            # Twice, for a picture inside of a link.
            blocks[i] = LINK.sub(change, blocks[i])
        return "".join(blocks)

    # Pages.

    def page_of_class(self, name):
        """The panel page of a class: the one with the same name, or else the first."""
        found = [panel for panel in self.panels.values() if panel.vtk_class == name]
        same = [panel for panel in found if "vtk" + panel.name == name]
        return (same or found or [None])[0]

    def with_links(self, text, here):
        """Names of classes as links to their pages."""
        def link(match):
            panel = self.page_of_class(match.group(0))
            if panel is None or panel.name == here:
                return match.group(0)
            return f"[{match.group(0)}]({panel.name}.md)"
        return outside_code(text, lambda part: re.sub(r"\bvtk[A-Z]\w+", link, part))

    def facts(self, panel):
        comment = self.classes.get(panel.vtk_class)
        rows = []
        if panel.kind == "filter":
            rows.append(("In ParaView", f"Filters > Isthmus > {panel.label}"))
        elif panel.kind == "reader":
            rows.append(("In ParaView", "File > Open"))
        else:
            rows.append(("In ParaView", "File > Save Data"))
        if panel.extensions:
            plain = [e for e in panel.extensions if not e.endswith((".gz", ".bz2")) and e != "gz"]
            packed = sorted({e.rsplit(".", 1)[-1] for e in panel.extensions} & {"gz", "bz2"})
            extra = f", also `.{'`, `.'.join(packed)}`" if packed else ""
            rows.append(("Files", ", ".join(f"`.{e}`" for e in plain) + extra))
        rows.append(("In Python (`paraview.simple`)", f"`{panel.python_name}`"))
        if comment:
            api = f'<a href="../api/class{panel.vtk_class}.html">{panel.vtk_class}</a>'
            component = comment.module.replace("/", "")
            rows.append(("C++ class", f"{api}, component `{component}` of `find_package(Isthmus)`"))
            manual = f"../repository/{comment.module}/README.md"
            rows.append(("Module", f"[{comment.module}]({manual})"))
            licence = "GPL-3.0-or-later" if comment.module in self.gpl else "BSD-3-Clause"
            rows.append(("Licence of the built module", f"{licence} ([details](../licences.md))"))
        lines = ["| | |", "|---|---|", *(f"| {name} | {value} |" for name, value in rows)]
        return "\n".join(lines)

    @staticmethod
    def property_row(entry):
        default = f"`{entry.default}`" if entry.default else ""
        return f"| {cell(entry.label)} | {cell(default)} | {cell(entry.values)} | {cell(entry.help)} |"

    def property_tables(self, panel):
        plain = [entry for entry in panel.properties if not entry.is_input]
        head = ["| property | default | values | meaning |", "|---|---|---|---|"]
        parts = []
        for title, advanced in (("## Properties", False), ("### Advanced properties", True)):
            rows = [self.property_row(entry) for entry in plain if entry.advanced == advanced]
            if rows:
                parts.append("\n".join([title if parts or not advanced else "## Properties", "", *head,
                                        *rows]))
        return parts

    @staticmethod
    def input_table(panel):
        inputs = sorted((e for e in panel.properties if e.is_input), key=lambda e: e.port)
        if not inputs:
            return []
        rows = []
        for entry in inputs:
            kinds = ", ".join(f"`{name}`" for name in entry.types)
            optional = ", optional" if entry.optional else ""
            rows.append(f"| {cell(entry.label)}{optional} | {kinds} | {cell(entry.help)} |")
        return ["\n".join(["## Inputs", "", "| input | type | meaning |", "|---|---|---|", *rows])]

    def array_table(self, panel):
        """The arrays that the filter adds, from the table in its source."""
        table = self.arrays.get(panel.vtk_class, [])
        if not table:
            return []
        ports = {row["port"] for row in table}
        rows = []
        for row in table:
            output = ("all: " if row["port"] < 0 else f"{row['port']}: ") if len(ports) > 1 else ""
            width = row["components"]
            kind = {"field": "field data"}.get(row["place"], row["place"]) + (f", {width} components" if width > 1 else "")
            made = {"on": "on", "off": "off"}.get(row["choice"], "")
            name = "the input's name" if row["name"] == "INPUT" else f"`{row['name']}`"
            rows.append(f"| {output}{name} | {kind} | {cell(row['unit'])} | {made} | {cell(row['text'])} |")
        lines = ["## Output arrays", "", "| array | of | unit | by default, if optional | meaning |", "|---|---|---|---|---|",
                 *rows]
        if any("NAME" in row["name"] for row in table):
            lines += ["", "NAME stands for names or numbers that depend on the input."]
        return ["\n".join(lines)]

    @staticmethod
    def output_list(panel):
        if len(panel.outputs) < 2:
            return []
        rows = [f"{number}. {name}" for number, name in panel.outputs]
        return ["\n".join(["## Outputs", "", *rows])]

    def filter_page(self, panel, hand_written):
        parts = [hand_written.rstrip(), self.facts(panel), headers.escaped(panel.documentation)]
        parts += self.property_tables(panel) + self.input_table(panel) + self.output_list(panel)
        parts += self.array_table(panel)
        comment = self.classes.get(panel.vtk_class)
        if comment:
            text = self.with_links(f"{comment.brief}\n\n{comment.text}", panel.name)
            parts.append(f"## Reference\n\n{text}")
            pages = [self.page_of_class(name) for name in comment.see_also]
            links = [f"[{page.label}]({page.name}.md)" for page in pages if page]
            if links:
                parts.append("## See also\n\n" + ", ".join(links))
        return "\n\n".join(parts) + "\n"

    def add_guide(self):
        """Writes the hand-written pages, and those of the panels with their generated parts."""
        for path in sorted((self.root / GUIDE).rglob("*.md")):
            if path.parent.name == "site":  # the main page of the C++ reference
                continue
            place = self.place_of(path)
            text = self.turned(path.read_text(), path, place)
            panel = self.panels.get(path.stem) if Path(place).parent == Path("filters") else None
            if panel:
                text = self.filter_page(panel, text)
            elif place in GENERATED:
                text = "\n".join([text.rstrip(), "", *GENERATED[place](self)]) + "\n"
            text = text.replace(DRAWING, "![The modules and what they depend on](modules.svg)")
            self.pages[place] = text
        missing = sorted(name for name in self.panels if f"filters/{name}.md" not in self.pages)
        if missing:
            raise SystemExit("No hand-written part in Documentation/filters/ for: " + ", ".join(missing))

    def add_repository(self):
        """Writes all other pages of the repository, and a list of them."""
        for path in sorted(self.root.rglob("*.md")):
            relative = path.relative_to(self.root)
            shown = str(relative) in COMMUNITY or not HIDDEN.search(str(relative))
            if not shown or relative.is_relative_to(GUIDE):
                continue
            place = self.place_of(path)
            text = self.turned(path.read_text(), path, place)
            self.pages[place] = text
        names = sorted(name for name in self.pages if name.startswith("repository/"))
        self.pages["repository/index.md"] = "\n".join([
            "# Manuals of the modules", "",
            "These pages are stored beside the source code: the contents of each module, its formulas and "
            "references, and measurements.", "",
            "```{toctree}", ":maxdepth: 1", "",
            *(name.removeprefix("repository/") for name in names), "```", ""])

    def list_lines(self):
        """The table of filters, readers and writers."""
        lines = []
        for kind, title in (("filter", "Filters"), ("reader", "Readers"), ("writer", "Writers")):
            lines += [f"## {title}", "", "| in ParaView | what it does | class |", "|---|---|---|"]
            for panel in sorted(self.panels.values(), key=lambda panel: panel.label):
                if panel.kind == kind:
                    lines.append(f"| [{panel.label}]({panel.name}.md) | {cell(panel.short_help.rstrip('.'))} "
                                 f"| {panel.vtk_class if panel.vtk_class in self.classes else ''} |")
            lines.append("")
        names = sorted(self.panels, key=lambda name: self.panels[name].label)
        return [*lines, "```{toctree}", ":hidden:", "", *names, "```"]

    def scene_lines(self):
        """Links to the scenes, or instructions for making them."""
        if not self.scenes:
            return ["This copy of the guide does not include them: build the target scenes, then guide again."]
        return [f'- <a href="scenes/{name}.html">{headers.escaped(title)}</a>' for name, title in self.scenes]

    def python_lines(self):
        """The functions of the Python package, from their docstrings, and its classes."""
        lines = []
        package = self.root / "Wrapping" / "Python" / "isthmus"
        listed = re.search(r"set\(ISTHMUS_PARAVIEW_PYTHON ([^)]*)\)",
                           (self.root / "cmake" / "IsthmusBuild.cmake").read_text()).group(1).split()
        for path in [package / f"{name}.py" for name in ("data_pipelines", *listed)]:
            tree = ast.parse(path.read_text())
            lines += [f"## isthmus.{path.stem}", "", headers.escaped(ast.get_docstring(tree) or ""), ""]
            for node in tree.body:
                text = ast.get_docstring(node) if isinstance(node, ast.FunctionDef) else None
                if text and not node.name.startswith("_"):
                    signature = f"{node.name}({ast.unparse(node.args)})"
                    lines += [f"### {node.name}", "", "```python", signature, "```", "",
                              headers.escaped(text), ""]
        lines += ["## Classes", "", "| class | what it does |", "|---|---|"]
        for name, comment in sorted(self.classes.items()):
            lines.append(f'| <a href="api/class{name}.html">{name}</a> | {cell(comment.brief)} |')
        return lines

    def drawing(self):
        """The modules and their direct dependencies, for graphviz."""
        def reached(folder):
            return {folder}.union(*(reached(needed) for needed in self.modules[folder]))
        lines = ["digraph modules {", "  rankdir=BT; ranksep=0.5; nodesep=0.25;",
                 '  node [shape=box, style="rounded,filled", fontname="sans-serif", fontsize=11];',
                 '  edge [color="#555555", arrowsize=0.7];']
        for folder, needed in self.modules.items():
            colour = "#f3d9b1" if folder in self.gpl else "#cfe3f1"
            lines.append(f'  "{folder}" [fillcolor="{colour}"];')
            for one in needed:
                if not any(one in reached(other) for other in needed if other != one):
                    lines.append(f'  "{folder}" -> "{one}";')
        return "\n".join([*lines, "}", ""])

    def write(self, folder):
        """Writes all pages and the files that they show to folder."""
        self.add_guide()
        self.add_repository()
        for place, text in self.pages.items():
            path = folder / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        for place, source in self.files.items():
            path = folder / place
            path.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, path)
        shutil.copyfile(self.root / GUIDE / "site" / "conf.py", folder / "conf.py")
        (folder / "modules.dot").write_text(self.drawing())


# Pages to whose hand-written part a list is added, and the mark that the drawing of the modules replaces.
GENERATED = {"filters/index.md": Site.list_lines, "python.md": Site.python_lines,
             "gallery.md": Site.scene_lines}
DRAWING = "<!-- the drawing of the modules -->"
