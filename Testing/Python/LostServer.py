"""Clients of one pvserver in turn, and a pvserver that is killed in the middle of a filter: its client reports
that and ends without a result and without a signal, and the next server serves as before.
"""

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

PATIENCE = 120  # seconds, on a machine with other things to do
OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"])
CLIENT = """
import os
import sys
from paraview import simple
simple.Connect("localhost", int(sys.argv[1]))
wavelet = simple.Wavelet(WholeExtent=[-{half}, {half}, -{half}, {half}, -{half}, {half}])
wavelet.UpdatePipeline()
os.write(1, b"CONNECTED\\n")  # at once: flush=True does nothing in pvpython 5.13
if {waits}:
    sys.stdin.readline()
denoised = simple.HighOrderDiffusion(Input=wavelet, Time=5.0, Steps={steps})
os.write(1, b"FILTER\\n")
denoised.UpdatePipeline()
print("POINTS", denoised.GetDataInformation().GetNumberOfPoints(), flush=True)
"""


def served(*options):
    """A server that listens, and its port."""
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        port = probe.getsockname()[1]
    log = OUTPUT / "LostServer.log"
    with log.open("w") as sink:
        server = subprocess.Popen(["pvserver", f"--server-port={port}", *options], stdout=sink, stderr=sink)
    started = time.monotonic()
    while "Accepting connection" not in log.read_text(errors="replace"):
        if server.poll() is not None or time.monotonic() - started > PATIENCE:
            sys.exit(f"pvserver does not listen: {log.read_text(errors='replace')}")
        time.sleep(0.2)
    return server, port


def client(name, port, half=8, steps=2, waits=False):
    script = OUTPUT / f"LostServer_{name}.py"
    script.write_text(CLIENT.format(half=half, steps=steps, waits=waits))
    return subprocess.Popen(["pvpython", str(script), str(port)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True)


def wait_for(process, word):
    """Reads what a client says up to that word."""
    said = ""
    for line in process.stdout:
        said += line
        if word in line:
            return
    sys.exit(f"the client ended before {word}: {said}")


def check_works(process, who):
    said, _ = process.communicate("go\n", timeout=PATIENCE)
    assert process.returncode == 0 and f"POINTS {17 ** 3}" in said, (who, process.returncode, said)


# A server of several clients ends when the last one leaves: the first one stays while others come and go.
server, port = served("--multi-clients")
try:
    first = client("first", port, waits=True)
    wait_for(first, "CONNECTED")
    for number in range(2):
        check_works(client(f"turn{number}", port), number)
        assert server.poll() is None, "the server ended with a client"
    check_works(first, "first")
finally:
    server.kill()
    server.wait()

server, port = served()
try:
    lost = client("lost", port, half=50, steps=100000)
    wait_for(lost, "FILTER")
    time.sleep(2.0)
    assert server.poll() is None and lost.poll() is None
finally:
    server.kill()
    server.wait()
said, _ = lost.communicate(timeout=PATIENCE)
assert lost.returncode >= 0, f"the client ended by signal {-lost.returncode}: {said}"
assert "ERR|" in said and "ocket" in said, f"the client does not say that the server is gone: {said}"
assert f"POINTS {101 ** 3}" not in said, f"a result without a server: {said}"

server, port = served()
try:
    check_works(client("next", port), "next")
finally:
    server.kill()
    server.wait()
print("clients in turn: passed; lost server: reported")
