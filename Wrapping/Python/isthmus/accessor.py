"""The accessor of PyVista's datasets: mesh.isthmus.choking_loops().

PyVista loads this module by the entry point `pyvista.accessors` of the wheel when `.isthmus` is first used,
so that `import isthmus` is not needed.
"""
import functools

import pyvista

from . import data_pipelines, functions


@pyvista.register_dataset_accessor("isthmus", pyvista.DataSet)
class IsthmusAccessor:
    """All functions of isthmus whose first argument is a dataset of this kind.

    >>> import isthmus, pyvista
    >>> mesh = isthmus.samples.torus()
    >>> mesh.isthmus.choking_loops().loops.n_cells
    2
    """

    def __init__(self, dataset):
        self._dataset = dataset

    def __getattr__(self, name):
        try:
            found = _method(name)
        except KeyError:
            raise AttributeError(f"isthmus has no function {name!r} of a dataset.") from None
        bound = functools.partial(found, self._dataset)
        bound.__doc__ = found.__doc__
        return bound

    def __dir__(self):
        return sorted({*super().__dir__(), *filter(self._fits, functions.names()), *data_pipelines.NAMES})

    def _fits(self, name):
        described = functions.table()["functions"][functions.table()["short_names"].get(name, name)]
        return bool(described["inputs"]) and any(
            self._dataset.IsA(kind) for kind in described["inputs"][0]["types"])


def _method(name):
    if name in data_pipelines.NAMES:
        return getattr(data_pipelines, name)
    made = functions.function(name)
    described = functions.table()["functions"][functions.table()["short_names"].get(name, name)]
    if not described["inputs"]:
        raise KeyError(name)
    return made
