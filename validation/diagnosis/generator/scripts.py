"""Running scripts in OpenSees, and the pieces that the scripts and studies of sealed batches share."""

import os
import subprocess

from . import signals
from .model import Run

TRANSIENT = """constraints {handler}
numberer RCM
system {system}
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {{set i 1}} {{$i < $npts}} {{incr i}} {{
    set ok [analyze {sub} [expr $dt/{sub}.0]]
    if {{$ok != 0}} {{
        algorithm KrylovNewton
        set ok [analyze {sub} [expr $dt/{sub}.0]]
        algorithm Newton
    }}
    if {{$ok != 0}} {{error "no convergence at [getTime]"}}
}}
"""

RIG = """constraints Transformation
numberer RCM
system FullGeneral
test NormDispIncr 1e-9 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] != 0} {error "no convergence at [getTime]"}
}
"""

WEIGHT = """timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
constraints Transformation
numberer RCM
system FullGeneral
test NormDispIncr 1e-10 40
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
"""


def columns(path):
    """Columns of a recorder's file."""
    with open(path) as f:
        return list(zip(*([float(x) for x in line.split()] for line in f if line.strip())))


def execute(command, model, run, script, folder):
    """Writes the motions of a run and its script to a folder and runs a command (a list of words) there. Returns the finished process."""
    values, files = model.settings(run)
    for file, series in files.items():
        with open(os.path.join(folder, file), "w") as f:
            f.writelines(f"{v:.9g}\n" for v in series)
    with open(os.path.join(folder, "model.tcl"), "w") as f:
        f.write("".join(f"set {k} {v}\n" for k, v in values.items()) + script + "\nwipe\n")
    return subprocess.run([*command, "model.tcl"], cwd=folder, capture_output=True, text=True)


def transient(handler="Plain", system="BandGeneral", sub=2):
    """The analysis of a shaken structure, in `sub` steps for each sample."""
    return TRANSIENT.format(handler=handler, system=system, sub=sub)


def run(name, role, dt, *motions, **also):
    """A run with motions; further variables of the script by name."""
    r = Run(name, role, dt, [list(m) for m in motions])
    r.also = also
    return r


def events(rng, pga=(3.5, 4.5), names=("main", "again"), seconds=16.0, dt=0.01):
    """Two earthquakes by peak acceleration: one fitted, one held out."""
    return [run(name, role, dt, signals.quake(rng, size, seconds, dt)) for name, role, size in zip(names, ("fit", "holdout"), pga)]


def swapped(text, old, new):
    """The script with a piece replaced, which must be there."""
    if old not in text:
        raise SystemExit(f"no {old!r} in the script")
    return text.replace(old, new)


def line(text, word):
    """The first line that has the word."""
    return next(x for x in text.splitlines() if word in x)


def place(model, channel, channels, at, runs=None):
    """The place of an effect: run, channel, those that count as right, and the place in the model."""
    fitted = [r.name for r in model.runs if r.role == "fit"]
    return {"run": (runs or fitted)[0], "accept_runs": runs or fitted, "channel": channel, "accept_channels": channels, "at": at}


def cycling(name, role, sizes, frequency, **also):
    """A run of cycles of growing size."""
    return run(name, role, 0.01, signals.cycles(sizes, frequency, 0.01), **also)


def quakes(rng, names, pga, seconds, dt, two=False, second=0.8):
    """Earthquakes by peak acceleration, in one or two directions; the last is held out."""
    roles = ["fit"] * (len(names) - 1) + ["holdout"]
    out = []
    for name, role, size in zip(names, roles, pga):
        motions = [signals.quake(rng, size, seconds, dt)]
        if two:
            motions.append(signals.quake(rng, second * size, seconds, dt))
        out.append(run(name, role, dt, *motions))
    return out
