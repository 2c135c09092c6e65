"""Checks that each internal link, picture and script of a built site leads to a file and to an anchor."""

from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class Page(HTMLParser):
    """The links and the anchors of one page."""

    def __init__(self):
        super().__init__()
        self.links, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if value and name in ("href", "src"):
                self.links.append(value)
            elif value and (name == "id" or (name == "name" and tag == "a")):
                self.anchors.add(value)


def read(path):
    page = Page()
    page.feed(path.read_text(errors="replace"))
    return page


def check(folder):
    """(complaints, number of links checked)."""
    known = {path: read(path) for path in sorted(Path(folder).rglob("*.html"))}
    complaints, looked_at = [], 0
    for path, page in known.items():
        if "mathjax" in path.parts:
            continue
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc or link.startswith(("javascript:", "#\\")):
                continue
            looked_at += 1
            name, fragment = unquote(parts.path), unquote(parts.fragment)
            target = (path.parent / name).resolve() if name else path.resolve()
            if target.is_dir():
                target = target / "index.html"
            where = path.relative_to(folder)
            if not target.exists():
                complaints.append(f"{where}: {link} leads nowhere")
            elif fragment and target.suffix == ".html" and "/api/" not in str(path):
                anchors = known[target].anchors if target in known else read(target).anchors
                if fragment not in anchors:
                    complaints.append(f"{where}: {link}: no such anchor")
    return complaints, looked_at
