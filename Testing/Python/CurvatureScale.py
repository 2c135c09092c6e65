"""The automatic scale of Hessian Curvature: as good as the best fixed one, with errors as stated; the same by
hand, by button, in scripts and in state files.

The whole table is that of Testing/Studies/evaluate_curvature.py.
"""

import os
import sys
from pathlib import Path

import isthmus  # noqa: F401 (the classes behind the proxies)
from paraview import simple

sys.path.insert(0, os.environ["ISTHMUS_STUDIES_DIR"])
import evaluate_curvature  # noqa: E402

OUTPUT = Path(os.environ["ISTHMUS_TEST_OUTPUT_DIR"])
ROWS = ((0.0, 0), (0.02, 0), (0.1, 0), (0.5, 0), (0.1, 2))
FIXED = (1.41, 2.0, 2.83, 4.0, 5.66)


def check_table():
    name = "ellipsoid 16, 14, 13; edge 2"
    for level, correlation in ROWS:
        row = evaluate_curvature.evaluate(evaluate_curvature.SHORT[name], level, correlation, fixed=FIXED)
        print(name, level, correlation, {key: round(float(value), 4) for key, value in row.items()}, flush=True)
        missed = evaluate_curvature.misses(row, level, correlation)
        assert not missed, (level, correlation, missed, row)


def state_of(proxy):
    """Automatic or not, and the scale, as the panel shows them; the object behind it agrees."""
    instance = proxy.GetClientSideObject()
    shown = (bool(proxy.AutomaticScale), proxy.Scale)
    assert shown == (instance.GetAutomaticScale(), instance.GetScale()), shown
    return shown


def check_scripts(volume, surface):
    """A Scale in the call that makes the filter switches the automatic scale off; one that is set later does not."""
    for make in (lambda **more: simple.HessianCurvature(Input=volume, **more),
                 lambda **more: simple.CurvatureOnSurface(Input=surface, Volume=volume, **more)):
        assert state_of(make()) == (True, 0.0)
        assert state_of(make(Scale=2.0)) == (False, 2.0)
        assert state_of(make(Scale=0.0)) == (False, 0.0)
        assert state_of(make(AutomaticScale=0)) == (False, 0.0)
        traced = make()
        traced.Scale = 2.0
        traced.UpdatePipeline()
        assert state_of(traced) == (False, 2.0)
        chosen = make()
        chosen.AutomaticScale = 0
        chosen.Scale = 2.0
        chosen.AutomaticScale = 1
        chosen.UpdatePipeline()
        assert state_of(chosen) == (True, 2.0)


def check_states():
    """States keep what they have; a scale set afterwards counts."""
    expected = {"Default": (True, 0.0), "Fixed": (False, 2.0), "Unused": (True, 2.0), "None": (False, 0.0)}
    simple.ResetSession()
    volume = simple.Wavelet()
    for name, (automatic, scale) in expected.items():
        proxy = simple.HessianCurvature(registrationName=name, Input=volume)
        proxy.Scale, proxy.AutomaticScale = scale, automatic
    path = OUTPUT / "CurvatureScale.pvsm"
    simple.SaveState(str(path))
    simple.ResetSession()
    simple.LoadState(str(path))
    for name, state in expected.items():
        assert state_of(simple.FindSource(name)) == state, name
    loaded = simple.FindSource("Unused")
    loaded.Scale = 3.0
    assert state_of(loaded) == (False, 3.0), "a scale set after loading"


def check_button():
    """Map to curvature sets nothing that the filter's panel would not."""
    simple.ResetSession()
    from isthmus import pipelines

    volume = simple.Calculator(
        Input=simple.Wavelet(WholeExtent=[-15, 15, -15, 15, -15, 15]), ResultArrayName="Density",
        Function="64/(64+coordsX^2+coordsY^2+coordsZ^2)")
    volume.UpdatePipeline()
    _, curvature = pipelines.map_to_curvature(volume, 0.5)
    assert state_of(curvature) == (True, 0.0)


check_table()
wavelet = simple.Wavelet()
check_scripts(wavelet, simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0]))
check_states()
check_button()
