"""Model: the commands of OpenSees as methods, each model with a state of its own."""

import difflib
import html
import sys

from . import _hysteron
from ._hysteron import OpenSeesError
from ._scope import REASONS
from ._units import units

USAGES = {name: (usage, kinds) for name, usage, kinds in _hysteron.usages()}

#: Commands of scripts in Tcl that Python has its own words for.
_TCL_ONLY = {"lassign", "print", "pset"}

#: Short names of what a recorder of nodes takes down.
_NODE_QUANTITIES = {"disp", "vel", "accel", "incrDisp", "reaction", "rayleighForces"}


class Recording(dict):
    """Histories by name, with ``time`` and the code of the analysis in ``code``."""

    code: int = 0


class Page:
    """A page for a browser, which needs no other file."""

    def __init__(self, html):
        #: Text of the page.
        self.html = html

    def save(self, file):
        """Write the page."""
        with open(file, "w", encoding="utf-8") as out:
            out.write(self.html)

    def _repr_html_(self):
        frame = 'width="100%" height="640" style="border:0" sandbox="allow-scripts"'
        return f'<iframe {frame} srcdoc="{html.escape(self.html)}"></iframe>'


def _documentation(name):
    usage, kinds = USAGES[name]
    lines = [usage]
    lines += ["", "Kinds: " + ", ".join(sorted(k[0][0] for k in kinds))] if kinds else []
    return "\n".join(lines)


def _refusal(name):
    reason = REASONS[name]

    def call(self, *args):
        raise OpenSeesError(f"{name} is out of hysteron's scope: {reason}")

    call.__name__ = name
    call.__qualname__ = f"Model.{name}"
    call.__doc__ = f"Out of scope: {reason}."
    return call


class Model(_hysteron.Domain):
    """A model of OpenSees with its state and analysis.

    The commands of OpenSees are its methods. Models are independent of each other; one thread at a time uses a model, and
    other threads run while it is analysed.

    ``ndm`` and ``ndf`` are those of the command ``model``. ``strict`` makes errors of warnings, ``compat`` gives the numbers
    of OpenSees also where they depend on a slip, and ``ladder`` tries other algorithms and shorter steps where a step fails.
    """

    def __init__(self, ndm=None, ndf=None, *, strict=False, compat=False, ladder=False):
        if ndm is not None:
            self._call("model", "basic", "-ndm", ndm, *(() if ndf is None else ("-ndf", ndf)))
        elif ndf is not None:
            raise OpenSeesError("Model: ndf is given, and ndm is not")

    def __new__(cls, ndm=None, ndf=None, *, strict=False, compat=False, ladder=False):
        return super().__new__(cls, strict=strict, compat=compat, ladder=ladder)

    def __getattr__(self, name):
        near = difflib.get_close_matches(name, USAGES, 1)
        hint = f". Did you mean '{near[0]}'?" if near else ""
        raise AttributeError(f"OpenSees has no command '{name}'{hint}", name=name, obj=self)

    def __reduce__(self):
        raise TypeError("a Model cannot be pickled: a task builds its own, from the parameters that it is given")

    def _analyze_recorded(self, args, record):
        """Histories of an analysis by name."""
        made = {name: self._record(*_recorder_words(name, what)) for name, what in record.items()}
        histories = Recording()
        try:
            histories.code = self.analyze(*args)
        finally:
            for name, (tag, file) in made.items():
                rows = self._recorded(tag, file)
                times, columns = rows[:, :1].ravel(), rows[:, 1:]
                histories.setdefault("time", times)
                histories[name] = columns[:, 0] if columns.shape[1] == 1 else columns
        return histories

    def watch(self):
        """Keep the motion of the analyses from here on for ``plot``."""
        self._watch()

    def plot(self, file=None, *, title="model", units=("", ""), modes=0):
        """The page of `hysteron view` for this model: it turns, moves, and shows histories and loops.

        In a notebook it is shown below its cell; ``file`` writes it as well. Without ``watch`` before the analyses it shows the
        committed state. ``units`` are the names of force and length, ``modes`` the number of modes to be shown.
        """
        text = self._page(title, *units, modes)
        if text is None:
            raise OpenSeesError("plot: the model has no nodes")
        page = Page(text)
        if file is not None:
            page.save(file)
        return page

    def getNumThreads(self):
        """Number of threads of an analysis: 1."""
        return 1

    def setNumThreads(self, number):
        """Accepted: an analysis runs on one thread here, and models run side by side."""

    def pyversion(self, *args):
        """Version of Python, as openseespy names it."""
        return sys.version

    def defaultUnits(self, *args):
        """defaultUnits('-force', unit, '-length', unit, '-time', unit): values of units as variables of the script.

        As in openseespy, ``kN``, ``m``, ``g`` and others become global variables of ``__main__``. Nothing is converted.
        """
        vars(sys.modules["__main__"]).update(units(args))

    def metaData(self, *args):
        """Accepted: notes about a model change nothing of it."""

    def nodePressure(self, node):
        """Pressure of a fluid at a node: 0, since models have no fluid."""
        self.nodeCoord(node)
        return 0.0

    def build(self):
        """Accepted: there is nothing to build."""


def _recorder_words(name, what):
    words = list(what) if isinstance(what, (list, tuple)) else [what]
    if words and words[0] in _NODE_QUANTITIES:
        quantity, nodes, *dofs = words
        return ["Node", "-node", nodes, *(["-dof", *dofs] if dofs else []), quantity]
    if len(words) < 2:
        raise OpenSeesError(
            f"record {name!r}: {what!r} is no recorder\n  expected ('disp', node, dof) or the words of a recorder"
        )
    return words


for _name in USAGES:
    if _name not in _TCL_ONLY and not hasattr(Model, _name) | (_name in Model.__dict__):
        setattr(Model, _name, _hysteron.Method(_name, _documentation(_name)))
for _name in REASONS:
    if _name not in USAGES:
        setattr(Model, _name, _refusal(_name))
