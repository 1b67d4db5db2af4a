#!/usr/bin/env python3
"""Concealed by OpenSees: runs the scripts of `concealed/` and writes the studies of `cases/` and the truths of `truth/`.

    python3 make.py --opensees "python -m opensees"

OpenSees is whatever command runs a Tcl script with it. The analyst's scripts come from the families of `../power/generator`.
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
from generator.chains import Chain  # noqa: E402
from generator.model import number  # noqa: E402
from generator.pads import Pad  # noqa: E402

NAMES = ("amber", "basalt", "cobalt", "dolomite", "emerald", "flint", "garnet", "heliodor", "iolite", "jasper")


class Sealed(Case):
    """A case whose response comes from a script that OpenSees ran."""

    def __init__(self, name, model, cause, also, where, script, rng, level):
        self.model, self.truth, self.effects, self.rng, self.level = model, (cause, *also), [name], rng, level
        self.strengths, self.achieved, self.places, self.told = [], [], [], where
        self.script = script

    def where(self):
        return self.told

    def run_all(self, command):
        self.clean = {}
        m = self.model
        with tempfile.TemporaryDirectory() as folder:
            for run in m.runs:
                values, files = m.settings(run)
                for file, series in files.items():
                    with open(os.path.join(folder, file), "w") as f:
                        f.writelines(f"{v:.9g}\n" for v in series)
                values["npts"] = run.npts
                text = "".join(f"set {k} {v}\n" for k, v in values.items()) + self.script + "\nwipe\n"
                with open(os.path.join(folder, "model.tcl"), "w") as f:
                    f.write(text)
                done = subprocess.run(command + ["model.tcl"], cwd=folder, capture_output=True, text=True)
                if done.returncode:
                    raise SystemExit(done.stderr[-3000:])
                n = round(run.seconds / run.every)
                self.clean[run.name] = {}
                for c in m.channels:
                    table = columns(os.path.join(folder, c.output))
                    if not table or table[0][-1] < 0.98 * run.seconds:
                        raise SystemExit(f"{self.effects}: {run.name} ends early\n{done.stderr[-2000:]}")
                    parts = m.truth_columns.get(c.name, (c.column,))
                    total = [sum(v) for v in zip(*(table[j] for j in parts))]
                    self.clean[run.name][c.name] = [signals.interpolate(table[0], total, i * run.every) for i in range(n + 1)]

    def response(self, run, strengths):
        return {c: list(v) for c, v in self.clean[run.name].items()}


def model_of(make, seed, causes, family, **want):
    """The first model of the family from this seed on that has these attributes."""
    for s in range(seed, seed + 400):
        m = make(random.Random(f"blind {s}"), causes, family)
        if all(getattr(m, k) == v for k, v in want.items()) and m.units.L == 1.0:
            m.truth_columns = {}
            return m
    raise SystemExit(f"no {family} with {want}")


def filled(model):
    script = model.script
    for name, value in model.parameters.items():
        script = script.replace(f"@{name}@", number(value))
    return script.replace("pset ", "set ")


def swapped(text, old, new):
    if old not in text:
        raise SystemExit(f"no {old!r} in the script")
    return text.replace(old, new)


def line_with(text, word):
    return next(line for line in text.splitlines() if word in line)


def build(seed0):
    """(model, cause, also, where, concealed script) of each case, in an order that the names do not tell."""
    cases = []
    here = {"accept_channels": ["force"], "channel": "force", "run": "first", "accept_runs": ["first", "second"], "at": "element 1"}

    m = model_of(Pad, seed0, ["mullins_softening"], "pad", kind="spring")
    U = signals.peak(m.runs[0].motions[0])
    for r in m.runs:
        r.motions[0] = [v * 0.22 / U for v in r.motions[0]]
    m.parameters = {"ko": 3.0e6, "Qd": 3.0e4, "alpha": 0.2}
    m.truth_columns = {"force": (7,)}
    growing = dict(here, run="growing", accept_runs=["growing", "steady"])
    cases.append((m, "mullins_softening", ["strain_stiffening", "cyclic_degradation"], growing, HDR))

    m = model_of(Pad, seed0 + 7, ["strain_stiffening"], "pad", kind="spring")
    U = signals.peak(m.runs[0].motions[0])
    for r in m.runs:
        r.motions[0] = [v * 0.40 / U for v in r.motions[0]]
    m.parameters = {"ko": 5.0e6, "Qd": 5.5e4, "alpha": 0.08}
    cases.append((m, "strain_stiffening", ["mullins_softening"], here, swapped(filled(m), line_with(m.script, "uniaxialMaterial BoucWen"),
                  "uniaxialMaterial KikuchiAikenHDR 1 X0.6 0.16 0.16")))

    m = model_of(Pad, seed0 + 20, ["bidirectional_coupling"], "pad")
    p = m.parameters
    uncoupled = filled(m)
    m.truth_columns = {"force_x": (7,), "force_y": (8,)}
    text = COUPLED.format(ko=number(p["ko"]), Qd=number(p["Qd"]), alpha=number(p["alpha"]), kv=number(1e3 * p["ko"]), kr=number(10 * p["ko"]))
    text += uncoupled[uncoupled.index("timeSeries Path 1"):].replace("node 2 -dof", "node 2 -dof")
    orbit = {"run": "first", "accept_runs": ["first", "second"], "channel": "force_x", "accept_channels": ["force_x", "force_y"], "at": "element 1"}
    cases.append((m, "bidirectional_coupling", [], orbit, text))

    m = model_of(Chain, seed0 + 40, ["x"], "building", law_kind="wen")
    top = m.scale(1).F
    k = m.k[0] * m.parameters.get("rk", 1.0)
    old = [line for line in filled(m).splitlines() if line.startswith("uniaxialMaterial Elastic 11")][0]
    storey = {"run": "event-1", "accept_runs": ["event-1", "event-2"], "channel": "roof_acc", "accept_channels": [c.name for c in m.channels], "at": "storey 1"}
    cases.append((m, "superstructure_yielding", [], storey, swapped(filled(m), old, f"uniaxialMaterial Steel02 11 {number(0.45 * top)} {number(k)} 0.04 18.0 0.925 0.15")))

    m = model_of(Chain, seed0 + 60, ["x"], "pier", law_kind="wen")
    kp = 3 * m.E * m.I / m.H**3
    text = swapped(filled(m), "fix 1 1 1 1\n", "node 3 0.0 0.0\nfix 3 1 1 1\nmass 1 {m} {m} {j}\n".format(m=number(0.3 * m.masses[0]), j=number(0.2 * m.masses[0])))
    soil = (f"uniaxialMaterial Elastic 31 {number(2.5 * kp)}\nuniaxialMaterial Viscous 32 {number(0.02 * kp)} 1.0\n"
            f"uniaxialMaterial Elastic 33 {number(1.2 * kp * m.H**2)}\nuniaxialMaterial Viscous 34 {number(0.01 * kp * m.H**2)} 1.0\n"
            f"uniaxialMaterial Elastic 35 {number(50 * kp)}\nelement zeroLength 30 3 1 -mat 31 32 35 33 34 -dir 1 1 2 3 3\n")
    text = swapped(text, "geomTransf Linear 1\n", soil + "geomTransf Linear 1\n")
    pier = {"run": "event-1", "accept_runs": ["event-1", "event-2"], "channel": "pier_disp", "accept_channels": ["pier_disp", "pier_acc", "deck_acc", "bearing_def"], "at": "support"}
    cases.append((m, "foundation_flexibility", [], pier, text))

    m = model_of(Pad, seed0 + 80, ["pinching"], "pad", kind="spring", n=1.0)
    old = next(line for line in filled(m).splitlines() if line.startswith("uniaxialMaterial BoucWen"))
    U, p = m.U, m.parameters
    uy = m.uy
    F1, F2 = p["Qd"] * 0.9 + p["alpha"] * p["ko"] * uy, p["Qd"] + p["alpha"] * p["ko"] * 1.1 * U
    e = f"{number(F1 * 0.6)} {number(uy * 0.6)} {number(F1)} {number(uy * 1.3)} {number(0.5 * (F1 + F2))} {number(0.55 * U)} {number(F2)} {number(1.3 * U)}"
    cases.append((m, "pinching", ["cyclic_degradation"], here, swapped(filled(m), old,
                  f"uniaxialMaterial Pinching4 1 {e} 0.45 0.25 0.02 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 10.0 energy")))

    m = model_of(Pad, seed0 + 100, ["varying_axial_load"], "pad", kind="plastic", vertical_in_script=True)
    p = m.parameters
    m.truth_columns = {"force": (4, 10)}
    k2, mu = p["alpha"] * p["kInit"], p["Qd"] / m.P0
    old = next(line for line in filled(m).splitlines() if line.startswith("element elastomeric"))
    slider = (f"frictionModel Coulomb 1 {number(mu)}\nelement flatSliderBearing 1 1 2 1 {number(p['kInit'] - k2)} -P 1 -Mz 2 -orient 0 1 0 -1 0 0 -iter 50 1.0e-10\n"
              f"node 5 0.0 {number(0.2)}\nfix 5 1 1 1\nuniaxialMaterial Elastic 5 {number(k2)}\nelement zeroLength 5 5 2 -mat 5 -dir 1")
    text = swapped(filled(m), old, slider)
    text = swapped(text, "recorder Element -file force.out -time -ele 1 force", "recorder Element -file force.out -time -ele 1 5 force")
    cases.append((m, "varying_axial_load", [], here, text))

    m = model_of(Chain, seed0 + 120, ["x"], "building", law_kind="wen")
    U, F = m.scale(0).U, m.scale(0).F
    wall = (f"uniaxialMaterial ElasticPPGap 41 {number(6 * F / U)} {number(1e3 * F)} {number(0.7 * U)} 0.0\n"
            f"uniaxialMaterial ElasticPPGap 42 {number(6 * F / U)} {number(-1e3 * F)} {number(-0.7 * U)} 0.0\n"
            "element zeroLength 40 1 2 -mat 41 42 -dir 1 1\n")
    text = swapped(filled(m), "\n# storeys\n", wall + "\n# storeys\n")
    moat = {"run": "event-1", "accept_runs": ["event-1"], "channel": "base_acc", "accept_channels": ["base_disp", "base_acc", "roof_acc"], "at": "isolation layer"}
    cases.append((m, "gap_impact", [], moat, text))

    m = model_of(Chain, seed0 + 140, ["x"], "building", law_kind="wen")
    cases.append((m, "none", [], {}, filled(m)))

    m = model_of(Chain, seed0 + 160, ["x"], "frame")
    n = len(m.masses)
    mt = 0.08 * sum(m.masses)
    w = 0.93 * m.w1
    tank = (f"node 50 0.0 -mass {number(mt)}\nuniaxialMaterial Elastic 51 {number(mt * w * w)}\nuniaxialMaterial Viscous 52 {number(2 * 0.02 * mt * w)} 1.0\n"
            f"element zeroLength 50 {n + 1} 50 -mat 51 52 -dir 1 1\n")
    text = swapped(filled(m), "\n# storeys\n", tank + "\n# storeys\n")
    roof = {"run": "event-1", "accept_runs": ["event-1", "event-2"], "channel": "roof_acc", "accept_channels": ["roof_acc", "roof_disp", "floor1_acc"], "at": "roof"}
    cases.append((m, "unknown", [], roof, text))
    return cases


HDR = """wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.25
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
element HDR 1 1 2 0.45e6 2.0e9 0.15 0.60 0.003 0.006 28 1.1e6 -6.0e6 9.0e7 1.8e4 4.0e5 60.0 4.0 1.5 0.75 3.0 0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0
timeSeries Linear 9
pattern Plain 9 9 {
    load 2 0.0 0.0 -1.0e6 0.0 0.0 0.0
}
constraints Transformation
numberer RCM
system FullGeneral
test NormUnbalance 1e-6 60
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer RCM
system FullGeneral
test NormUnbalance 1e-6 100
algorithm Newton
integrator LoadControl $dt
analysis Static
analyze [expr $npts-1]
"""

COUPLED = """wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.0
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
uniaxialMaterial Elastic 1 {kv}
uniaxialMaterial Elastic 2 {kr}
element elastomericBearingBoucWen 1 1 2 {ko} {Qd} {alpha} 0.0 2.0 2.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--opensees", required=True)
    parser.add_argument("--seed", type=int, default=2)
    args = parser.parse_args()
    rng = random.Random(f"order {args.seed}")
    cases = build(1000 * args.seed)
    names = list(NAMES)
    rng.shuffle(names)
    seals = []
    for name, (model, cause, also, where, script) in zip(names, cases):
        model.title = model.title.split(",")[0] + ", series " + name
        model.script = "# " + model.title + "\n" + model.script.split("\n", 1)[1]
        case = Sealed(name, model, cause, also, where, script, rng, 10 ** rng.uniform(-1.9, -1.4))
        case.run_all(shlex.split(args.opensees))
        folder = os.path.join(HERE, "cases", name)
        case.write(folder)
        os.makedirs(os.path.join(HERE, "truth"), exist_ok=True)
        os.makedirs(os.path.join(HERE, "concealed"), exist_ok=True)
        os.replace(os.path.join(folder, "truth.json"), os.path.join(HERE, "truth", name + ".json"))
        with open(os.path.join(HERE, "concealed", name + ".tcl"), "w") as f:
            f.write(script)
        seals += [f"truth/{name}.json", f"concealed/{name}.tcl"]
        print(name, cause, json.dumps(model.parameters))
    with open(os.path.join(HERE, "sealed.sha256"), "w") as out:
        for path in sorted(seals) + ["make.py"]:
            with open(os.path.join(HERE, path), "rb") as f:
                out.write(f"{hashlib.sha256(f.read()).hexdigest()}  {path}\n")


if __name__ == "__main__":
    main()
