"""Studies whose model is a function: the script, the recordings and the study as files in a folder."""

import inspect
import json
import math
import os
import warnings
from pathlib import Path

from ._hysteron import OpenSeesError, OpenSeesWarning
from ._model import _recorder_words
from ._recorded import Script, _text, check, trace

#: Shares of the ranges at which a function is called again, to see that its script says the same: no simple fractions.
_AGAIN = (0.2718281828, 0.7320508076)
#: Names of a column of times.
_TIMES = ("time", "t")


class Run:
    """A recorded test of a study whose model is a function.

    ``recording`` is a DataFrame whose index or column ``time`` has the times in s, a dictionary of arrays with ``time``, or the path of
    a file. ``inputs`` are further arguments of the function in this run, such as its motion. A ``holdout`` run is never fitted.
    """

    def __init__(self, recording, *, name=None, role="fit", inputs=None, dt=None, unit=None):
        self.recording, self.name, self.role, self.inputs = recording, name, role, dict(inputs or {})
        self.dt, self.unit = dt, unit

    def _columns(self):
        """Columns of the recording by name, the times first; None for a file."""
        table = self.recording
        if isinstance(table, (str, os.PathLike)):
            return None
        if hasattr(table, "to_dataframe"):
            table = table.to_dataframe()
        columns = {str(name): table[name] for name in (table if isinstance(table, dict) else table.columns)}
        times = next((n for n in columns if n.split("[")[0].split("(")[0].strip().lower() in _TIMES), None)
        if times is None:
            if isinstance(table, dict):
                raise OpenSeesError(f"the recording has no times\n  expected a key 'time' beside {', '.join(columns)}")
            columns = {"time[s]": table.index, **columns}
        else:
            columns = {times: columns.pop(times), **columns}
        columns = {name: [float(x) for x in values] for name, values in columns.items()}
        lengths = {len(values) for values in columns.values()}
        if len(lengths) != 1:
            raise OpenSeesError("the columns of the recording have different lengths: " + ", ".join(f"{n} {len(v)}" for n, v in columns.items()))
        return columns

    def _write(self, file):
        """Write the recording beside the study; its path."""
        columns = self._columns()
        if columns is None:
            return str(Path(self.recording).absolute())
        rows = zip(*columns.values(), strict=True)
        cell = lambda x: "" if math.isnan(x) else repr(x)  # noqa: E731
        with open(file, "w", encoding="utf-8") as out:
            out.write("\t".join(columns) + "\n")
            out.writelines("\t".join(map(cell, row)) + "\n" for row in rows)
        return file.name


def _parameter(name, given, default):
    """Keys of a parameter in a study, and the value that the script itself has."""
    if isinstance(given, dict):
        keys = dict(given)
    elif isinstance(given, str):
        keys = {"expr": given}
    elif isinstance(given, (int, float)):
        keys = {"value": float(given)}
    else:
        lower, upper, *scale = given
        keys = {"lower": float(lower), "upper": float(upper), **({"scale": scale[0]} if scale else {})}
    value = keys.pop("initial", default)
    if value is None and "lower" in keys:
        is_log = keys.get("scale") == "log"
        value = math.sqrt(keys["lower"] * keys["upper"]) if is_log else (keys["lower"] + keys["upper"]) / 2
    value = keys.get("value", 1.0) if value is None else value
    return {"name": name, **keys}, float(value)


def _shifted(keys, value, share):
    """Another value of a parameter."""
    if "lower" in keys and "upper" in keys:
        return keys["lower"] + share * (keys["upper"] - keys["lower"])
    return value * (1 + 0.1 * share) + 1e-3 * share


def _toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{k} = {_toml(v)}" for k, v in value.items()) + " }"
    return repr(float(value)) if isinstance(value, float) else str(value)


def _table(head, keys):
    return f"{head}\n" + "".join(f"{k} = {_toml(v)}\n" for k, v in keys.items())


def _observed(observe, run):
    """Tables of the channels of a run."""
    columns = run._columns()
    bare = None if columns is None else {n.split("[")[0].split("(")[0].strip(): n for n in columns}
    for channel in observe:
        if bare is None or channel in bare:
            yield _table("[[run.observe]]", {"channel": channel, "output": f"{channel}.out", "column": 1})


def _recorder(channel, what):
    kind, *words = _recorder_words(channel, what)
    flat = " ".join(_text(w)[1:-1] if isinstance(w, list) else _text(w) for w in words)
    return f"recorder {kind} -file {_text(channel + '.out')} -time {flat}"


def write(folder, model, parameters, runs, observe, title, more):
    """Write a study into a folder; its file."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    defaults = {n: p.default for n, p in inspect.signature(model).parameters.items() if p.default is not inspect.Parameter.empty}
    made = [_parameter(n, given, defaults.get(n)) for n, given in parameters.items()]
    runs = [run if isinstance(run, Run) else Run(run) for run in runs]
    if not runs:
        raise OpenSeesError("a study needs at least one run")
    start = {keys["name"]: value for keys, value in made}
    traces = [trace(model, start, run.inputs) for run in runs]
    for share in _AGAIN:
        other = {keys["name"]: _shifted(keys, value, share) for keys, value in made}
        check(traces[0], trace(model, other, runs[0].inputs), parameters)
    branches = sorted({place for t in traces for place in t.branches})
    if branches:
        said = "the model compares a number that depends on its parameters or on a result: the script keeps the branch that was taken"
        warnings.warn(f"{said} ({', '.join(branches)})", OpenSeesWarning, stacklevel=3)
    script = Script(traces, start, [_recorder(channel, what) for channel, what in observe.items()])
    (folder / "model.tcl").write_text(script.text, encoding="utf-8")
    out = [_table("", {"title": title or model.__name__, "model": "model.tcl", **{k: v for k, v in more.items() if not isinstance(v, dict)}})]
    out += [_table(f"[{k}]", v) for k, v in more.items() if isinstance(v, dict)]
    out += [_table("[[parameter]]", keys) for keys, _ in made]
    for i, (run, variables) in enumerate(zip(runs, script.variables, strict=True)):
        name = run.name or f"run{i + 1}"
        keys = {"name": name, "role": run.role, "recording": run._write(folder / f"{name}.csv")}
        keys |= {k: v for k, v in (("dt", run.dt), ("unit", run.unit), ("set", variables)) if v}
        out.append(_table("[[run]]", keys))
        out += _observed(observe, run)
    file = folder / "study.toml"
    file.write_text("\n".join(out), encoding="utf-8")
    return file
