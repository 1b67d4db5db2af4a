"""hysteron in the place of openseespy."""

import importlib.util
import sys
import types


def install(*, strict=False, compat=False, ladder=False):
    """Let ``import openseespy.opensees`` give ``hysteron.opensees``, for programs that import openseespy.

    Call it before they are imported. The settings are those of ``Model``: ``compat`` gives OpenSees' numbers also where they
    depend on a slip. Parts of an installed openseespy beside its commands, such as ``openseespy.preprocessing``, stay as they are.
    """
    from . import opensees

    opensees._use(strict=strict, compat=compat, ladder=ladder)
    package = types.ModuleType("openseespy", "hysteron in the place of openseespy.")
    package.__path__ = _installed()
    package.opensees = opensees
    sys.modules["openseespy"] = package
    sys.modules["openseespy.opensees"] = opensees
    other = _Package("opensees", "hysteron in the place of the package opensees.")
    other.__path__, other.__all__, other.openseespy = [], opensees.__all__, opensees
    sys.modules["opensees"] = other
    sys.modules["opensees.openseespy"] = opensees
    return opensees


class _Package(types.ModuleType):
    """A package whose own names are the commands: `import opensees as ops` and `import opensees.openseespy as ops`."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return getattr(self.openseespy, name)


def _installed():
    """Folders of an openseespy that is installed."""
    known = sys.modules.get("openseespy")
    if known is not None:
        return list(getattr(known, "__path__", []))
    spec = importlib.util.find_spec("openseespy")
    return list(spec.submodule_search_locations or []) if spec else []
