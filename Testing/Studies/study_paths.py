"""For the studies: the modules of Examples can be imported, and `import isthmus` works with PV_PLUGIN_PATH alone."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[2] / "Examples"))
import find_isthmus  # noqa: E402,F401
