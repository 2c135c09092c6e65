"""The output folder of the examples: the given folder, or else a new temporary one."""

import tempfile
from pathlib import Path


def output_folder(named=None):
    """The given folder, which is created if necessary; without a name, a new temporary folder, so that no file of
    the user is overwritten."""
    if not named:
        return Path(tempfile.mkdtemp(prefix="isthmus-"))
    folder = Path(named).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    return folder
