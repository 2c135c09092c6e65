"""Choose the map of the example: prints its path on stdout, and why on stderr.

Usage: choose_map.py FOLDER [MAP]. Without MAP, the first of: EMD-5043 in $ISTHMUS_DATA_DIR/maps or
../shared/data/maps, a download of it from the EMDB archive, a phantom. The last two go to FOLDER.
"""

import gzip
import os
import struct
import sys
import urllib.request
from pathlib import Path

import numpy

EMDB = "https://ftp.ebi.ac.uk/pub/databases/emdb/structures/EMD-5043/map/emd_5043.map.gz"
MAP_BYTES = 1024 + 4 * 100**3


def is_emd_5043(content):
    """True if the file is complete and has 100 x 100 x 100 float32 nodes, like EMD-5043."""
    return (
        len(content) == MAP_BYTES
        and struct.unpack("<4i", content[:16]) == (100, 100, 100, 2)
        and content[208:212] == b"MAP "
    )


def download(target):
    """EMD-5043 from the EMDB archive (or $ISTHMUS_EMDB_URL); a message if the download fails."""
    url = os.environ.get("ISTHMUS_EMDB_URL", EMDB)
    try:
        with urllib.request.urlopen(url, timeout=20) as answer:
            content = gzip.decompress(answer.read())
    except (OSError, EOFError, ValueError) as error:
        return f"not downloaded from {url}: {error}"
    if not is_emd_5043(content):
        return f"what {url} sent is not EMD-5043: wrong size or header"
    target.write_bytes(content)
    return None


def write_phantom(target):
    """Two stacked seven-fold rings of Gaussian blobs, GroEL's architecture, as a small MRC map."""
    count, spacing = 80, 3.0
    axis = (numpy.arange(count) - (count - 1) / 2) * spacing
    z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
    density = numpy.zeros((count, count, count))
    for height, turn in ((-30.0, 0.0), (30.0, 0.5)):
        for blob in range(7):
            angle = 2 * numpy.pi * (blob + turn) / 7
            center = 50 * numpy.cos(angle), 50 * numpy.sin(angle)
            squared = (x - center[0]) ** 2 + (y - center[1]) ** 2 + ((z - height) / 1.4) ** 2
            density += numpy.exp(-squared / (2 * 16.0**2))
    header = bytearray(1024)
    struct.pack_into("<10i", header, 0, *[count] * 3, 2, 0, 0, 0, *[count] * 3)
    struct.pack_into("<6f3i", header, 40, *[count * spacing] * 3, 90, 90, 90, 1, 2, 3)
    struct.pack_into("<3fi", header, 76, density.min(), density.max(), density.mean(), 1)
    struct.pack_into("<3f4s4Bf", header, 196, *[axis[0]] * 3, b"MAP ", 0x44, 0x44, 0, 0, density.std())
    target.write_bytes(header + density.astype("<f4").tobytes())


def choose(folder, given):
    """The path of the map and a sentence that describes it."""
    if given:
        return given, f"{given}, as given"
    here = Path(__file__).resolve().parent.parent
    for data in filter(None, (os.environ.get("ISTHMUS_DATA_DIR"), here.parent / "shared" / "data")):
        path = Path(data) / "maps" / "emd_5043.map"
        if path.exists():
            return path, f"EMD-5043 (GroEL) in {path}"
    target = folder / "emd_5043.map"
    if target.exists() and is_emd_5043(target.read_bytes()):
        return target, f"EMD-5043 (GroEL), downloaded before to {target}"
    failure = download(target)
    if failure is None:
        return target, f"EMD-5043 (GroEL), downloaded to {target}"
    target = folder / "phantom.mrc"
    write_phantom(target)
    return target, f"a phantom of two seven-fold rings, since EMD-5043 was {failure}"


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(__doc__)
        sys.exit(len(sys.argv) < 2)
    output = Path(sys.argv[1])
    output.mkdir(parents=True, exist_ok=True)
    chosen, reason = choose(output, sys.argv[2] if len(sys.argv) > 2 else None)
    print(f"Map: {reason}", file=sys.stderr)
    print(chosen)
