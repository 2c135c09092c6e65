"""The significant choking loops of GroEL (EMD-5043): handles, tunnels and bottlenecks around the narrow places of the map.

Usage: pvpython loops_of_groel.py [FOLDER]. FOLDER: for the figure (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write

from isthmus_plugin import pipelines

view = new_view()
pipelines.show(*pipelines.map_to_loops(data("maps/emd_5043.map"), significant=True), view=view)
look_from(view, (0.2, -0.4, 1.0), 1.3)
write(view, "loops_of_groel", silhouettes=False)
