#!/usr/bin/env python3
"""The twin of the paper's identification, as README.md here says.

    validation/rr_frb/run.py [--out DIR] [WORD of hysteron calibrate ...]

HYSTERON names the binary (default target/release/hysteron).
"""
import argparse
import json
import math
import os
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
BINARY = os.environ.get("HYSTERON", HERE.parent.parent / "target/release/hysteron")
HEIGHT = 0.2  # m, of the rubber
K30 = 393.3e3  # N/m, that of bouc_wen/model.tcl as it is: the reconstruction leaves the absolute force open
XI30 = 0.215  # equivalent damping
# Shear strain, and stiffness and energy over those at 30 %.
TARGETS = [(0.15, 1.61, 0.31), (0.20, 1.43, 0.54), (0.30, 1.0, 1.0), (0.40, 0.70, 1.51), (0.50, 0.54, 2.17), (0.60, 0.41, 2.81)]
DT, CYCLES = 0.02, 3


def write_target(folder):
    """At 0.5 Hz, three ellipses of the wanted stiffness and energy at each amplitude."""
    e30 = 2 * math.pi * XI30 * K30 * (0.3 * HEIGHT) ** 2
    path, rows, t = [0.0], ["time[s],force[N],disp[m]"], 0
    for strain, k, e in TARGETS:
        u0 = strain * HEIGHT
        for i in range(1, round(CYCLES * 2 / DT) + 1):
            t += 1
            phase = math.pi * i * DT
            u = u0 * math.sin(phase)
            force = k * K30 * u + e * e30 / (math.pi * u0) * math.cos(phase)
            path.append(u)
            rows.append(f"{t * DT:.2f},{force:.9g},{u:.9g}")
    (folder / "motion.dat").write_text("\n".join(f"{u:.9g}" for u in path) + "\n")
    (folder / "target.csv").write_text("\n".join(rows) + "\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", type=Path, default=Path("results/rr_frb"))
    args, words = parser.parse_known_args()
    shutil.copytree(HERE, args.out, dirs_exist_ok=True)
    folder = args.out / "bouc_wen"
    write_target(folder)
    subprocess.run([Path(BINARY).resolve(), "calibrate", "study.toml", "--out", "fit", *words], cwd=folder, check=True)
    report(json.loads((folder / "fit/calibration.json").read_text()))


def report(result):
    print(json.dumps({k: result[k] for k in ("parameters", "spread", "failures", "at_bound")}, indent=1))
    print("| shear strain | stiffness | energy | damping |\n| --- | --- | --- | --- |")
    for row in result["runs"][0]["channels"][0]["amplitudes"]:
        pairs = (row[k] for k in ("stiffness", "energy", "damping"))
        errors = " | ".join(f"{100 * (simulated / target - 1):+.0f} %" for target, simulated in pairs)
        print(f"| {100 * row['amplitude'] / HEIGHT:.0f} % | {errors} |")


if __name__ == "__main__":
    main()
