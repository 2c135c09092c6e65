"""The mean curvature of a map (EMD-5170) on its surface.

Usage: pvpython curvature_of_map.py [FOLDER]. FOLDER: for the figure (PNG and SVG); default: a temporary one.
"""

from common import data, look_from, new_view, write

from isthmus_plugin import pipelines

view = new_view()
pipelines.show(*pipelines.map_to_curvature(data("maps/emd_5170.map")), view=view)
look_from(view, (0.0, -1.0, 0.4), 0.95)
write(view, "curvature_of_map", silhouettes=False)
