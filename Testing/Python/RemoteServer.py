"""The six pipelines of the toolbar on a remote server: pvserver in a process of its own, this one its
client. What they give must be what they give without a server.
"""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

from paraview import simple
from shared_data import shared_data

from isthmus_plugin import pipelines  # there once paraview.simple has loaded the plugin

PATIENCE = 120  # seconds for a server to listen, on a machine with other things to do
PROTEIN = "molecules/1AJJ_pH7_PARSE.pqr"
SIX = (
    ("map_to_surface", "maps/emd_1832.map"), ("map_to_curvature", "maps/emd_1832.map"),
    ("map_to_loops", "maps/emd_1832.map"), ("protein_to_surface", PROTEIN),
    ("protein_to_sites", PROTEIN), ("surface_to_loops", "surfaces/torus.obj"))


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def wait_for(server, log):
    started = time.monotonic()
    while "Accepting connection" not in log.read_text(errors="replace"):
        if server.poll() is not None or time.monotonic() - started > PATIENCE:
            sys.exit(f"pvserver does not listen: {log.read_text(errors='replace')}")
        time.sleep(0.5)


def run_all():
    """For each pipeline the points and cells of its last proxy, and what colours it first."""
    found = {}
    for function, data in SIX:
        source = simple.OpenDataFile(str(shared_data(data)))
        proxies = getattr(pipelines, function)(source)
        display = pipelines.show(*proxies)
        simple.Render()
        information = proxies[-1].GetDataInformation()
        found[function] = (information.GetNumberOfPoints(), information.GetNumberOfCells(),
                           display.ColorArrayName[1])
        print(function, *found[function], flush=True)
        for proxy in list(simple.GetSources().values()):
            simple.Delete(proxy)
    return found


here = run_all()
assert all(points > 0 and cells > 0 for points, cells, _ in here.values()), here
log = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "RemoteServer.log"
port = free_port()
with log.open("w") as sink:
    server = subprocess.Popen(
        ["pvserver", f"--server-port={port}", "--force-offscreen-rendering"], stdout=sink, stderr=sink)
try:
    wait_for(server, log)
    simple.Connect("localhost", port)
    assert simple.servermanager.ActiveConnection.IsRemote()
    there = run_all()
    simple.Disconnect()
finally:
    server.kill()
    server.wait()
assert there == here, (there, here)
said = [line for line in log.read_text(errors="replace").splitlines()
        if "ERR|" in line or "WARN|" in line]
assert not said, "\n".join(said)
print("the same on a remote server")
