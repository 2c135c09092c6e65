"""Potential, polarized curvature and binding sites of a protein with charges: a state for File > Load State, or for paraview --state=.

Opens the file $ISTHMUS_FILE, or else molecules/1hew/1hew.pqr in $ISTHMUS_DATA_DIR. The plugin must be loaded.
"""

import paraview.simple  # noqa: F401 (the plugin's modules come with it)

from isthmus_plugin import pipelines

pipelines.state("protein_to_sites", "molecules/1hew/1hew.pqr")
