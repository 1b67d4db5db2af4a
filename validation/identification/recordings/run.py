#!/usr/bin/env python3
"""Calibrate models to real recordings, as README.md here says.

    validation/identification/recordings/run.py --data DIR [--out DIR] [STUDY ...] [WORD of hysteron calibrate ...]

HYSTERON names the binary (default target/release/hysteron).
"""
import argparse
import csv
import json
import os
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
BINARY = os.environ.get("HYSTERON", HERE.parent.parent.parent / "target/release/hysteron")


def columns(path):
    with path.open() as f:
        rows = list(csv.DictReader(f))
    return {name: [float(r[name]) for r in rows] for name in rows[0]}


def write(folder, name, motion, head, rows):
    (folder / f"{name}.dat").write_text("\n".join(f"{x:.9g}" for x in motion) + "\n")
    lines = "".join(",".join(f"{x:.9g}" for x in r) + "\n" for r in rows)
    (folder / f"{name}.csv").write_text(",".join(head) + "\n" + lines)


def steel(data, folder):
    """No times: a sample a second."""
    for name in ("example_1", "example_2"):
        c = columns(data / f"steel-coupon-cyclic-resspylab/{name}.csv")
        strain, stress = c["true_strain"], c["true_stress_MPa"]
        rows = [(i, s, e) for i, (s, e) in enumerate(zip(stress, strain))][1:]
        write(folder, name, strain, ["time[s]", "stress[MPa]", "displacement[-]"], rows)


def friction(data, folder):
    for name in ("harmonic_0.5Hz_36lb_1in", "harmonic_1Hz_36lb_1in", "eq_36lb_KocaeliDBE"):
        c = columns(data / f"friction-damper-backlash-brfd/{name}.csv")
        dt = 1 / 256
        rows = [(i * dt, f, u) for i, (f, u) in enumerate(zip(c["force_kN"], c["disp_mm"]))][1:]
        write(folder, name, c["disp_mm"], ["time[s]", "force[kN]", "disp[mm]"], rows)


def mr(data, folder):
    c = columns(data / "mr-damper-dyke-nees/ranran_50.csv")
    dt = 0.00099834
    for name, start in (("first", 0), ("next", 10000)):
        u, f = (c[k][start:start + 10000] for k in ("disp_mm", "force_N"))
        rows = [(i * dt, a, b) for i, (a, b) in enumerate(zip(f, u))][1:]
        write(folder, name, u, ["time[s]", "force[N]", "disp[mm]"], rows)


def bncs(data, folder):
    """The strong part of each motion: half a minute before the peak of the table to two minutes."""
    length = {}
    for name in ("LAC100", "ICA100", "CNP100", "ICA50"):
        c = columns(data / f"bncs-hdr-isolated-building/{name}.csv")
        ground = c["table_acc_m_s2"]
        peak = max(range(len(ground)), key=lambda i: abs(ground[i]))
        start, end = max(0, peak - 3000), min(len(ground), peak + 6000)
        names = ("disp_rel_table_level1_isolated_base_m", "abs_acc_level1_isolated_base_m_s2", "abs_acc_roof_m_s2")
        rows = list(zip([0.01 * (i - start) for i in range(start, end)], *(c[n][start:end] for n in names)))[1:]
        head = ["time[s]", "base_disp[m]", "base_acc[m/s2]", "roof_acc[m/s2]"]
        write(folder, name, ground[start:end], head, rows)
        length[name] = end - start
    for file in folder.glob("*.toml"):
        study = file.read_text()
        for name, n in length.items():
            study = study.replace(f"{{{name}}}", str(n))
        file.write_text(study)


STUDIES = {"steel_coupon": steel, "friction_damper": friction, "mr_damper": mr, "bncs_building": bncs}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--out", type=Path, default=Path("results/identification"))
    parser.add_argument("studies", nargs="*", default=list(STUDIES))
    args, words = parser.parse_known_args()
    rows = []
    for name in args.studies:
        folder = (args.out / name).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        for file in (HERE / name).iterdir():
            shutil.copy(file, folder)
        STUDIES[name](args.data, folder)
        for study in sorted(folder.glob("*.toml")):
            fit = folder / "fit" / study.stem
            subprocess.run([BINARY, "calibrate", study.name, "--out", fit, *words], cwd=folder, check=True)
            result = json.loads((fit / "calibration.json").read_text())
            for run in result["runs"]:
                rows.append(f"| {name}, {study.stem} | {run['role']} | {run['name']} | {run['nmse']:.4f} |")
    print("\n| study | role | run | NMSE |\n| --- | --- | --- | --- |\n" + "\n".join(rows))


if __name__ == "__main__":
    main()
