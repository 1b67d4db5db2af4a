"""Drop-in for ``openseespy.opensees``: the commands of OpenSees on one model.

``import hysteron.opensees as ops`` in the place of ``import openseespy.opensees as ops``.
"""

from ._hysteron import OpenSeesError
from ._model import Model as _Model

#: `from hysteron.opensees import *` takes no name of Python's library.
_names = [n for n in dir(_Model) if not n.startswith("_") and n != "copy"]
_settings = {}


def _use(**settings):
    """Work on a new model with these settings of ``Model``; the same settings keep the model."""
    global _domain, _settings
    if settings == _settings:
        return
    _domain, _settings = _Model(**settings), settings
    for name in _names:
        globals()[name] = getattr(_domain, name)


# The module has no `__getattr__`: with one, Python looks up each command without its caches. Python itself names the nearest command.
_use(strict=False, compat=False, ladder=False)

__all__ = [*_names, "OpenSeesError"]
