#!/usr/bin/env python3
"""Checks that every relative link of the READMEs leads to a file, and each anchor to a heading.

    check_links.py [ROOT]

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys


def anchor(heading):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors_of(page):
    return {anchor(text) for text in re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)}


def links_of(page):
    text = re.sub(r"```.*?```", "", page.read_text(), flags=re.DOTALL)
    return re.findall(r"\]\(([^)\s]+)\)", text)


def check(root):
    complaints, looked_at = [], 0
    for page in sorted(root.rglob("*.md")):
        if any(part.startswith(("build", ".")) for part in page.relative_to(root).parts):
            continue
        for link in links_of(page):
            if re.match(r"[a-z]+:", link):
                continue
            looked_at += 1
            name, _, fragment = link.partition("#")
            target = (page.parent / name) if name else page
            if not target.exists():
                complaints.append(f"{page.relative_to(root)}: {link} leads nowhere")
            elif fragment and fragment not in anchors_of(target):
                complaints.append(f"{page.relative_to(root)}: {link}: no such heading")
    return complaints, looked_at


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    complaints, looked_at = check(root)
    if looked_at == 0:
        complaints.append(f"no link was found under {root}")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} links looked at, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
