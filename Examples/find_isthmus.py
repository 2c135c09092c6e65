"""Makes `import isthmus` work if only PV_PLUGIN_PATH is set, since the Python package is beside that folder."""

import importlib.util
import os
import sys
from pathlib import Path

if importlib.util.find_spec("isthmus") is None:
    for plugins in os.environ.get("PV_PLUGIN_PATH", "").split(os.pathsep):
        for above in Path(plugins).resolve().parents:
            sys.path += [str(found) for found in above.glob("python3*/site-packages") if (found / "isthmus").is_dir()]
    if importlib.util.find_spec("isthmus") is None:
        sys.exit("The Python package isthmus is not found: set PV_PLUGIN_PATH to the folder of the plugin "
                 "(build/lib/isthmus/plugins), or PYTHONPATH to that of the package.")
