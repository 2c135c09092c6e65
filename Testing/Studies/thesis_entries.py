"""The entries of the PDB and the EMDB that the thesis uses, by id: thesis.py --fetch FOLDER downloads them.

    python3 thesis_entries.py FOLDER [--from URL] [ID ...]

Each entry becomes a file in FOLDER; existing files are not downloaded again. FOLDER/checksums.tsv has the SHA-256
of each: a file with another checksum is an error and is not changed. If the checksum used for the guide's page is
recorded below, a difference is reported, since archives revise entries. --from URL  takes the files from URL/NAME
instead, as a mirror or a folder (file:///...) has them. Exit status: 0, or 1 where an entry is missing or differs.
"""
import gzip
import hashlib
import pathlib
import sys
import urllib.error
import urllib.request

PDB = "https://files.rcsb.org/download/{name}"
EMDB = "https://files.wwpdb.org/pub/emdb/structures/{id}/map/{name}"
SECONDS = 60.0
# {id: (name of its file, its use in the thesis)}
ENTRIES = {
    "1HEW": ("1HEW.pdb", "lysozyme: chapters 4 and 5"),
    "1ADS": ("1ADS.pdb", "Figures 4.17 and 4.23"),
    "1BYH": ("1BYH.pdb", "Figures 4.17 and 4.23"),
    "1EJN": ("1EJN.pdb", "Figures 4.17 and 4.23"),
    "2WEB": ("2WEB.pdb", "Figures 4.17 and 4.23"),
    "1MAG": ("1MAG.pdb", "gramicidin: Table 6.1, Figure 6.11"),
    "1PPL": ("1PPL.pdb", "Figure 5.6"),
    "2KIX": ("2KIX.pdb", "a channel: Figure 6.10"),
    **{f"EMD-{number}": (f"emd_{number}.map.gz", what) for number, what in (
        (1048, "Figures 4.2 and 4.7"), (1129, "Figures 4.2 and 4.7"), (1265, "Figures 4.2 and 4.7"),
        (1590, "chapter 4"), (1617, "Figures 4.2 and 4.7"), (5119, "Figures 4.2 and 4.7"),
        (5020, "Figure 5.8"), (5273, "Figure 5.7"))},
}
# Checksums of the copies used for the page; the other entries were not available.
RECORDED = {
    "1HEW": "6c164082deb21262d63948c2ffa0c68157d5032f12922204459251d1c0d63541",
    "2KIX": "c0fc81a3bc5c1e3d8a02f4f810dd8061ed09ca85917b825828ca76676b1c348a",
}
LOCK = "checksums.tsv"


def url_of(entry, base=None):
    name = ENTRIES[entry][0]
    if base:
        return f"{base.rstrip('/')}/{name}"
    return (EMDB if entry.startswith("EMD-") else PDB).format(id=entry, name=name)


def checksum(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def locked(folder):
    """{name: checksum} of the lock file."""
    path = folder / LOCK
    lines = path.read_text().splitlines() if path.exists() else []
    return dict(line.split("\t")[:2] for line in lines if line and not line.startswith("#"))


def write_lock(folder, sums):
    text = "# name\tSHA-256 when it was downloaded\n"
    (folder / LOCK).write_text(text + "".join(f"{name}\t{value}\n" for name, value in sorted(sums.items())))


def is_whole(name, content):
    """Whether a download has the expected type, since archives sometimes return an HTML page."""
    if name.endswith(".gz"):
        try:
            return len(gzip.decompress(content)) > 1024
        except (OSError, EOFError):
            return False
    return any(content.startswith(word) or b"\n" + word in content for word in (b"HEADER", b"ATOM", b"CRYST1"))


def download(entry, folder, base):
    """Downloads the file of an entry; on failure nothing is written. Raises OSError with a reason."""
    name = ENTRIES[entry][0]
    url = url_of(entry, base)
    try:
        with urllib.request.urlopen(url, timeout=SECONDS) as answer:
            content = answer.read()
    except urllib.error.HTTPError as error:
        raise OSError(f"{url}: {error.code} {error.reason}") from error
    except (urllib.error.URLError, TimeoutError) as error:
        raise ConnectionError(f"{url}: {getattr(error, 'reason', error)}") from error
    if not is_whole(name, content):
        raise OSError(f"{url}: the download is not a {'packed map' if name.endswith('.gz') else 'PDB file'}")
    part = folder / (name + ".part")
    part.write_bytes(content)
    part.replace(folder / name)


def check(entry, path, sums):
    """(whether it is unchanged, message)"""
    found = checksum(path)
    known = sums.setdefault(path.name, found)
    if found != known:
        return False, f"{found}, but {LOCK} has {known}: remove the file to download it again"
    if entry in RECORDED and found != RECORDED[entry]:
        return True, f"{found} (another revision than that of the guide's page, {RECORDED[entry][:16]}...)"
    return True, found + (" (as recorded)" if entry in RECORDED else "")


def fetch(folder, base=None, entries=None):
    """Downloads the missing entries and returns the exit status."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    sums, failed, reasons = locked(folder), 0, {}
    for entry in entries or ENTRIES:
        path = folder / ENTRIES[entry][0]
        try:
            if not path.exists():
                sums.pop(path.name, None)
                download(entry, folder, base)
            good, said = check(entry, path, sums)
        except OSError as error:
            good, said = False, f"not fetched: {error}"
            reasons.setdefault(isinstance(error, ConnectionError), []).append(entry)
        failed += not good
        print(f"{entry:8} {ENTRIES[entry][0]:16} {said}", flush=True)
    write_lock(folder, sums)
    if len(reasons.get(True, [])) == len(entries or ENTRIES):
        print(f"There is no way to {base or 'the archives'} from here: connect to a network, or name a mirror or folder "
              "by --from URL. thesis.py uses the substitutes that it names.")
    return 1 if failed else 0


def path_of(entry, folder):
    """The file of an entry, if it exists."""
    path = pathlib.Path(folder) / ENTRIES[entry][0] if folder else None
    return str(path) if path and path.exists() else None


def main(words):
    if not words or "--help" in words or "-h" in words:
        print(__doc__)
        return 0 if words else 1
    base = None
    if "--from" in words:
        at = words.index("--from")
        base = words[at + 1]
        del words[at:at + 2]
    folder, *entries = words
    entries = [word.upper() for word in entries]
    unknown = [word for word in entries if word not in ENTRIES]
    if unknown:
        print(f"There is no {', '.join(unknown)}; there are: {', '.join(ENTRIES)}.")
        return 1
    return fetch(folder, base, entries)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
