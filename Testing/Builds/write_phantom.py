"""The example's phantom. Usage: write_phantom.py EXAMPLES_FOLDER FILE"""

import sys
from pathlib import Path

sys.path.insert(0, sys.argv[1])
import choose_map  # noqa: E402

choose_map.write_phantom(Path(sys.argv[2]))
