"""Drop-in for ``openseespy.opensees``: the commands of OpenSees on one model.

``import hysteron.opensees as ops`` in the place of ``import openseespy.opensees as ops``.
"""

import difflib as _difflib

from ._hysteron import OpenSeesError
from ._model import Model as _Model

_domain = _Model()

_names = [n for n in dir(_Model) if not n.startswith("_")]
for _name in _names:
    globals()[_name] = getattr(_domain, _name)

__all__ = [*_names, "OpenSeesError"]


def __getattr__(name):
    near = _difflib.get_close_matches(name, _names, 1)
    hint = f". Did you mean '{near[0]}'?" if near else ""
    raise AttributeError(f"OpenSees has no command '{name}'{hint}")
