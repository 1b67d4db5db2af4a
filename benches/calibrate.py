#!/usr/bin/env python3
"""One identification by differential evolution, in hysteron and in openseespy, in one run on the same machine.

    benches/calibrate.py [--evaluations N]

The study is tcl-like-inputs/pad_study with 1800 steps an evaluation, a Bouc-Wen bearing element (elastomericBearingBoucWen),
N = 50, P = 150, F = 0.8, CR = 0.5. hysteron makes all 7550 evaluations, on one core and on all. openseespy makes N of them
(200) in process, the same evolution in Python, and its time for all is worked out from these. It needs openseespy and
numpy in the interpreter that runs it.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
STEPS, DT = 1800, 0.01
BOUNDS = np.array([[900.0, 2600.0], [8.0, 16.0], [0.15, 0.4]])
TRUTH = [1820.0, 13.1, 0.282]
NAMES = ["kInit", "qd", "alpha"]

MODEL = """wipe
model basic -ndm 2 -ndf 3
pset kInit 1500.0
pset qd 11.0
pset alpha 0.25
node 1 0.0 0.0
node 2 0.0 0.2
fix 1 1 1 1
fix 2 0 0 1
mass 2 0.05 0.05 0.001
uniaxialMaterial Elastic 1 4.0e5
uniaxialMaterial Elastic 2 1.0e5
element elastomericBearingBoucWen 1 1 2 $kInit $qd $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Path 1 -dt $dt -filePath motion.dat -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] != 0} {error "no convergence at [getTime]"}
}
"""


def motion():
    t = np.arange(STEPS + 1) * DT
    return 0.004 * (1 + np.floor(t / 3)) * np.sin(2 * math.pi * t / 1.5)


def peer_force(ops, values, path):
    """The model in openseespy, its force read after each step."""
    k, qd, alpha = values
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.node(1, 0.0, 0.0)
    ops.node(2, 0.0, 0.2)
    ops.fix(1, 1, 1, 1)
    ops.fix(2, 0, 0, 1)
    ops.mass(2, 0.05, 0.05, 0.001)
    ops.uniaxialMaterial("Elastic", 1, 4.0e5)
    ops.uniaxialMaterial("Elastic", 2, 1.0e5)
    ops.element("elastomericBearingBoucWen", 1, 1, 2, k, qd, alpha, 0.0, 2.0, 1.0, 0.5, 0.5,
                "-P", 1, "-Mz", 2, "-orient", 0, 1, 0, -1, 0, 0)
    ops.timeSeries("Path", 1, "-dt", DT, "-values", *path, "-useLast")
    ops.pattern("Plain", 1, 1)
    ops.sp(2, 1, 1.0)
    ops.constraints("Transformation")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1.0e-9, 50)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", DT)
    ops.analysis("Static")
    force = np.empty(STEPS)
    for i in range(STEPS):
        if ops.analyze(1) != 0:
            return None
        force[i] = ops.eleResponse(1, "force")[3]
    return force


def peer(evaluations, path, recorded):
    """Differential evolution in Python; CPU seconds an evaluation."""
    import openseespy.opensees as ops

    rng = np.random.default_rng(1)
    variance = recorded.var()

    def score(x):
        force = peer_force(ops, BOUNDS[:, 0] + x * (BOUNDS[:, 1] - BOUNDS[:, 0]), path)
        return math.inf if force is None else ((force - recorded) ** 2).mean() / variance

    n = 50
    begun = time.process_time()
    members = rng.random((n, 3))
    scores = np.array([score(m) for m in members])
    done = n
    while done < evaluations:
        for i in range(n):
            a, b, c = rng.choice([j for j in range(n) if j != i], 3, replace=False)
            v = np.clip(members[a] + 0.8 * (members[b] - members[c]), 0, 1)
            cross = rng.random(3) < 0.5
            cross[rng.integers(3)] = True
            u = np.where(cross, v, members[i])
            s = score(u)
            if s < scores[i]:
                members[i], scores[i] = u, s
            done += 1
    return (time.process_time() - begun) / done


def ours(folder, threads):
    binary = os.environ.get("HYSTERON", ROOT / "target/release/hysteron")
    out = folder / f"out{threads}"
    command = [binary, "calibrate", folder / "study.toml", "--out", out, "--threads", str(threads)]
    before = os.times()
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    after = os.times()
    result = json.loads((out / "calibration.json").read_text())
    return result, after.children_user - before.children_user


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--evaluations", type=int, default=200)
    args = parser.parse_args()
    path = motion()
    import openseespy.opensees as ops
    recorded = peer_force(ops, TRUTH, path.tolist())
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        (folder / "model.tcl").write_text(MODEL)
        (folder / "motion.dat").write_text("\n".join(map(repr, path.tolist())))
        rows = [f"{(i + 1) * DT:.4f},{f!r}" for i, f in enumerate(recorded.tolist())]
        (folder / "test.csv").write_text("time[s],force[kN]\n" + "\n".join(rows) + "\n")
        bounds = "".join(f'[[parameter]]\nname = "{n}"\nlower = {a}\nupper = {b}\n' for n, (a, b) in zip(NAMES, BOUNDS))
        (folder / "study.toml").write_text(
            f'model = "model.tcl"\n{bounds}[[run]]\nname = "test"\nrecording = "test.csv"\n'
            f'set = {{ dt = {DT}, npts = {STEPS + 1} }}\n[[run.observe]]\nchannel = "force"\noutput = "force.out"\ncolumn = 4\n'
            '[calibration]\nmethod = "de/rand/1/bin"\npopulation = 50\ngenerations = 150\n')
        there = peer(args.evaluations, path.tolist(), recorded)
        cores = os.cpu_count()
        rows = [(n, *ours(folder, n)) for n in sorted({1, cores})]
    print(f"openseespy: {1000 * there:.1f} ms of CPU an evaluation, {7550 * there / 60:.1f} min for 7550")
    for threads, result, cpu in rows:
        each = cpu / result["evaluations"]
        found = ", ".join(f"{n} {v:.6g}" for n, v in result["parameters"].items())
        print(f"hysteron, {threads} threads: {1000 * each:.2f} ms of CPU an evaluation ({there / each:.0f} times less), "
              f"{result['wall_s']:.1f} s for {result['evaluations']}; objective {result['objective']:.2e}, {found}")


if __name__ == "__main__":
    sys.exit(main())
