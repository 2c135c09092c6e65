"""The location of the real maps and proteins, which are not part of the repository."""

import os
import sys
from pathlib import Path


def shared_data(relative):
    """Path of `relative` in the shared data; ends the test (skipped, failed in CI) without it."""
    folder = os.environ.get("ISTHMUS_DATA_DIR") or os.environ["ISTHMUS_DEFAULT_DATA_DIR"]
    path = Path(folder) / relative
    if path.exists():
        return path
    print(f"needs {relative} of the shared data: set ISTHMUS_DATA_DIR")
    sys.exit(1 if os.environ.get("ISTHMUS_REQUIRE_DATA") == "1" else 77)
