"""Model: the commands of OpenSees as methods, each model with a state of its own."""

import difflib
import html
import sys

from . import _hysteron
from ._hysteron import OpenSeesError
from ._keywords import about
from ._scope import REASONS
from ._units import units

USAGES = {name: (usage, kinds) for name, usage, kinds in _hysteron.usages()}

#: Commands of scripts in Tcl that Python has its own words for.
_TCL_ONLY = {"lassign", "print", "pset"}

#: Kinds of recorders.
_RECORDERS = {name for names, _ in USAGES["recorder"][1] for name in names}

#: Short names of what a recorder of nodes takes down.
_NODE_QUANTITIES = {"disp", "vel", "accel", "incrDisp", "reaction", "rayleighForces"}


class Recording(dict):
    """Histories by name, with ``time`` and the code of the analysis in ``code``.

    A history of several columns is an array of shape (rows, columns).
    """

    code: int = 0

    def __init__(self):
        super().__init__()
        #: Names of the columns of each history that has several.
        self.columns = {}

    def _series(self):
        for name, values in self.items():
            if values.ndim == 1:
                yield name, values
            else:
                yield from zip(self.columns[name], values.T, strict=True)

    def to_pandas(self):
        """A DataFrame with the time as its index; the columns of a history are named by node and degree of freedom, or numbered."""
        import pandas

        table = {name: values for name, values in self._series() if name != "time"}
        return pandas.DataFrame(table, index=pandas.Index(self.get("time", []), name="time"))

    def to_xarray(self):
        """A Dataset over the time, with a variable for each column."""
        return self.to_pandas().to_xarray()


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

    #: Place in a notebook where ``plot`` shows the model.
    _shown = None

    def __init__(self, ndm=None, ndf=None, *, strict=False, compat=False, ladder=False):
        if ndm is not None:
            self.model("basic", "-ndm", ndm, *(() if ndf is None else ("-ndf", ndf)))
        elif ndf is not None:
            raise OpenSeesError("Model: ndf is given, and ndm is not")

    def __new__(cls, ndm=None, ndf=None, *, strict=False, compat=False, ladder=False):
        self = super().__new__(cls, strict=strict, compat=compat, ladder=ladder)
        self._settings = {"strict": strict, "compat": compat, "ladder": ladder}
        return self

    def __getattr__(self, name):
        near = difflib.get_close_matches(name, USAGES, 1)
        hint = f". Did you mean '{near[0]}'?" if near else ""
        raise AttributeError(f"OpenSees has no command '{name}'{hint}", name=name, obj=self)

    def copy(self):
        """A model like this one, which goes on to the same bits and shares nothing with it.

        It is made by the calls that this model was told since it was empty, analyses with them: a copy takes as long as they did.
        Files that the calls read are read again. Recorders, and what ``watch`` keeps, stay with this model. Raises OpenSeesError
        where the calls do not make the model again: one of them was interrupted, ``restore`` has read a state, or there were too
        many of them.
        """
        # A class of one's own may take other arguments.
        new = _hysteron.Domain.__new__(type(self), **self._settings)
        new.__dict__.update({name: value for name, value in self.__dict__.items() if name != "_shown"})
        new._make_like(self)
        return new

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def __reduce__(self):
        raise TypeError("a Model cannot be pickled: a task builds its own, from the parameters that it is given")

    def _analyze_recorded(self, args, record):
        """Histories of an analysis by name."""
        made = {name: (what, *self._record(*_recorder_words(name, what))) for name, what in record.items()}
        histories = Recording()
        try:
            histories.code = self.analyze(*args)
        finally:
            for name, (what, tag, file) in made.items():
                rows = self._recorded(tag, file)
                times, columns = rows[:, :1].ravel(), rows[:, 1:]
                histories.setdefault("time", times)
                histories[name] = columns[:, 0] if columns.shape[1] == 1 else columns
                if columns.shape[1] > 1:
                    histories.columns[name] = _column_names(name, what, columns.shape[1])
        return histories

    def _analyze_shown(self, args, record):
        """An analysis whose steps a bar of tqdm shows, where that is installed."""
        bar = _bar(args)
        if bar is None:
            return self.analyze(*args, record=record)
        with bar:
            self._tell_steps(bar.update)
            try:
                found = self.analyze(*args, record=record)
            finally:
                self._tell_steps(None)
            if (found if record is None else found.code) == 0:
                bar.update(bar.total - bar.n)
        return found

    def __repr__(self):
        nodes, elements = len(self.getNodeTags()), len(self.getEleTags())
        ndm, ndf = self.getNDM(), self.getNDF()
        dofs = f"{ndm[0]}D, {ndf[0]} degrees of freedom at a node" if nodes else "empty"
        return f"<Model: {dofs}, {nodes} nodes, {elements} elements, time {self.getTime():g}>"

    def watch(self):
        """Keep the motion of the analyses from here on for ``plot``."""
        self._watch()

    def plot(self, file=None, *, title="model", units=("", ""), modes=0, show=False):
        """The page of `hysteron view` for this model: it turns, moves, and shows histories and loops.

        In a notebook it is shown below its cell; ``file`` writes it as well. With ``show`` it is shown at once, and takes the place
        of the one before: a loop shows its model while it runs, and the notebook keeps one page. Without ``watch`` before the
        analyses it shows the committed state. ``units`` are the names of force and length, ``modes`` the number of modes to be shown.
        """
        text = self._page(title, *units, modes)
        if text is None:
            raise OpenSeesError("plot: the model has no nodes")
        page = Page(text)
        if file is not None:
            page.save(file)
        if not show:
            return page
        from IPython.display import display

        if self._shown is None:
            self._shown = display(page, display_id=True)
        else:
            self._shown.update(page)
        return None

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


