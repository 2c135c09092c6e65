"""The errors that Surface Measures and Pore Profile state cover the true ones of random surfaces and pores.

The whole table is that of Testing/Studies/evaluate_measure_errors.py.
"""

import os
import sys

sys.path.insert(0, os.environ["ISTHMUS_STUDIES_DIR"])
import evaluate_measure_errors  # noqa: E402

for name, pairs in evaluate_measure_errors.evaluate(cases=60, seed=7).items():
    covered, median, above, counted = evaluate_measure_errors.summary(pairs)
    print(name, len(pairs), covered, median, above, counted, flush=True)
    assert counted >= 20, (name, counted)
    assert covered >= 0.9, (name, covered)
    assert median <= 5.0, (name, median)
    assert above <= 0.25, (name, above)
