#!/usr/bin/env python3
"""Checks that what pages and comments refer to exists.

    check_links.py [ROOT]

- Each relative link of a page (*.md) leads to a file or folder, and each anchor to a heading.
- Each file that a page or a comment of the library names (`Name.h`, `.cxx`, `.py`, `.md`, `.sh`, `.cmake`) exists,
  or is a header that our code includes.
- Each example and each study is in the README of its folder.

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys

STRING_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\\n])*"|(//[^\n]*|/\*.*?\*/)', re.DOTALL)
FILE = re.compile(r"(?<![\w.*<>{}-])((?:[\w.-]+/)*[A-Za-z_]\w*\.(?:h|cxx|py|md|sh|cmake))(?![\w*(])")
# What stands for any name on the pages that say how files are named.
PLACEHOLDER = re.compile(r"(?:Test|Bench|vtk)?(?:X|NAME)\.\w+$")
LISTED = ("Examples", "Testing/Studies")


def anchor(heading):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors_of(page):
    return {anchor(text) for text in re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)}


def check_page(page):
    """(wrong links, number of links)"""
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    links = [link for link in re.findall(r"\]\(([^)\s]+)\)", text) if not re.match(r"[a-z]+:", link)]
    wrong = []
    for link in links:
        name, _, fragment = link.partition("#")
        target = (page.parent / name) if name else page
        if not target.exists():
            wrong.append(f"{link} leads nowhere")
        elif fragment and fragment not in anchors_of(target):
            wrong.append(f"{link}: no such heading")
    return wrong, len(links)


def comments_of(text):
    """Those of a C++ file; lines that have none are empty."""
    found, place = [], 0
    for match in STRING_OR_COMMENT.finditer(text):
        if match.group(1):
            found += ["\n" * text.count("\n", place, match.start()), match.group(1)]
            place = match.end()
    return "".join(found)


def check(root):
    files = sorted(path for path in root.rglob("*") if path.is_file() and not any(
        part.startswith(("build", ".")) and part != ".github" for part in path.relative_to(root).parts[:-1]))
    code = {path: path.read_text(errors="replace") for path in files if path.suffix in (".h", ".cxx")}
    names = {path.name for path in root.glob(".ci/*")} | {path.name for path in files}
    for text in code.values():
        names.update(re.findall(r'#\s*include\s*[<"](?:[^>"]*/)?([^/>"]+)[>"]', text))
    complaints, looked_at = [], 0
    for path in files:
        place = path.relative_to(root)
        is_page = path.suffix == ".md"
        if is_page:
            wrong, number = check_page(path)
            complaints += [f"{place}: {what}" for what in wrong]
            looked_at += number
        elif path not in code or place.parts[0] not in ("Filters", "Readers", "Plugin"):
            continue
        for number, line in enumerate((path.read_text() if is_page else comments_of(code[path])).split("\n"), 1):
            complaints += [f"{place}:{number} names {name}, which does not exist" for name in FILE.findall(line)
                           if pathlib.PurePath(name).name not in names
                           and not (is_page and PLACEHOLDER.match(pathlib.PurePath(name).name))]
    for folder in LISTED:
        page = root / folder / "README.md"
        text = page.read_text() if page.exists() else ""
        complaints += [f"{folder}/README.md has no line for {path.name}"
                       for path in sorted((root / folder).glob("*.py")) if path.name not in text]
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no link was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} links checked, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
