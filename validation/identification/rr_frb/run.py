#!/usr/bin/env python3
"""The twin of the paper's identification (Flora, Calabrese and Cardone 2023), as README.md here says.

    validation/identification/rr_frb/run.py [--out DIR] [--target reconstructed|twin] [--models NAME ...] [WORD of hysteron calibrate ...]

HYSTERON names the binary (default target/release/hysteron).
"""
import argparse
import json
import math
import os
import random
import re
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
BINARY = os.environ.get("HYSTERON", HERE.parent.parent.parent / "target/release/hysteron")
HEIGHT = 0.2  # m, of the rubber
K30 = 393.3e3  # N/m, that of bouc_wen/model.tcl as it is: the reconstruction leaves the absolute force open
XI30 = 0.215  # equivalent damping
# Shear strain, and stiffness and energy over those at 30 %.
TARGETS = [(0.15, 1.61, 0.31), (0.20, 1.43, 0.54), (0.30, 1.0, 1.0), (0.40, 0.70, 1.51), (0.50, 0.54, 2.17), (0.60, 0.41, 2.81)]
DT, CYCLES = 0.02, 3


def path():
    """At 0.5 Hz, three cycles at each amplitude: rows of target, time and phase."""
    rows, t = [], 0
    for target in TARGETS:
        for i in range(1, round(CYCLES * 2 / DT) + 1):
            t += 1
            rows.append((target, t * DT, math.pi * i * DT))
    return rows


def write_motion(folder):
    u = [0.0] + [strain * HEIGHT * math.sin(phase) for (strain, _, _), _, phase in path()]
    (folder / "motion.dat").write_text("\n".join(f"{x:.9g}" for x in u) + "\n")


def write_recording(folder, forces):
    rows = ["time[s],force[N],disp[m]"]
    rows += [
        f"{t:.2f},{force:.9g},{strain * HEIGHT * math.sin(phase):.9g}"
        for force, ((strain, _, _), t, phase) in zip(forces, path())
    ]
    (folder / "target.csv").write_text("\n".join(rows) + "\n")


def reconstructed(_):
    """Ellipses of the wanted stiffness and energy."""
    e30 = 2 * math.pi * XI30 * K30 * (0.3 * HEIGHT) ** 2
    forces = []
    for (strain, k, e), _, phase in path():
        u0 = strain * HEIGHT
        forces.append(k * K30 * u0 * math.sin(phase) + e * e30 / (math.pi * u0) * math.cos(phase))
    return forces


def twin(folder):
    """The forces of twin.tcl, with noise of 1 % of the largest."""
    words = f"set motion motion.dat; set dt {DT}; set npts {len(path()) + 1}; source twin.tcl\n"
    (folder / "drive.tcl").write_text(words)
    subprocess.run([Path(BINARY).resolve(), "run", "drive.tcl"], cwd=folder, check=True)
    forces = [float(line.split()[7]) for line in (folder / "force.out").read_text().splitlines()]
    noise, size = random.Random(1), 0.01 * max(map(abs, forces))
    return [f + noise.gauss(0.0, size) for f in forces]


# Loops of the fitted models over those of the target.
LOOPS = """
lassign [columns [lindex {%s} 0]/target.csv] time target u
foreach name {%s} {
    lassign [columns $name/force.out] t p1 p2 p3 p4 p5 p6 force
    figure $name.svg -title "$name over the %s target" -x "displacement, m" -y "force, N" \\
        -line target $u $target -line $name $u $force
}
"""

# The paper's Fig 8: the target and all models together.
MEASURES = {"energy": "energy of a cycle, J", "stiffness": "secant stiffness, N/m", "damping": "equivalent damping"}


def draw_measures(out, models):
    """Pictures fig_8_MEASURE.svg in `out`, from the calibrations of `models`."""
    results = {m: json.loads((out / m / "fit/calibration.json").read_text()) for m in models}
    rows = {m: result["runs"][0]["channels"][0]["amplitudes"] for m, result in results.items()}
    numbers = lambda values: "{" + " ".join(f"{x:.9g}" for x in values) + "}"
    script = []
    for measure, label in MEASURES.items():
        curves = [("target", [r[measure][0] for r in rows[models[0]]])]
        curves += [(m, [r[measure][1] for r in rows[m]]) for m in models]
        strain = numbers(100 * r["amplitude"] / HEIGHT for r in rows[models[0]])
        lines = " ".join(f"-line {name} {strain} {numbers(values)}" for name, values in curves)
        script.append(f'figure fig_8_{measure}.svg -title "{label}, by amplitude" -x "shear strain, %" -y "{label}" {lines}')
    (out / "fig_8.tcl").write_text("\n".join(script) + "\n")
    run("fig_8.tcl", out)


def run(script, folder):
    subprocess.run([Path(BINARY).resolve(), "run", script], cwd=folder, check=True, capture_output=True)


def draw(out, models, target):
    """Pictures MODEL.svg in `out`, from the fitted scripts."""
    for folder in (out / model for model in models):
        shutil.copy(folder / "fit/fitted.tcl", folder)
        (folder / "drive.tcl").write_text(f"set motion motion.dat; set dt {DT}; set npts {len(path()) + 1}; source fitted.tcl\n")
        run("drive.tcl", folder)
    (out / "loops.tcl").write_text(LOOPS % (" ".join(models), " ".join(models), target))
    run("loops.tcl", out)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", type=Path, default=Path("results/rr_frb"))
    parser.add_argument("--target", choices=["reconstructed", "twin"], default="reconstructed")
    parser.add_argument("--models", nargs="+", default=["bouc_wen", "hdr", "kikuchi", "kikuchi_soft"])
    parser.add_argument("--population", type=int, help="members, in place of the paper's 50")
    parser.add_argument("--generations", type=int, help="generations, in place of the paper's 150")
    args, words = parser.parse_known_args()
    out = args.out / args.target
    shutil.copytree(HERE, out, dirs_exist_ok=True)
    shutil.copytree(HERE.parent.parent.parent / "models", out / "models", dirs_exist_ok=True)
    write_motion(out)
    forces = {"reconstructed": reconstructed, "twin": twin}[args.target](out)
    for model in args.models:
        folder = out / model
        write_motion(folder)
        write_recording(folder, forces)
        study = (folder / "study.toml").read_text()
        for key, value in (("population", args.population), ("generations", args.generations)):
            if value:
                study = re.sub(rf"^{key}( *)=.*$", rf"{key}\1= {value}", study, flags=re.M)
        (folder / "study.toml").write_text(study)
        subprocess.run([Path(BINARY).resolve(), "calibrate", "study.toml", "--out", "fit", *words], cwd=folder, check=True)
        print(f"## {model}, {args.target} target")
        report(json.loads((folder / "fit/calibration.json").read_text()))
    draw(out, args.models, args.target)
    draw_measures(out, args.models)


def report(result):
    print(json.dumps({k: result[k] for k in ("parameters", "spread", "failures", "at_bound")}, indent=1))
    print("| shear strain | stiffness | energy | damping |\n| --- | --- | --- | --- |")
    for row in result["runs"][0]["channels"][0]["amplitudes"]:
        pairs = (row[k] for k in ("stiffness", "energy", "damping"))
        errors = " | ".join(f"{100 * (simulated / target - 1):+.0f} %" for target, simulated in pairs)
        print(f"| {100 * row['amplitude'] / HEIGHT:.0f} % | {errors} |")


if __name__ == "__main__":
    main()
