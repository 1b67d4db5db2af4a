"""A model written as a function of Python, recorded as a script of a study."""

import math
import re
import sys
from pathlib import Path

from . import _hysteron
from ._hysteron import OpenSeesError

#: Functions of numpy that the expressions of scripts have too.
_FUNCTIONS = {
    "sqrt": "sqrt", "exp": "exp", "log": "log", "log10": "log10", "sin": "sin", "cos": "cos", "tan": "tan", "arcsin": "asin",
    "arccos": "acos", "arctan": "atan", "sinh": "sinh", "cosh": "cosh", "tanh": "tanh", "absolute": "abs", "fabs": "abs",
    "power": "**", "add": "+", "subtract": "-", "multiply": "*", "divide": "/", "negative": "-",
}  # fmt: skip
#: Operators that numpy's functions of two arguments are.
_OPERATORS = {"**", "+", "-", "*", "/"}
#: Commands whose words a script cannot repeat: they ask how long something took, or for files of their own.
_NOT_RECORDED = {"accelCPU", "solveCPU", "totalCPU", "version", "pyversion", "start", "stop"}
#: Relative difference of numbers that a script and a function compute by the same formula.
_TOLERANCE = 1e-9


def _place():
    """File and line outside of this package."""
    frame = sys._getframe(1)
    folder = str(Path(__file__).parent)
    while frame is not None and frame.f_code.co_filename.startswith(folder):
        frame = frame.f_back
    return f"{frame.f_code.co_filename}:{frame.f_lineno}" if frame else "?"


class Traced(float):
    """A number with the formula that a script has for it."""

    def __new__(cls, value, formula, trace):
        self = super().__new__(cls, value)
        self.formula, self._trace = formula, trace
        return self

    def _with(self, value, formula):
        return Traced(value, formula, self._trace)

    def _binary(self, other, sign, compute, swapped=False):
        if not isinstance(other, (int, float)) or isinstance(other, bool):
            return NotImplemented
        a, b = (other, self) if swapped else (self, other)
        value = compute(float(a), float(b))
        if not isinstance(value, float):
            return value
        return self._with(value, f"({_formula(a)}{sign}{_formula(b)})")

    def __add__(self, other):
        return self._binary(other, "+", lambda a, b: a + b)

    def __radd__(self, other):
        return self._binary(other, "+", lambda a, b: a + b, True)

    def __sub__(self, other):
        return self._binary(other, "-", lambda a, b: a - b)

    def __rsub__(self, other):
        return self._binary(other, "-", lambda a, b: a - b, True)

    def __mul__(self, other):
        return self._binary(other, "*", lambda a, b: a * b)

    def __rmul__(self, other):
        return self._binary(other, "*", lambda a, b: a * b, True)

    def __truediv__(self, other):
        return self._binary(other, "/", lambda a, b: a / b)

    def __rtruediv__(self, other):
        return self._binary(other, "/", lambda a, b: a / b, True)

    def __pow__(self, other):
        return self._binary(other, "**", lambda a, b: a**b)

    def __rpow__(self, other):
        return self._binary(other, "**", lambda a, b: a**b, True)

    def __neg__(self):
        return self._with(-float(self), f"(-{self.formula})")

    def __pos__(self):
        return self

    def __abs__(self):
        return self._with(abs(float(self)), f"abs({self.formula})")

    def _compare(self, other, compute):
        self._trace.branch(_place())
        return compute(float(self), other)

    def __lt__(self, other):
        return self._compare(other, lambda a, b: a < b)

    def __le__(self, other):
        return self._compare(other, lambda a, b: a <= b)

    def __gt__(self, other):
        return self._compare(other, lambda a, b: a > b)

    def __ge__(self, other):
        return self._compare(other, lambda a, b: a >= b)

    def __eq__(self, other):
        return self._compare(other, lambda a, b: a == b)

    def __ne__(self, other):
        return self._compare(other, lambda a, b: a != b)

    __hash__ = float.__hash__

    def __array_ufunc__(self, function, method, *inputs, **options):
        values = [float(x) if isinstance(x, Traced) else x for x in inputs]
        answer = getattr(function, method)(*values, **options)
        name = _FUNCTIONS.get(function.__name__)
        plain = method == "__call__" and not options and all(isinstance(x, (int, float)) for x in inputs)
        if name is None or not plain:
            return answer
        formulas = [_formula(x) for x in inputs]
        if name in _OPERATORS:
            formula = f"({formulas[0]}{name}{formulas[1]})" if len(formulas) == 2 else f"({name}{formulas[0]})"
        else:
            formula = f"{name}({', '.join(formulas)})"
        return self._with(float(answer), formula)


def _formula(x):
    if isinstance(x, Traced):
        return x.formula
    # A whole number would be divided as one in Tcl.
    text = repr(float(x))
    return f"({text})" if text.startswith("-") else text


class _Line:
    """A call: its command, its words with lists within them, and its place."""

    def __init__(self, name, words, place, result):
        self.name, self.words, self.place, self.result = name, words, place, result
        #: Calls that a script has in braces behind this one.
        self.body = []


