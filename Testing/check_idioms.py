#!/usr/bin/env python3
"""Finds phrases in user-visible text and in headers for which the field has a plainer term.

    check_idioms.py [ROOT] [FILE...]

The list is idioms.tsv beside this file: a pattern (a regular expression, case does not matter, any white
space where it has a blank), a tab, and what to write. Looked at are

- Markdown: all of it but code;
- panels (Plugin/*.xml): help, labels, entries;
- headers of Filters, Readers and Plugin: comments;
- sources of Filters, Readers and Plugin: messages, that is texts of at least three words;
- Python of Examples and Plugin: docstrings and texts of at least three words.

Prints one line for each finding with the replacement; the exit status is 1 if there are any.
"""
import ast
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

HERE = pathlib.Path(__file__).resolve().parent
# Lines of // below each other are one comment.
COMMENT = re.compile(r"//[^\n]*(?:\n[ \t]*//[^\n]*)*|/\*.*?\*/", re.DOTALL)
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|((?:"(?:\\.|[^"\\\n])*"\s*)+)|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)


def read_list(path=HERE / "idioms.tsv"):
    """[(pattern, as written, replacement)]."""
    found = []
    for line in path.read_text().split("\n"):
        if line and not line.startswith("#"):
            pattern, replacement = line.split("\t")
            spaced = re.sub(r" +", r"(?:\\s|[*/|])+", pattern)
            found.append((re.compile(rf"(?<!\w)(?:{spaced})(?!\w)", re.IGNORECASE), pattern, replacement))
    return found


def markdown_texts(text, with_code):
    """(line, text) without blocks of code and addresses of links; code within a line stays on demand."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group(0))
    in_line = "" if with_code else r"`[^`\n]*`|"
    yield 1, re.sub(rf"^```.*?^```|^(?:    .*\n)+|{in_line}\]\([^)\n]*\)", blank, text,
                    flags=re.DOTALL | re.MULTILINE)


def comments(text):
    for match in COMMENT.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, match.group(0)


def messages(text):
    for match in TOKEN.finditer(text):
        if match.group(1):
            joined = "".join(re.findall(r'"((?:\\.|[^"\\\n])*)"', match.group(1)))
            if len(joined.split()) >= 3:
                yield text.count("\n", 0, match.start()) + 1, joined


def panel_texts(text):
    for element in ElementTree.fromstring(text).iter():
        for name in ("label", "short_help", "long_help", "text", "name"):
            if element.get(name):
                yield 1, element.get(name)
        if element.text and element.text.strip():
            yield 1, element.text


def python_texts(text):
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and len(node.value.split()) >= 3:
            yield node.lineno, node.value


def texts_of(path, relative, with_code=False):
    """(line, text) of what users or programmers read in a file; with_code: of Markdown with `code` in a line."""
    first = relative.parts[0]
    library = first in ("Filters", "Readers", "Plugin")
    text = path.read_text()
    if path.suffix == ".md":
        yield from markdown_texts(text, with_code)
    elif path.suffix == ".xml" and first == "Plugin":
        yield from panel_texts(text)
    elif path.suffix == ".h" and library:
        yield from comments(text)
        yield from messages(text)
    elif path.suffix == ".cxx" and library:
        yield from messages(text)
    elif path.suffix == ".py" and first in ("Examples", "Plugin"):
        yield from python_texts(text)


def files_of(root):
    for path in sorted(root.rglob("*")):
        relative = path.relative_to(root)
        if not any(part.startswith((".", "build")) and part != ".github" for part in relative.parts):
            if path.suffix in (".md", ".xml", ".h", ".cxx", ".py") and path.is_file():
                yield path, relative


def check(root, idioms, chosen=()):
    """(complaints, number of texts looked at)."""
    complaints, looked_at = [], 0
    for path, relative in files_of(root):
        if chosen and str(relative) not in chosen:
            continue
        for line, text in texts_of(path, relative):
            looked_at += 1
            for expression, _, replacement in idioms:
                for match in expression.finditer(text):
                    where = line + text.count("\n", 0, match.start())
                    phrase = " ".join(re.sub(r"[*/]{1,3}(?=\s|$)", "", match.group(0)).split())
                    complaints.append(f"{relative}:{where}: {phrase!r}: write {replacement}")
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parent).resolve()
    complaints, looked_at = check(root, read_list(), sys.argv[2:])
    if looked_at == 0:
        complaints.append(f"no text was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} texts looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
