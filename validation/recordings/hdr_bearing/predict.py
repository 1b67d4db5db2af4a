#!/usr/bin/env python3
"""Predicts seven cycles at 148 % from the fit to 98 %, which were never seen here: predicted.csv.

    validation/recordings/hdr_bearing/predict.py DATA [--engine HYSTERON] [--out DIR]

DATA is the folder that run.py takes. The law that the diagnosis found is fitted by `hysteron calibrate`, once to all samples and once to
each of 24 random halves of the cycles. The interval is the second least and second largest force of these. Standard library only.
"""
import argparse
import json
import math
import random
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
sys.dont_write_bytecode = True
import prepare  # noqa: E402
from bench import columns  # noqa: E402

PER_CYCLE, CYCLES, AMPLITUDE = 80, 7, 23.0
HALVES = 24
LAW = {"linear": (68.0, 3.0, 600.0, "log"), "fifth": (320.0, 0.0, 3200.0, "linear"), "softening": (1.0, 0.0, 3.0, "linear"),
       "cycles": (1.0, 0.0, 5.0, "linear"), "strength": (2.3, 0.16, 32.0, "log"), "sharpness": (80.0, 3.0, 1000.0, "log"),
       "transition": (0.32, 0.1, 3.0, "log"), "hardening": (0.1, 0.0, 0.45, "linear")}
COMMAND = ("uniaxialMaterial HDR_mat 1 $linear 0.0 $fifth [expr {$softening*1.13}] 0.38 0.0 1.0 [expr {$softening*3.70}] 0.37 "
           "[expr {$cycles*0.0676}] 0.57 [expr {$sharpness*$strength}] $strength 0.9 $transition $hardening 0.018 15.229")


def calibrated(engine, folder, name, recording, count):
    """Parameters and NMSE of the law fitted to a recording."""
    rows = [f'  {{ name = "{n}", lower = {lo}, upper = {hi}, scale = "{scale}" }},' for n, (_, lo, hi, scale) in LAW.items()]
    (folder / f"{name}.toml").write_text("\n".join([
        'model = "law.tcl"', 'material = "rubber"', "parameter = [", *rows, "]", "[[run]]", 'name = "run"', f'recording = "{recording}"',
        f'set = {{ motion = "shear_{PER_CYCLE}.dat", dt = 1.0, npts = {count} }}',
        'observe = [{ channel = "force", output = "force.out", column = 2 }]', ""]))
    subprocess.run([engine, "calibrate", f"{name}.toml", "--out", name], cwd=folder, check=True, capture_output=True)
    said = json.loads((folder / name / "calibration.json").read_text())
    return said["parameters"], said["objective"]


def forces(engine, folder, values, motion):
    """Force at each displacement of a motion."""
    sets = "".join(f"pset {n} {values[n]!r}\n" for n in LAW)
    script = re.sub(r"^pset .*\n", "", (folder / "law.tcl").read_text(), flags=re.M)
    script = f"set motion {motion.name}\nset dt 1.0\nset npts {len(motion.read_text().split())}\n" + sets + script
    (folder / "ahead.tcl").write_text(script)
    subprocess.run([engine, "run", "ahead.tcl"], cwd=folder, check=True, capture_output=True)
    return [float(line.split()[2]) for line in (folder / "force.out").read_text().splitlines()]


def main():
    p = argparse.ArgumentParser()
    p.add_argument("data", type=Path)
    p.add_argument("--engine", default=str(HERE.parents[2] / "target/release/hysteron"))
    p.add_argument("--out", type=Path, default=HERE.parents[2] / "results/hdr_bearing_ahead")
    args = p.parse_args()
    args.engine, folder = str(Path(args.engine).resolve()), args.out.resolve()
    prepare.prepare(args.data, folder)
    declared = "\n".join(f"pset {n} {start}" for n, (start, *_) in LAW.items())
    model = re.sub(r"^pset .*\n", "", (HERE / "model.tcl").read_text(), flags=re.M)
    (folder / "law.tcl").write_text(re.sub(r"^uniaxialMaterial .*$", declared + "\n" + COMMAND, model, flags=re.M))

    seen = columns(folder / f"shear_{PER_CYCLE}.csv")
    u, f = seen["disp[cm]"], seen["force[tonf]"]
    ahead = [AMPLITUDE * math.sin(2 * math.pi * k / PER_CYCLE) for k in range(1, CYCLES * PER_CYCLE + 1)]
    motion = folder / "ahead.dat"
    motion.write_text("".join(f"{x:.6g}\n" for x in [*u, *ahead]))

    values, nmse = calibrated(args.engine, folder, "all", f"shear_{PER_CYCLE}.csv", len(u))
    best = forces(args.engine, folder, values, motion)[-len(ahead):]
    chance, others = random.Random(1), []
    for half in range(HALVES):
        kept = set(chance.sample(range(21), 11))
        name = f"half_{half}"
        rows = [f"{i},{y if min(20, i * 21 // len(u)) in kept else ''}" for i, y in enumerate(f)]
        (folder / f"{name}.csv").write_text("time[s],force[tonf]\n" + "\n".join(rows) + "\n")
        others.append(forces(args.engine, folder, calibrated(args.engine, folder, name, f"{name}.csv", len(u))[0], motion)[-len(ahead):])
    band = [sorted(x) for x in zip(*others)]
    rows = [f"{x:.4f},{y:.4f},{b[1]:.4f},{b[-2]:.4f}" for x, y, b in zip(ahead, best, band)]
    (HERE / "predicted.csv").write_text("displacement[cm],force[tonf],low[tonf],high[tonf]\n" + "\n".join(rows) + "\n")
    peaks = [max(best[k * PER_CYCLE:(k + 1) * PER_CYCLE]) for k in range(CYCLES)]
    width = [band[PER_CYCLE // 4 - 1][i] for i in (1, -2)]
    print(f"fitted to 98 %: NMSE {nmse:.4f}; {', '.join(f'{n} {v:.3g}' for n, v in values.items())}")
    print(f"148 %: largest force of each cycle {', '.join(f'{x:.1f}' for x in peaks)} tonf; first quarter {best[PER_CYCLE // 4 - 1]:.1f} ({width[0]:.1f} to {width[1]:.1f})")


main()
