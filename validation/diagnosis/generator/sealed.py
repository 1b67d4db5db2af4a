"""Cases of sealed batches: the response comes from a script with the concealed effect, which OpenSees runs."""

import os
import random
import tempfile

from . import signals
from .case import Case
from .model import number
from .scripts import columns, execute


def mean_square(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)


class Structure:
    """The analyst's model, as `Case` wants it. Parameters are written `@name@` in the script."""

    family, slow = "structure", 1.0

    def __init__(self, title, script, parameters, runs, channels):
        self.title, self.script, self.parameters, self.runs, self.channels = title, script, parameters, runs, channels

    def settings(self, run):
        """(variables of the script, {file: motion}) of a run."""
        files = {f"{run.name}{suffix}.dat": motion for suffix, motion in zip(("", "-2"), run.motions)}
        values = dict(zip(("motion", "second"), files))
        return {**values, "dt": run.dt, "npts": run.npts, **run.also}, files

    def context(self, run, times, rng):
        """Recorded columns that no observation names: functions of time that a run carries, with a little scatter."""
        aside = getattr(run, "aside", {}).items()
        return [(head, [f"{of(t) + rng.gauss(0, scatter):.5g}" for t in times]) for head, (of, scatter) in aside]

    def filled(self):
        """The script with the true parameters."""
        script = self.script
        for name, value in self.parameters.items():
            script = script.replace(f"@{name}@", number(value))
        return script.replace("pset ", "set ")


class SealedCase(Case):
    """`concealed` has the cause, the script that holds it, where it shows, and perhaps a fault of the recording."""

    def __init__(self, name, model, concealed, rng, untimed):
        self.model, self.effects, self.rng, self.level = model, [name], rng, 10 ** rng.uniform(-1.9, -1.4)
        self.truth, self.place = (concealed["cause"], *concealed.get("also", ())), concealed.get("where", {})
        self.strengths, self.achieved = [], []
        self.script, self.fault, self.untimed = concealed["script"], concealed.get("fault"), untimed

    def where(self):
        return self.place

    def recorded(self, path):
        """Columns of a file, with times where the recorder wrote none and no channel is its column 0."""
        table, step = columns(path), self.untimed.get(os.path.basename(path))
        if table and step:
            table[0] = [(i + 1) * step for i in range(len(table[0]))]
        return table

    def run_once(self, command, script, run):
        """Channels of one run of a script, at equal steps."""
        with tempfile.TemporaryDirectory() as folder:
            done = execute(command, self.model, run, script, folder)
            if done.returncode:
                raise SystemExit(f"{self.effects} {self.truth}: {done.stderr[-3000:]}")
            out = {}
            for c in self.model.channels:
                table = self.recorded(os.path.join(folder, c.output))
                if not table or table[0][-1] < 0.98 * run.seconds:
                    raise SystemExit(f"{self.effects} {self.truth}: {run.name} ends early\n{done.stderr[-2000:]}")
                steps = round(run.seconds / run.every) + 1
                out[c.name] = [signals.interpolate(table[0], table[c.column], i * run.every) for i in range(steps)]
            return out

    def simulate(self, command, script):
        return {run.name: self.run_once(command, script, run) for run in self.model.runs}

    def run_all(self, command):
        """Finds the response. Returns the NMSE of the analyst's script with the same parameters, for each run and channel."""
        self.clean = self.simulate(command, self.script)
        if self.fault:
            for run in self.model.runs:
                self.fault(run, self.clean[run.name])
        plain = self.simulate(command, self.model.filled())
        return {(run, channel): mean_square(values, plain[run][channel]) / signals.variance(values)
                for run, channels in self.clean.items() for channel, values in channels.items()}

    def response(self, run, strengths):
        return {c: list(v) for c, v in self.clean[run.name].items()}


def cases(batch):
    """(name, case) of a module of `batches`. Which name a case has is drawn, so that it tells nothing."""
    names = list(batch.NAMES)
    random.Random(f"order {batch.SEED}").shuffle(names)
    for number_of_case, (name, make) in enumerate(zip(names, batch.CASES)):
        rng = random.Random(f"{batch.STREAM} {batch.SEED} {number_of_case}")
        title, script, parameters, runs, channels, conceal = make(rng)
        model = Structure(f"{title}, series {name}", f"# {title}, series {name}\n" + script, parameters, runs, channels)
        yield name, SealedCase(name, model, conceal(model), rng, getattr(batch, "UNTIMED", {}))
