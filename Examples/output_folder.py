"""Where the examples write: into the folder that is named, or else into a new temporary one."""

import tempfile
from pathlib import Path


def output_folder(named=None):
    """The folder `named`, made if necessary; without a name a new one among the system's temporary
    folders, so that nothing of the user's is overwritten."""
    if not named:
        return Path(tempfile.mkdtemp(prefix="isthmus-"))
    folder = Path(named).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    return folder
