"""The analyst's script with the underlying parameters and nothing concealed must give the response of the generator."""

import os
import tempfile

from generator import signals
from generator.case import sample
from generator.scripts import columns, execute


def effect_off(case, command):
    """Largest NMSE of a run and channel between the script, run by `command` (a list), and the generator."""
    m, worst = case.model, 0.0
    script = m.script
    for name, value in m.parameters.items():
        script = script.replace(f"@{name}@", repr(float(value)))
    script = script.replace("pset ", "set ")
    with tempfile.TemporaryDirectory() as folder:
        for run in m.runs:
            done = execute(command, m, run, script, folder)
            if done.returncode:
                raise RuntimeError(done.stderr[-2000:])
            for c in m.channels:
                table = columns(os.path.join(folder, c.output))
                y = case.clean[run.name][c.name]
                true = [sample(y, run.every, t) for t in table[0] if t <= run.seconds]
                error = sum((a - b) ** 2 for a, b in zip(true, table[c.column])) / len(true)
                worst = max(worst, error / signals.variance(true))
    return worst