def _nested(args):
    """Arguments with lists in the place of tuples and arrays."""
    out = []
    for arg in args:
        if hasattr(arg, "tolist") and not isinstance(arg, Traced):
            arg = arg.tolist()
        out.append(_nested(arg) if isinstance(arg, (list, tuple)) else arg)
    return out


def _gathered(words):
    """Words with each run of numbers behind the option of a series as one list: it has as many as its run of the study."""
    out = []
    for word in words:
        flat = word if isinstance(word, list) else [word]
        for item in flat:
            if out and isinstance(out[-1], list) and isinstance(item, (int, float)):
                out[-1].append(item)
            else:
                out.append(item)
                if item in ("-values", "-time", "-factors"):
                    out.append([])
    return out


def _flat(words):
    for word in words:
        if isinstance(word, list):
            yield from _flat(word)
        else:
            yield word


class Trace:
    """Calls of one model, with the formulas of their numbers."""

    def __init__(self):
        self.lines, self.branches, self._model, self._results = [], [], None, 0

    def branch(self, place):
        if place not in self.branches:
            self.branches.append(place)

    def take(self, model, name, args):
        """Make a call, and keep it."""
        answer = model._call(name, *args)
        if name in _NOT_RECORDED:
            return answer
        if name in ("block2D", "block3D", "mesh", "remesh"):
            raise OpenSeesError(f"{name} is not recorded: make its nodes and elements one by one ({_place()})")
        if self._model is not model:
            if self._model is not None and self.lines and not self._only_made(self._model):
                raise OpenSeesError(f"{name}: a second model; a study has one ({_place()})")
            self._model, self.lines = model, []
        words = _nested(args)
        if name == "timeSeries":
            words = _gathered(words)
        elif name == "analyze":
            words = list(_flat(words))
            last = self.lines[-1] if self.lines else None
            if last and last.name == name and _same_step(last.words, words):
                last.words[0] += words[0]
                return answer
        else:
            words = list(_flat(words))
        self._results += 1
        variable = f"result{self._results}"
        self.lines.append(_Line(name, words, _place(), variable))
        return self._traced(answer, variable)

    def _only_made(self, model):
        return not model.getNodeTags()

    def _traced(self, answer, variable):
        if isinstance(answer, float):
            return Traced(answer, f"${variable}", self)
        if isinstance(answer, list) and answer and all(isinstance(x, float) for x in answer):
            return [Traced(x, f"[lindex ${variable} {i}]", self) for i, x in enumerate(answer)]
        return answer


def _same_step(a, b):
    return len(a) == len(b) and isinstance(b[0], int) and all(_text(x) == _text(y) for x, y in zip(a[1:], b[1:], strict=True))


def trace(function, parameters, inputs):
    """The calls of a function with values of its parameters."""
    found = Trace()
    traced = {name: Traced(value, f"${name}", found) for name, value in parameters.items()}
    _hysteron.record_calls(found.take)
    try:
        function(**traced, **inputs)
    finally:
        _hysteron.record_calls(None)
    if not any(line.name == "analyze" for line in found.lines):
        raise OpenSeesError(
            f"{getattr(function, '__name__', 'model')}: no analysis was recorded\n"
            "  expected calls of hysteron.opensees or of a Model that the function makes, with analyze"
        )
    return found


def _text(word):
    """A word of a script."""
    if isinstance(word, list):
        inner = " ".join(_text(w) for w in word)
        # Nothing is computed within braces.
        return f"[list {inner}]" if any(isinstance(w, Traced) for w in _flat(word)) else f"{{{inner}}}"
    if isinstance(word, Traced):
        bare = word.formula[1:].replace("_", "").isalnum() and word.formula.startswith("$")
        return word.formula if bare else f"[expr {{{word.formula}}}]"
    if isinstance(word, bool):
        return str(int(word))
    if isinstance(word, float):
        return repr(float(word))
    if isinstance(word, int):
        return str(int(word))
    text = str(word)
    return f"{{{text}}}" if not text or any(c in text for c in ' \t\n;"$[]{}\\') else text


def _is_number(word):
    return isinstance(word, (int, float))


def check(first, again, parameters):
    """Raise an error where calls depend on the parameters in a way that a script does not say."""
    for a, b in zip(first.lines, again.lines, strict=False):
        if a.name != b.name or len(a.words) != len(b.words):
            _differs(a, b, first)
        for i, (x, y) in enumerate(zip(_flat(a.words), _flat(b.words), strict=False)):
            if isinstance(x, Traced) or isinstance(y, Traced):
                same = isinstance(x, Traced) and isinstance(y, Traced) and x.formula == y.formula
            elif _is_number(x) and _is_number(y):
                same = math.isclose(x, y, rel_tol=_TOLERANCE) or x == y
            else:
                same = str(x) == str(y)
            if not same:
                raise OpenSeesError(
                    f"{a.name}: argument {i + 1} depends on {', '.join(parameters)} in a way that cannot be recorded ({a.place})"
                    f"{_compared(first)}\n"
                    "  expected + - * / ** and functions of numpy such as numpy.sqrt: math.sqrt and int leave a plain number"
                )
    if len(first.lines) != len(again.lines):
        longer = max(first.lines, again.lines, key=len)
        line = longer[min(len(first.lines), len(again.lines))]
        _differs(line, line, first)


