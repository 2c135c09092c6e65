"""The one extension of before 1.0; `import isthmus` has all classes. Removed in 1.1."""
import warnings

from isthmus import *  # noqa: F401,F403

warnings.warn("isthmus.vtkIsthmus is deprecated: import isthmus", DeprecationWarning, stacklevel=2)
