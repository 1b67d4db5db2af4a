"""The analyst's script with the underlying parameters and nothing concealed must give the response of the generator."""

import os
import subprocess
import tempfile

from generator import signals
from generator.case import sample
from generator.model import number


def columns(path):
    with open(path) as f:
        return list(zip(*([float(x) for x in line.split()] for line in f if line.strip())))


def effect_off(case, command):
    """Largest NMSE of a run and channel between the script, run by `command` (a list), and the generator."""
    m, worst = case.model, 0.0
    script = m.script
    for name, value in m.parameters.items():
        script = script.replace(f"@{name}@", repr(float(value)))
    with tempfile.TemporaryDirectory() as folder:
        for run in m.runs:
            values, files = m.settings(run)
            for name, series in files.items():
                with open(os.path.join(folder, name), "w") as f:
                    f.writelines(f"{v:.9g}\n" for v in series)
            sets = "".join(f"set {k} {v}\n" for k, v in values.items())
            plain = script.replace("pset ", "set ")
            with open(os.path.join(folder, "check.tcl"), "w") as f:
                f.write(sets + plain + "\nwipe\n")
            done = subprocess.run(command + ["check.tcl"], cwd=folder, capture_output=True, text=True)
            if done.returncode:
                raise RuntimeError(done.stderr[-2000:])
            for c in m.channels:
                table = columns(os.path.join(folder, c.output))
                y = case.clean[run.name][c.name]
                true = [sample(y, run.every, t) for t in table[0] if t <= run.seconds]
                error = sum((a - b) ** 2 for a, b in zip(true, table[c.column])) / len(true)
                worst = max(worst, error / signals.variance(true))
    return worst
