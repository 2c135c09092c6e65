"""A map's closed surface: a state for File > Load State, or for paraview --state=.

Opens the file $ISTHMUS_FILE, or else maps/emd_5043.map in $ISTHMUS_DATA_DIR. The plugin must be loaded.
"""

import paraview.simple  # noqa: F401 (the plugin's modules come with it)

from isthmus_plugin import pipelines

pipelines.state("map_to_surface", "maps/emd_5043.map")
