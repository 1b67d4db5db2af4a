#!/usr/bin/env python3
"""Concealed in engineers' models: runs what `concealed/` holds in OpenSees and writes the studies of `cases/` and the truths of `truth/`.

    python3 make.py --opensees "python -m opensees"

OpenSees is whatever command runs a Tcl script with it. Unlike those of ../blind the models are none of the families of ../power.
"""

import argparse
import hashlib
import json
import os
import random
import shlex
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "power"))

from checks import columns  # noqa: E402
from generator import signals  # noqa: E402
from generator.case import Case  # noqa: E402
from generator.model import Channel, Run, number  # noqa: E402

import models  # noqa: E402

NAMES = ("kyanite", "lazurite", "malachite", "nephrite", "onyx", "peridot", "quartz", "ruby", "sapphire", "topaz", "unakite", "variscite", "wulfenite", "xenotime", "zircon")


class Structure:
    """A model as the generator's cases want it."""

    family, slow = "structure", 1.0

    def __init__(self, title, script, parameters, runs, channels):
        self.title, self.script, self.parameters, self.runs, self.channels = title, script, parameters, runs, channels

    def settings(self, run):
        files = {f"{run.name}{suffix}.dat": motion for suffix, motion in zip(("", "-2"), run.motions)}
        values = {name: file for name, file in zip(("motion", "second"), files)}
        return {**values, "dt": run.dt, "npts": run.npts, **run.also}, files

    def context(self, run, times, rng):
        return []

    def filled(self):
        script = self.script
        for name, value in self.parameters.items():
            script = script.replace(f"@{name}@", number(value))
        return script.replace("pset ", "set ")


class Sealed(Case):
    """A case whose response comes from a script that OpenSees ran."""

    def __init__(self, name, model, concealed, rng, level):
        self.model, self.effects, self.rng, self.level = model, [name], rng, level
        self.truth, self.told = (concealed["cause"], *concealed.get("also", ())), concealed.get("where", {})
        self.strengths, self.achieved = [], []
        self.script, self.fault = concealed["script"], concealed.get("fault")

    def where(self):
        return self.told

    def simulate(self, command, script):
        m, out = self.model, {}
        with tempfile.TemporaryDirectory() as folder:
            for run in m.runs:
                values, files = m.settings(run)
                for file, series in files.items():
                    with open(os.path.join(folder, file), "w") as f:
                        f.writelines(f"{v:.9g}\n" for v in series)
                text = "".join(f"set {k} {v}\n" for k, v in values.items()) + script + "\nwipe\n"
                with open(os.path.join(folder, "model.tcl"), "w") as f:
                    f.write(text)
                done = subprocess.run(command + ["model.tcl"], cwd=folder, capture_output=True, text=True)
                if done.returncode:
                    raise SystemExit(f"{self.effects} {self.truth}: {done.stderr[-3000:]}")
                n = round(run.seconds / run.every)
                out[run.name] = {}
                for c in m.channels:
                    table = columns(os.path.join(folder, c.output))
                    if not table or table[0][-1] < 0.98 * run.seconds:
                        raise SystemExit(f"{self.effects} {self.truth}: {run.name} ends early\n{done.stderr[-2000:]}")
                    out[run.name][c.name] = [signals.interpolate(table[0], table[c.column], i * run.every) for i in range(n + 1)]
        return out

    def run_all(self, command):
        """The concealed response, and by how much it differs from the analyst's script with the same parameters."""
        self.clean = self.simulate(command, self.script)
        if self.fault:
            for run in self.model.runs:
                self.fault(run, self.clean[run.name])
        plain = self.simulate(command, self.model.filled())
        off = {}
        for run in self.model.runs:
            for c in self.model.channels:
                a, b = self.clean[run.name][c.name], plain[run.name][c.name]
                off[run.name, c.name] = sum((x - y) ** 2 for x, y in zip(a, b)) / len(a) / signals.variance(a)
        return off

    def response(self, run, strengths):
        return {c: list(v) for c, v in self.clean[run.name].items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--opensees", required=True)
    parser.add_argument("--seed", type=int, default=5)
    parser.add_argument("--only", type=int, nargs="*", help="try these, and write nothing")
    args = parser.parse_args()
    rng = random.Random(f"order {args.seed}")
    names = list(NAMES)
    rng.shuffle(names)
    seals = []
    for number_, (name, make) in enumerate(zip(names, models.ALL)):
        if args.only is not None and number_ not in args.only:
            continue
        own = random.Random(f"structures {args.seed} {number_}")
        title, script, parameters, runs, channels, conceal = make(own)
        model = Structure(f"{title}, series {name}", f"# {title}, series {name}\n" + script, parameters, runs, channels)
        case = Sealed(name, model, conceal(model), own, 10 ** own.uniform(-1.9, -1.4))
        off = case.run_all(shlex.split(args.opensees))
        print(number_, case.truth, {f"{r} {c}": f"{v:.2g}" for (r, c), v in off.items()}, flush=True)
        if args.only is not None:
            continue
        folder = os.path.join(HERE, "cases", name)
        case.write(folder)
        os.makedirs(os.path.join(HERE, "truth"), exist_ok=True)
        os.makedirs(os.path.join(HERE, "concealed"), exist_ok=True)
        os.replace(os.path.join(folder, "truth.json"), os.path.join(HERE, "truth", name + ".json"))
        with open(os.path.join(HERE, "concealed", name + ".tcl"), "w") as f:
            f.write(case.script)
        seals += [f"truth/{name}.json", f"concealed/{name}.tcl"]
    if args.only is None:
        with open(os.path.join(HERE, "sealed.sha256"), "w") as out:
            for path in sorted(seals) + ["make.py", "models.py"]:
                with open(os.path.join(HERE, path), "rb") as f:
                    out.write(f"{hashlib.sha256(f.read()).hexdigest()}  {path}\n")


if __name__ == "__main__":
    main()
