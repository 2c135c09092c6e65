"""fit_nonpolar.py: parameters that the energies were made with come back; on measured alkanes it does as well as the
fit of NonpolarSolvation.py."""

import contextlib
import io
import os
import re
import sys
from pathlib import Path

sys.path.insert(0, os.environ["ISTHMUS_STUDIES_DIR"])
import fit_nonpolar  # noqa: E402
from shared_data import shared_data  # noqa: E402

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"])
FOLDER = Path(shared_data("molecules/apbs/alkanes"))
MEASURED = {"methane": 2.00, "propane": 2.00, "pentane": 2.30, "isobutane": 2.30, "neopentane": 2.51, "cyclohexane": 1.23}
TENSION, PRESSURE = 0.05, 0.03


def fitted(energies, *options):
    table = OUTPUT / "alkanes.csv"
    table.write_text("file,energy\n# kcal/mol\n" + "".join(
        f"{os.path.relpath(FOLDER / name, OUTPUT)}.pdb,{energy!r}\n" for name, energy in energies.items()))
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        fit_nonpolar.main([str(table), "--spacing", "0.4", *options])
    text = said.getvalue()
    values = [float(value) for value in re.findall(r"(?:SurfaceTension|Pressure) ([-\d.]+)", text)]
    rms = [float(value) for value in re.findall(r"(?:fit|others) ([\d.]+)", text.splitlines()[-3])]
    return (*values, *rms), text


parts = {name: fit_nonpolar.terms(FOLDER / f"{name}.pdb", 0.4) for name in MEASURED}
(tension, pressure, within, out), text = fitted(
    {name: TENSION * a + PRESSURE * v + d for name, (a, v, d) in parts.items()})
assert abs(tension - TENSION) < 1e-5 and abs(pressure - PRESSURE) < 1e-5 and out < 1e-3, text
(tension, pressure, within, out), _ = fitted({name: TENSION * a + d for name, (a, v, d) in parts.items()}, "--no-pressure")
assert abs(tension - TENSION) < 1e-5 and pressure == 0.0 and within < 1e-3
(tension, pressure, within, out), text = fitted(MEASURED)
print(text)
assert 0.0 < tension < 0.2 and within < 0.4 and within < out, text
for wrong, said in (({"methane": 2.0}, "takes at least 4"), ({}, "has 0 molecules")):
    try:
        fitted(wrong)
    except SystemExit as ended:
        assert said in str(ended), ended
        continue
    raise AssertionError(f"{wrong} was fitted")
