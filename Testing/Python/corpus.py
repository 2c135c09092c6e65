"""Corpora of files for MoleculeCorpus.py, GridCorpus.py and MeshCorpus.py: each suite of files is a folder of
ISTHMUS_CORPUS_DIR. Lists in Testing/Data name where each file comes from, and explain what differs."""

import collections
import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def folder():
    """The corpus; without one the test is skipped."""
    given = os.environ.get("ISTHMUS_CORPUS_DIR")
    if not given:
        print("set ISTHMUS_CORPUS_DIR to a folder of files, as Testing/Data/*_corpus.txt list them")
        sys.exit(77)
    return Path(given)


def extension(path):
    return Path(path.name.removesuffix(".gz").removesuffix(".bz2")).suffix[1:].lower()


def files(corpus, extensions):
    """Those of the corpus with such extensions; without any the test is skipped."""
    found = sorted(p for p in corpus.rglob("*") if p.is_file() and extension(p) in extensions)
    if not found:
        print(f"{corpus} has no file of these kinds: {' '.join(extensions)}")
        sys.exit(77)
    return found


def peers(script, paths):
    """Of each path, what the other readers find that `script` runs."""
    python = os.environ.get("ISTHMUS_CORPUS_PYTHON") or shutil.which("python3") or sys.executable
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    answers = {}
    rest = [str(path) for path in paths]
    while rest:
        done = subprocess.run([python, str(HERE / script)], text=True, env=environment,
                              input="".join(f"{path}\n" for path in rest), stdout=subprocess.PIPE)
        count = 0
        for line in done.stdout.splitlines():
            if line.startswith("@"):
                answer = json.loads(line[1:])
                known = answers.setdefault(answer["path"], {})
                if "peer" in answer:
                    known[answer["peer"]] = answer["found"]
                else:
                    count += 1
        assert count > 0 or done.returncode < 0, "the other readers do not start: see above"
        rest = rest[count + 1:]  # where a reader crashed, with what the readers before it have found
    return answers


def explanations(name):
    """Reasons by the end of a path, from lines 'differs PATH: reason' of a list."""
    reasons = {}
    for line in (HERE.parent / "Data" / name).read_text().splitlines():
        if line.startswith("differs "):
            path, reason = line[len("differs "):].split(": ", 1)
            reasons[path] = reason
    return reasons


def explanation(reasons, name):
    return next((why for end, why in reasons.items() if str(name).endswith(end)), None)


def check_files(corpus, name):
    """Names files of a list with checksums that the corpus lacks, or has with other contents."""
    listed = {}
    suite = ""
    for line in (HERE.parent / "Data" / name).read_text().splitlines():
        words = line.split(" ", 1)
        if words[0] == "suite":
            suite = words[1].split()[0]
        elif len(words[0]) == 64:
            listed[f"{suite}/{words[1]}"] = words[0]
    for path, checksum in listed.items():
        file = corpus / path
        if not file.exists():
            print(f"{path}: listed in {name}, not in the corpus")
        elif hashlib.sha256(file.read_bytes()).hexdigest() != checksum:
            print(f"{path}: not the file listed in {name}")


class Table:
    """How many files of each suite agree, and what does not."""

    def __init__(self, corpus, reasons, columns=()):
        self.corpus, self.reasons, self.columns = corpus, reasons, columns
        self.rows = collections.defaultdict(collections.Counter)
        self.unexplained, self.files = [], 0

    def add(self, path, kind, problem="", quantities=()):
        """`kind`: agree, message (refused by all), only Isthmus; or with a problem: refused, differ."""
        name = path.relative_to(self.corpus)
        row = self.rows[name.parts[0] if len(name.parts) > 1 else "."]
        row["files"] += 1
        self.files += 1
        row.update(quantities)
        if problem:
            reason = explanation(self.reasons, name)
            print(f"{name}: {problem}" + (f" [{reason}]" if reason else ""), flush=True)
            if reason:
                kind = "explained"
            else:
                self.unexplained.append(str(name))
        row[kind] += 1

    def finish(self):
        """Prints the table; at most 1 % of the files may differ without an explanation."""
        columns = ("files", "agree", "explained", "message", "only Isthmus", "refused", "differ")
        columns += tuple(self.columns)
        print("| suite | " + " | ".join(columns) + " |\n|---|" + "---|" * len(columns))
        for suite, row in sorted(self.rows.items()):
            print(f"| {suite} | " + " | ".join(str(row[column]) for column in columns) + " |")
        assert len(self.unexplained) <= 0.01 * self.files, (
            f"{len(self.unexplained)} of {self.files}: {self.unexplained}")


def compare(quantities, ours, theirs, same=lambda quantity, a, b: a == b):
    """Of each quantity True (a peer finds the same), False, or None where no peer gives it."""
    found = {}
    for quantity in quantities:
        values = [t[quantity] for t in theirs.values() if quantity in t]
        found[quantity] = (None if not values else
                           any(same(quantity, value, ours.get(quantity)) for value in values))
    return found


def difference(quantities, ours, theirs, found):
    """A sentence about what differs."""
    return "; ".join(
        f"{quantity} {ours.get(quantity)} (" + ", ".join(
            f"{peer} {values[quantity]}" for peer, values in theirs.items() if quantity in values) + ")"
        for quantity in quantities if found[quantity] is False)


def add(table, path, ours, theirs, quantities, same=lambda quantity, a, b: a == b):
    """Compares what Isthmus finds in a file, or its message, with the findings of peers."""
    readable = {peer: found for peer, found in theirs.items()
                if isinstance(found, dict) and found.get("atoms", 1)}
    if isinstance(ours, str):
        table.add(path, "refused" if readable else "message", f"refused: {ours}" if readable else "")
        if not readable:
            print(f"{path.relative_to(table.corpus)}: no reader: {ours}", flush=True)
    elif not readable:
        table.add(path, "only Isthmus")
        print(f"{path.relative_to(table.corpus)}: only Isthmus: {ours}", flush=True)
    else:
        found = compare(quantities, ours, readable, same)
        problem = difference(quantities, ours, readable, found)
        table.add(path, "differ" if problem else "agree", problem,
                  [quantity for quantity in quantities if found[quantity] is not False])


def errors_of_update(reader):
    """Updates a reader and returns the text of its errors, empty without any; warnings are not shown."""
    messages = []

    def keep(caller, event, message=""):
        messages.append(message)

    keep.CallDataType = "string0"
    reader.AddObserver("ErrorEvent", keep)
    reader.AddObserver("WarningEvent", lambda *_: None)
    reader.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    reader.Update()
    return " ".join(messages).split("): ", 1)[-1].strip()