def _listed(what):
    return list(what) if isinstance(what, (list, tuple)) else [what]


def _recorder_words(name, what):
    words = _listed(what)
    if not words or not isinstance(words[0], str):
        raise OpenSeesError(f"record {name!r}: {what!r} is no recorder\n  {_EXPECTED}")
    if words[0] in _NODE_QUANTITIES:
        if len(words) < 2:
            raise OpenSeesError(f"record {name!r}: the node is missing behind {words[0]!r}\n  {_EXPECTED}")
        quantity, nodes, *dofs = words
        return ["Node", "-node", nodes, *(["-dof", *dofs] if dofs else []), quantity]
    if len(words) < 2 or words[0] not in _RECORDERS:
        near = difflib.get_close_matches(words[0], [*_NODE_QUANTITIES, *_RECORDERS], 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise OpenSeesError(f"record {name!r}: {words[0]!r} is no recorder{hint}\n  {_EXPECTED}")
    return words


def _bar(args):
    """A bar for the steps of an analysis; None without tqdm or steps."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm(total=int(args[0]), unit=" steps") if args else None


_EXPECTED = "expected ('disp', node, dof) or the words of a recorder: ('Element', '-ele', 1, 'force')"


def _column_names(name, what, count):
    """Names of the columns of a history: by node and degree of freedom where they are given, else by numbers from 1."""
    words = _listed(what)
    if words[0] in _NODE_QUANTITIES and len(words) > 2:
        nodes, dofs = _listed(words[1]), [dof for word in words[2:] for dof in _listed(word)]
        names = [f"{name}_{node}_{dof}" for node in nodes for dof in dofs]
        if len(names) == count:
            return names
    return [f"{name}_{i + 1}" for i in range(count)]


for _name in USAGES:
    if _name not in _TCL_ONLY and not hasattr(Model, _name) | (_name in Model.__dict__):
        setattr(Model, _name, _hysteron.Method(_name, about(_name)))
for _name in REASONS:
    if _name not in USAGES:
        setattr(Model, _name, _refusal(_name))
