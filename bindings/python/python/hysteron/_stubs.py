"""Type stubs from the usages of the commands: ``python -m hysteron._stubs [FOLDER]``."""

import pathlib
import re
import sys

from . import _hysteron
from ._keywords import summary
from ._model import _TCL_ONLY, USAGES, Model
from ._scope import REASONS

_NODE = "list[float] | float"
_RETURNS = {
    **dict.fromkeys(
        "nodeDisp nodeVel nodeAccel nodeReaction nodeUnbalance nodeCoord nodeMass nodeEigenvector eleForce eleDynamicalForce localForce "
        "basicForce basicDeformation sectionForce sectionDeformation sectionLocation sectionWeight".split(),
        _NODE,
    ),
    **dict.fromkeys(
        "eigen motionFile eleResponse sdfResponse basicStiffness sectionStiffness sectionFlexibility sectionDisplacement cbdiDisplacement testNorm testNorms nodeBounds getEleLoadData "
        "getNodeLoadData sensSectionForce".split(),
        "list[float]",
    ),
    **dict.fromkeys(
        "getNodeTags getEleTags eleNodes getPatterns getFixedNodes getFixedDOFs getConstrainedNodes getRetainedNodes "
        "getConstrainedDOFs getRetainedDOFs getParamTags nodeDOFs getNDM getNDF getNumElements getCrdTransfTags "
        "getEleClassTags getEleLoadTags getEleLoadClassTags getNodeLoadTags".split(),
        "list[int]",
    ),
    **dict.fromkeys(
        "getTime getLoadFactor getStress getStrain getTangent getParamValue nodeResponse sensNodeDisp sensNodeVel "
        "sensNodeAccel sensLambda".split(),
        "float",
    ),
    **dict.fromkeys(
        "systemSize testIter numIter getPID getNP getNumThreads recorder parameter updateParameter".split(), "int"
    ),
    **dict.fromkeys("version eleType classType".split(), "str"),
    "sectionTag": "list[int] | int",
    "modalProperties": "dict[str, list[float]] | None",
    "printA": "list[float] | None",
    "printB": "list[float] | None",
    "printX": "list[float] | None",
}
#: Queries of many nodes or elements at once.
_MANY = "nodeDisp nodeVel nodeAccel nodeCoord nodeReaction eleForce basicForce basicDeformation localForce".split()
_PYTHON = {
    "analyze": "(steps: _Word, dt: _Word = ..., *more: _Word, progress: bool = False) -> int",
    "getNumThreads": "() -> int",
    "setNumThreads": "(number: int) -> None",
    "build": "() -> None",
    "nodePressure": "(node: _Word) -> float",
    "defaultUnits": "(*args: _Word) -> None",
    "metaData": "(*args: _Word) -> None",
    "pyversion": "(*args: _Word) -> str",
    "copy": "() -> Model",
    "watch": "() -> None",
    "plot": "(file: str | PathLike[str] | None = None, *, title: str = ..., units: tuple[str, str] = ..., modes: int = ..., show: bool = ...) "
    "-> Any",
}
_HEAD = '''"""Generated from the usages of the commands by `python -m hysteron._stubs`."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, NoReturn, overload

import numpy as np

_Tags = Sequence[int] | np.ndarray
_Word = float | str | np.ndarray | PathLike[str] | Sequence["_Word"]
'''
_SIMPLE = re.compile(r"^\w+\(([a-z]\w*(?:, [a-z]\w*)*)?(?:(?:, )?<([a-z]\w*)>)?\)$", re.IGNORECASE)


def _parameters(usage):
    """Parameters of a usage whose words are plain values; None for one with options."""
    simple = _SIMPLE.match(usage)
    if simple is None:
        return None
    given, optional = simple.groups()
    names = [f"{n}: _Word" for n in (given.split(", ") if given else [])]
    names += [f"{optional}: _Word = ..."] if optional else []
    return ", ".join(names)


def _definition(name, indent, is_method):
    first = "self" if is_method else ""
    if name in _PYTHON:
        signature = _PYTHON[name]
        signature = signature.replace("(", "(self, ", 1).replace("(self, )", "(self)") if is_method else signature
        return f"{indent}def {name}{signature}: ..."
    if name not in USAGES:
        signature = ", ".join(filter(None, [first, "*args: Any"]))
        return f"{indent}def {name}({signature}) -> NoReturn: ..."
    usage, kinds = USAGES[name]
    parameters = None if kinds else _parameters(usage)
    if parameters is None:
        parameters = "*args: _Word, **options: _Word"
    elif parameters and name in vars(_hysteron.Domain):
        # Queries that loops make take no names.
        parameters += ", /"
    signature = ", ".join(filter(None, [first, parameters]))
    text = "\n\n".join(filter(None, [usage, summary(name)])).replace("\\", "\\\\").replace('"""', "'''")
    text = text.replace("\n\n", f"\n\n{indent}    ")
    end = f"\n{indent}    " if "\n" in text else ""
    if name in _MANY:
        of_one, of_many = signature.replace(": _Word", ": float"), signature.replace(": _Word,", ": _Tags = ...,", 1)
        return (
            f"{indent}@overload\n{indent}def {name}({of_one}) -> {_RETURNS[name]}:\n{indent}    \"\"\"{text}{end}\"\"\"\n"
            f"{indent}@overload\n{indent}def {name}({of_many}) -> np.ndarray: ..."
        )
    return f'{indent}def {name}({signature}) -> {_RETURNS.get(name, "None")}:\n{indent}    """{text}{end}"""'


def names():
    """Names of all commands, with those that are out of scope."""
    return sorted(({*USAGES, *REASONS, *_PYTHON} - _TCL_ONLY) & set(dir(Model)), key=str.lower)


def stubs():
    """Texts of the stubs by the name of their file."""
    opensees = [_HEAD, "class OpenSeesError(Exception): ...", ""]
    opensees += [_definition(name, "", False) for name in names() if name != "copy"]
    model = [_HEAD, "class Recording(dict[str, np.ndarray]):", "    code: int", "", "class Model:"]
    model += [
        "    def __init__(",
        "        self, ndm: int | None = None, ndf: int | None = None, *, strict: bool = False, compat: bool = False,",
        "        ladder: bool = False,",
        "    ) -> None: ...",
    ]
    model += [_definition(name, "    ", True) for name in names() if name != "analyze"]
    model += [
        "    def analyze(self, *args: _Word, record: dict[str, Any] | None = None, progress: bool = False) -> Any: ...",
        "",
        "USAGES: dict[str, tuple[str, list[tuple[list[str], str]]]]",
    ]
    return {"opensees.pyi": "\n".join(opensees) + "\n", "_model.pyi": "\n".join(model) + "\n"}


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent)
    for file, text in stubs().items():
        (folder / file).write_text(text, encoding="utf-8")
