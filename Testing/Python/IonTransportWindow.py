"""Ion Transport in the real ParaView: a tube of atoms opened, the entry of the menu, Apply. What shows is
the potential on a cut along the channel, upright, beside the table with the current.

The picture of the window is kept beside the test's other output; the log must have no warning.
"""

import math
import os
from pathlib import Path

import numpy
from window_play import APPLY, complaints, entry, pixels_of_view, play

PAUSE = ("pqClientMainWindow", "pause", "3000")
EDGE = 520  # pixels of the view beside the table

output = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"]) / "IonTransportWindow"
output.mkdir(parents=True, exist_ok=True)
tube = output / "tube.pqr"
with tube.open("w") as file:
    for ring in range(13):
        for n in range(8):
            angle = 2.0 * math.pi * n / 8
            file.write(f"ATOM  {8 * ring + n + 1:5d}  C   TUB A   1    {4.5 * math.cos(angle):8.3f}"
                       f"{4.5 * math.sin(angle):8.3f}{2.0 * ring - 12.0:8.3f} {0.5 * (n % 2) - 0.3:7.4f} 1.7000\n")

log, picture = play("channel", tube, [entry("IonTransport"), APPLY, PAUSE], (), output / "channel")
assert "Success =  true" in log, f"the session could not be played: {log[-2000:]}"
assert not complaints(log), complaints(log)
view = pixels_of_view(picture)[:, :EDGE]
red = float(numpy.mean(view[:, :, 0] - view[:, :, 2] > 90))
blue = view[:, :, 2] - view[:, :, 0] > 60
print(f"{100 * red:.1f} % of the view is red, {100 * blue.mean():.1f} % blue, {picture}")
assert red > 0.05, f"the negative wall does not show in {picture}"
# A positive voltage: the bath below the membrane is the higher one, on a picture that stands upright.
upper, lower = numpy.array_split(blue, 2)[::-1]
assert lower.mean() > 0.05 > upper.mean(), f"the channel does not stand upright in {picture}"
