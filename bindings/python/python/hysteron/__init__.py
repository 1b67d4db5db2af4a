"""Structural analysis of buildings and bridges on seismic isolation: OpenSees' commands and scripts."""

from ._batch import Table, batch
from ._hysteron import (
    MeasuredSeries,
    Message,
    OpenSeesError,
    OpenSeesWarning,
    ScriptResult,
    __version__,
    check,
    read_recording,
    run,
)
from ._install import install
from ._keywords import about
from ._learned import Learned, LearnedLaw
from ._model import Model, Recording, USAGES as _USAGES
from ._study import Calibration, Diagnosis, Study
from ._written import Run

__all__ = [
    "Calibration",
    "Diagnosis",
    "Learned",
    "LearnedLaw",
    "MeasuredSeries",
    "Message",
    "Model",
    "OpenSeesError",
    "OpenSeesWarning",
    "Recording",
    "Run",
    "ScriptResult",
    "Study",
    "Table",
    "about",
    "batch",
    "check",
    "commands",
    "install",
    "read_recording",
    "run",
]


def commands(name=None):
    """Usages: of all commands by name, or of the kinds that one command makes."""
    if name is None:
        return {n: usage for n, (usage, _) in _USAGES.items()}
    if name not in _USAGES:
        raise OpenSeesError(f"unknown command {name!r}")
    usage, kinds = _USAGES[name]
    return {n: kind_usage for names, kind_usage in kinds for n in names} or {name: usage}
