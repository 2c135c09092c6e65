"""Examples/thesis.py: tables that can be exact are, and the page of the guide has what the script prints."""

import os
import re
import sys
from pathlib import Path

sys.path.insert(0, os.environ["ISTHMUS_EXAMPLES_DIR"])
import thesis  # noqa: E402

PAGE = (Path(os.environ["ISTHMUS_EXAMPLES_DIR"]) / "guide/thesis.md").read_text()
# Deviations in percent that the table may have: printed digits, or one digit that the thesis cut off.
EXACT = {"3.8": None, "4.1": 0.15, "5.2": 0.02, "5.3": 0.04, "5.5": 0.04}


def page_of(key):
    found = re.search(rf"<!-- thesis\.py {re.escape(key)} -->\n(.*?)<!-- end -->", PAGE, re.DOTALL)
    assert found, f"the page has no place for {key}"
    return found[1]


for key in thesis.TABLES:
    assert "|---|" in page_of(key), f"{key} is empty in the page: thesis.py {key} --page Examples/guide/thesis.md"
for key, largest in EXACT.items():
    lines = thesis.TABLES[key][1]()
    assert "\n".join(lines) + "\n" == page_of(key), f"{key} differs from the page:\n" + "\n".join(lines)
    deviations = [abs(float(text)) for text in re.findall(r", ([+-][\d.]+) %\)", "\n".join(lines))]
    assert len(deviations) >= 4, f"{key}: {len(deviations)} deviations"
    assert largest is None or max(deviations) <= largest, f"{key}: {max(deviations)} %"
    print(f"{key}: {len(deviations)} values, at most {max(deviations)} %")
edges = thesis.TABLES["3.6"][1]()
assert any("the same" in line for line in edges), edges
assert "| 9 | 9 |" in "\n".join(edges) and "| 0, 4, 7, 9, 12, 14, -, - | 0, 4, 7, 9, 12, 14, -, - |" in "\n".join(edges)
# All tables of the thesis are computed or named.
numbered = [f"3.{k}" for k in range(1, 10)] + [f"4.{k}" for k in range(1, 9)] + [f"5.{k}" for k in range(1, 8)] + ["6.1"]
shared = {"4.5", "5.4", "5.6"}  # with the one before
missing = [key for key in numbered if key not in thesis.TABLES and key not in thesis.NOT_HERE and key not in shared]
assert not missing, missing