def _compared(trace):
    return f"; the function compares at {', '.join(trace.branches)}" if trace.branches else ""


def _differs(a, b, trace):
    where = _compared(trace)
    raise OpenSeesError(
        f"{a.name}: the calls depend on the values of the parameters ({a.place} beside {b.name} at {b.place}){where}\n"
        "  a script makes the same calls for all values"
    )


class Script:
    """The script of a study, and the variables that its runs set."""

    def __init__(self, traces, parameters, recorders):
        #: Variables by the number of the run.
        self.variables = [{} for _ in traces]
        self._count = 0
        lines = self._merged(traces)
        used = {name for line in lines for name in _RESULT.findall(_shown(line))}
        lines = _with_bodies([line for line in lines if line.result in used or not _only_asks(line.name)])
        out = [f"pset {name} {_text(value)}" for name, value in parameters.items()]
        at = self._before_last_analysis(lines)
        for i, line in enumerate(lines):
            text = _shown(line)
            if i == at:
                out += recorders
            if line.result in used:
                out.append(f"set {line.result} [{text}]")
            elif line.name == "analyze":
                out.append(f'if {{[{text}] != 0}} {{error "the analysis fails at [getTime]"}}')
            else:
                out.append(text)
        self.text = "\n".join(out) + "\n"

    def _merged(self, traces):
        """The calls of all runs as those of one script: words that differ between runs are variables."""
        first = traces[0]
        for other in traces[1:]:
            for a, b in zip(first.lines, other.lines, strict=False):
                if a.name != b.name or len(a.words) != len(b.words):
                    _runs_differ(a, b)
            if len(first.lines) != len(other.lines):
                longer = max(first.lines, other.lines, key=len)
                line = longer[min(len(first.lines), len(other.lines))]
                _runs_differ(line, line)
        out = []
        for row in zip(*(t.lines for t in traces), strict=True):
            words = [self._word([line.words[i] for line in row]) for i in range(len(row[0].words))]
            out.append(_Line(row[0].name, words, row[0].place, row[0].result))
        return out

    def _word(self, words):
        texts = [_text(w) for w in words]
        if all(t == texts[0] for t in texts[1:]):
            return words[0]
        if any(isinstance(w, Traced) for w in _flat(words)):
            raise OpenSeesError(f"a formula differs between the runs: {texts[0]} and {next(t for t in texts if t != texts[0])}")
        self._count += 1
        name = f"input{self._count}"
        for variables, word in zip(self.variables, words, strict=True):
            variables[name] = word
        return _Variable(name)

    def _before_last_analysis(self, lines):
        """Place of the first analysis behind the last setting of the clock: gravity belongs to no recording."""
        clock = 0
        for i, line in enumerate(lines):
            words = [_text(w) if not isinstance(w, _Variable) else "" for w in line.words]
            if line.name in ("wipe", "setTime") or line.name == "loadConst" and "-time" in words:
                clock = i
        return next(i for i, line in enumerate(lines) if i >= clock and line.name == "analyze")


#: Commands that a script has in the body of the last call of another one.
_BODIES = {
    "section": {"patch", "layer", "fiber"},
    "pattern": {"load", "sp", "eleLoad", "groundMotion", "imposedMotion", "imposedSupportMotion"},
}
#: Those that may stand outside of the body with the tag of their pattern.
_LOADS = {"load", "sp", "eleLoad"}


def _with_bodies(lines):
    """Calls with those that belong into the body of an earlier one taken there.

    A load behind another call, such as an analysis, keeps its place: the order of the two is part of the model.
    """
    out, heads, is_open = [], {}, False
    for line in lines:
        head = heads.get(next((h for h, inner in _BODIES.items() if line.name in inner), None))
        if head and (is_open or line.name not in _LOADS):
            head.body.append(line)
            continue
        is_open = line.name == "pattern"
        if line.name in _BODIES:
            heads[line.name] = line
        elif head and not any(isinstance(word, str) and word == "-pattern" for word in line.words):
            line.words += ["-pattern", head.words[1]]
        out.append(line)
    return out


def _shown(line):
    """A call as a command of a script."""
    text = " ".join([line.name, *(w.text if isinstance(w, _Variable) else _text(w) for w in line.words)])
    if line.body:
        text += " {\n" + "".join(f"    {_shown(inner)}\n" for inner in line.body) + "}"
    return text


class _Variable:
    """A word that each run of a study sets."""

    def __init__(self, name):
        self.text = f"${name}"


#: Results of calls in formulas.
_RESULT = re.compile(r"\$(result\d+)")
#: Commands that print or compute, and leave the model as it is.
_PRINTS = {"printA", "printB", "printX", "modalProperties"}


def _only_asks(name):
    return name in _PRINTS or _hysteron.asks(name)


def _runs_differ(a, b):
    raise OpenSeesError(
        f"{a.name}: the runs make different calls ({a.place} beside {b.name} at {b.place})\n"
        "  the runs of a study have one script: they may differ in numbers and lists alone"
    )
