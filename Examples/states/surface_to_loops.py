"""A closed surface with its choking loops: a state for File > Load State, or for paraview --state=.

Opens the file $ISTHMUS_FILE, or else surfaces/torus.obj in $ISTHMUS_DATA_DIR. The plugin must be loaded.
"""

import paraview.simple  # noqa: F401 (the plugin's modules come with it)

from isthmus_plugin import pipelines

pipelines.state("surface_to_loops", "surfaces/torus.obj")
