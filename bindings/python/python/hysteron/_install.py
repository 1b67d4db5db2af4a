"""hysteron in the place of openseespy."""

import sys
import types


def install():
    """Let ``import openseespy.opensees`` give ``hysteron.opensees``, for programs that import openseespy.

    Call it before they are imported.
    """
    from . import opensees

    package = types.ModuleType("openseespy", "hysteron in the place of openseespy.")
    package.__path__ = []
    package.opensees = opensees
    sys.modules["openseespy"] = package
    sys.modules["openseespy.opensees"] = opensees
    sys.modules["opensees"] = opensees
    return opensees
