#!/usr/bin/env python3
"""One identification by differential evolution, in hysteron and in openseespy, in one run on the same machine.

    benches/calibrate.py [--evaluations N] [BEARING ...]

Bearings: plane (elastomericBearingBoucWen in the plane), boucwen (the same element in space), hdr (HDR in space) and kikuchi
(KikuchiBearing with 8 shear and twice 30x30 normal springs), on a path of growing amplitude, in space under constant axial load. Three parameters of each are sought with 1800 steps an evaluation, N = 50,
P = 150, F = 0.8, CR = 0.5. hysteron makes all 7550 evaluations, on one core and on all that it may use. openseespy makes N of them
(150) in process, the same evolution in Python, and its time for all is worked out from these. Times are of the processor, and
those of openseespy are of evaluations that have an answer: one that does not converge ends early.
It needs openseespy and numpy in the interpreter that runs it.
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
MEMBERS, GENERATIONS = 50, 150

# Of each bearing: name, lower bound, upper bound and truth of its parameters, the smallest amplitude of the path, and where its
# force along x is in the response "force". Units: kN, m, s in the plane, N, m, s in space.
BEARINGS = {
    "plane": ([("kInit", 900.0, 2600.0, 1820.0), ("qd", 8.0, 16.0, 13.1), ("alpha", 0.15, 0.4, 0.282)], 0.004, 3),
    "boucwen": ([("kInit", 2e6, 8e6, 5e6), ("qd", 4e4, 1.2e5, 8e4), ("alpha", 0.05, 0.3, 0.1)], 0.02, 6),
    "hdr": ([("a1", 5e5, 2e6, 1.1e6), ("b1", 5e3, 4e4, 1.8e4), ("b2", 1e5, 8e5, 4e5)], 0.02, 6),
    "kikuchi": ([("cg", 0.7, 1.4, 1.0), ("ch", 0.7, 1.4, 1.0), ("cu", 0.7, 1.4, 1.0)], 0.02, 6),
    # Storeys on a bearing that the ground shakes: the amplitude is an acceleration.
    "storeys": ([("kInit", 1000.0, 6000.0, 3000.0), ("qd", 10.0, 100.0, 40.0), ("alpha", 0.05, 0.3, 0.1)], 1.0, 3),
}
SHAKEN = {"storeys"}


def analysis(tolerance, step):
    return [
        ["constraints", "Transformation"], ["numberer", "Plain"], ["system", "BandGeneral"],
        ["test", "NormDispIncr", tolerance, 50], ["algorithm", "Newton"], ["integrator", "LoadControl", step], ["analysis", "Static"],
    ]


def storeys(p, path):
    """Two storeys on a bearing under a motion of the ground."""
    vertical = ["-dir", 2, "-orient", 0, 1, 0, -1, 0, 0]
    levels = [(2, 0.3), (3, 3.3), (4, 6.3)]
    script = [["model", "basic", "-ndm", 2, "-ndf", 3], ["node", 1, 0.0, 0.0], ["fix", 1, 1, 1, 1]]
    for tag, height in levels:
        script += [["node", tag, 0.0, height], ["fix", tag, 0, 1, 1], ["mass", tag, 100.0, 1e-9, 1e-9]]
    return script + [
        ["uniaxialMaterial", "Elastic", 1, 1.0e7], ["uniaxialMaterial", "Elastic", 2, 1.0e3], ["uniaxialMaterial", "Elastic", 3, 4.0e4],
        ["element", "elastomericBearingBoucWen", 1, 1, 2, *p, 0.0, 1.0, 1.0, 0.5, 0.5,
         "-P", 1, "-Mz", 2, "-orient", 0, 1, 0, -1, 0, 0],
        ["element", "twoNodeLink", 2, 2, 3, "-mat", 3, *vertical, "-doRayleigh"],
        ["element", "twoNodeLink", 3, 3, 4, "-mat", 3, *vertical, "-doRayleigh"],
        ["region", 1, "-ele", 2, 3, "-rayleigh", 0.0, 0.0, 0.002, 0.0],
        ["timeSeries", "Path", 2, "-dt", DT, *path],
        ["pattern", "UniformExcitation", 2, 1, "-accel", 2],
        ["constraints", "Plain"], ["numberer", "Plain"], ["system", "BandGeneral"],
        ["test", "NormUnbalance", 1.0e-8, 25], ["algorithm", "Newton"], ["integrator", "Newmark", 0.5, 0.25], ["analysis", "Transient"],
    ]


def commands(bearing, p, path):
    """The script up to its last `analyze`, once for both programs: `p` are values or Tcl's variables, `path` is the path's option."""
    if bearing == "storeys":
        return storeys(p, path)
    if bearing == "plane":
        script = [
            ["model", "basic", "-ndm", 2, "-ndf", 3],
            ["node", 1, 0.0, 0.0], ["node", 2, 0.0, 0.2], ["fix", 1, 1, 1, 1], ["fix", 2, 0, 0, 1],
            ["uniaxialMaterial", "Elastic", 1, 4.0e5], ["uniaxialMaterial", "Elastic", 2, 1.0e5],
            ["element", "elastomericBearingBoucWen", 1, 1, 2, *p, 0.0, 2.0, 1.0, 0.5, 0.5,
             "-P", 1, "-Mz", 2, "-orient", 0, 1, 0, -1, 0, 0],
        ]
    else:
        script = [
            ["model", "basic", "-ndm", 3, "-ndf", 6],
            ["node", 1, 0.0, 0.0, 0.0], ["node", 2, 0.0, 0.0, 0.3], ["fix", 1, 1, 1, 1, 1, 1, 1], ["fix", 2, 0, 1, 0, 1, 1, 1],
            ["uniaxialMaterial", "Elastic", 1, 1.0e9],
        ]
        if bearing == "boucwen":
            law = ["elastomericBearingBoucWen", 1, 1, 2, *p, 0.0, 3.0, 1.0, 0.5, 0.5]
            law += ["-P", 1, "-T", 1, "-My", 1, "-Mz", 1, "-orient", 0, 0, 1, 1, 0, 0]
        elif bearing == "kikuchi":
            script += [
                ["uniaxialMaterial", "KikuchiAikenHDR", 2, "X0.6", 0.36, 0.15, "-coGHU", *p],
                ["uniaxialMaterial", "AxialSp", 3, 1.2e9, 1.0e6, -100.0e6, 1.0, 0.01, 0.5, 0.0],
            ]
            law = ["KikuchiBearing", 1, 1, 2, "-shape", "square", "-size", 0.60, 0.15, "-totalHeight", 0.3, "-nMSS", 8, "-matMSS", 2]
            law += ["-limDisp", 0.0015, "-nMNS", 30, "-matMNS", 3, "-lambda", 1.7]
        else:
            a1, b1, b2 = p
            law = ["HDR", 1, 1, 2, 0.45e6, 2.0e9, 0.15, 0.60, 0.003, 0.006, 28, a1, -6.0e6, 9.0e7, b1, b2, 60.0]
            law += [4.0, 1.5, 0.75, 3.0, 0, 0, 1, 1, 0, 0, 10.0, 0.5, 1.0, 0.5, 0.0, 0.0]
        script += [
            ["element", *law],
            ["timeSeries", "Linear", 1],
            ["pattern", "Plain", 1, 1, [["load", 2, 0.0, 0.0, -1.0e6, 0.0, 0.0, 0.0]]],
            *analysis(1.0e-7, 0.1), ["analyze", 10], ["loadConst", "-time", 0.0], ["wipeAnalysis"],
        ]
    return script + [
        ["timeSeries", "Path", 2, "-dt", DT, *path, "-useLast"],
        ["pattern", "Plain", 2, 2, [["sp", 2, 1, 1.0]]],
        *analysis(1.0e-9, DT),
    ]


def tcl(script):
    words = lambda c: " ".join("{\n" + tcl(w) + "}" if isinstance(w, list) else str(w) for w in c)
    return "".join(words(c) + "\n" for c in script)


def call(ops, script):
    for name, *args in script:
        loads = args.pop() if args and isinstance(args[-1], list) else []
        getattr(ops, name)(*args)
        call(ops, loads)


def motion(amplitude):
    t = np.arange(STEPS + 1) * DT
    return amplitude * (1 + np.floor(t / 3)) * np.sin(2 * math.pi * t / 1.5)


def step_length(bearing):
    return [DT] if bearing in SHAKEN else []


def peer_force(ops, bearing, values, path):
    """The force in openseespy, read after each step: quicker than its recorder and the file of that."""
    ops.wipe()
    call(ops, commands(bearing, [float(v) for v in values], ["-values", *path]))
    at = BEARINGS[bearing][2]
    force = np.empty(STEPS)
    length = step_length(bearing)
    for i in range(STEPS):
        if ops.analyze(1, *length) != 0:
            return None
        force[i] = ops.eleResponse(1, "force")[at]
    return force


def peer(ops, evaluations, bearing, path, recorded):
    """Differential evolution in Python: CPU seconds an evaluation that has an answer, and how many had none."""
    rng = np.random.default_rng(1)
    bounds = np.array([row[1:3] for row in BEARINGS[bearing][0]])
    variance = recorded.var()

    answered = []

    def score(x):
        begun = time.process_time()
        force = peer_force(ops, bearing, bounds[:, 0] + x * (bounds[:, 1] - bounds[:, 0]), path)
        if force is None:
            return math.inf
        answered.append(time.process_time() - begun)
        return ((force - recorded) ** 2).mean() / variance

    members = rng.random((MEMBERS, 3))
    scores = np.array([score(m) for m in members])
    done, failed = MEMBERS, int(np.isinf(scores).sum())
    while done < evaluations:
        for i in range(MEMBERS):
            a, b, c = rng.choice([j for j in range(MEMBERS) if j != i], 3, replace=False)
            v = np.clip(members[a] + 0.8 * (members[b] - members[c]), 0, 1)
            cross = rng.random(3) < 0.5
            cross[rng.integers(3)] = True
            u = np.where(cross, v, members[i])
            s = score(u)
            failed += math.isinf(s)
            if s < scores[i]:
                members[i], scores[i] = u, s
            done += 1
    return sum(answered) / len(answered), failed


def write_study(folder, bearing, path, recorded):
    parameters, _, at = BEARINGS[bearing]
    psets = "".join(f"pset {name} {truth}\n" for name, _, _, truth in parameters)
    script = commands(bearing, [f"${name}" for name, *_ in parameters], ["-filePath", "motion.dat"])
    (folder / "model.tcl").write_text(
        f"wipe\n{psets}{tcl(script)}recorder Element -file force.out -time -ele 1 force\n"
        f'if {{[analyze {" ".join(map(str, [STEPS, *step_length(bearing)]))}] != 0}} {{error "no convergence at [getTime]"}}\n')
    (folder / "motion.dat").write_text("\n".join(map(repr, path)))
    rows = "".join(f"{(i + 1) * DT:.4f},{f!r}\n" for i, f in enumerate(recorded.tolist()))
    (folder / "test.csv").write_text("time[s],force[-]\n" + rows)
    bounds = "".join(f'[[parameter]]\nname = "{n}"\nlower = {a}\nupper = {b}\n' for n, a, b, _ in parameters)
    (folder / "study.toml").write_text(
        f'model = "model.tcl"\n{bounds}[[run]]\nname = "test"\nrecording = "test.csv"\n'
        f'[[run.observe]]\nchannel = "force"\noutput = "force.out"\ncolumn = {at + 1}\n'
        f'[calibration]\nmethod = "de/rand/1/bin"\npopulation = {MEMBERS}\ngenerations = {GENERATIONS}\n')


def ours(folder, threads):
    binary = os.environ.get("HYSTERON", ROOT / "target/release/hysteron")
    out = folder / f"out{threads}"
    command = [binary, "calibrate", folder / "study.toml", "--out", out, "--threads", str(threads)]
    before = os.times()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    result = json.loads((out / "calibration.json").read_text())
    cpu = after.children_user - before.children_user + after.children_system - before.children_system
    return result, cpu / result["evaluations"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--evaluations", type=int, default=150)
    parser.add_argument("bearings", nargs="*", default=list(BEARINGS), metavar="BEARING")
    args = parser.parse_args()
    import openseespy.opensees as ops
    for bearing in args.bearings:
        path = motion(BEARINGS[bearing][1]).tolist()
        recorded = peer_force(ops, bearing, [row[3] for row in BEARINGS[bearing][0]], path)
        there, failed = peer(ops, args.evaluations, bearing, path, recorded)
        whole = MEMBERS * (GENERATIONS + 1)
        print(f"{bearing}: openseespy {1000 * there:.1f} ms of CPU an evaluation ({failed} more without an answer), "
              f"{whole * there / 60:.1f} min for {whole}")
        with tempfile.TemporaryDirectory() as place:
            write_study(Path(place), bearing, path, recorded)
            for threads in sorted({1, len(os.sched_getaffinity(0))}):
                result, here = ours(Path(place), threads)
                found = ", ".join(f"{n} {v:.6g}" for n, v in result["parameters"].items())
                print(f"{bearing}: hysteron on {threads} threads {1000 * here:.2f} ms of CPU an evaluation ({there / here:.1f} times "
                      f"less), {result['wall_s']:.1f} s for {result['evaluations']}; objective {result['objective']:.2e}, "
                      f"{found}, failures {sum(result['failures'].values())}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
