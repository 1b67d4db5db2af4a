#!/usr/bin/env python3
"""The thesis' tests with self-heating and softening concealed, diagnosed: table and picture.

    diagnosed.py [--out DIR] [--hysteron FILE] [--threads N] [--results DIR]

runs `hysteron diagnose` on `tcl-like-inputs/hdr_heating_study/study.toml` and `thermometer.toml`, prints the table of README.md,
and draws heating.svg: a run held out, by the model as it is and by the repaired one. Hours of a core. With `--results` the
diagnoses of an earlier call are read. The truth is that of `integrator.py`, which needs numpy and scipy.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess

import integrator

HERE = pathlib.Path(__file__).resolve().parent
STUDIES = {"study": "without thermometer", "thermometer": "with thermometer"}
TRUTH = {
    "heatCapacity": ("heat capacity, MPa/K", integrator.CAPACITY),
    "excess": ("excess of the softening", integrator.EXCESS),
    "strain": ("strain of the softening", integrator.STRAIN),
    **{name: (name, value) for name, value in integrator.FACTORS.items()},
}
# The run that the picture shows, and the seconds of it.
SHOWN, SECONDS = "fast_d", 2.0


def parameter(values, name):
    """A parameter of the model, or of the repair, whose names have a prefix `hy_` or `hy2_`."""
    return next((x for key, x in values.items() if key in (name, f"hy_{name}", f"hy2_{name}")), None)


def remaining(folder, channel, by):
    """Root mean square of what a model leaves of a channel of the runs held out; `by` is simulated or repaired."""
    missed = []
    for run in ("slow_c", "fast_d"):
        for row in csv.DictReader((folder / "channels" / f"{run}.csv").open()):
            column = {key.split("[")[0]: value for key, value in row.items()}
            if f"{channel}_recorded" in column:
                missed.append(float(column[f"{channel}_recorded"]) - float(column[f"{channel}_{by}"]))
    return math.sqrt(sum(x * x for x in missed) / len(missed)) if missed else None


def table(results, folders):
    """Rows of Markdown from diagnosis.json of each study, and from the folders of channels."""
    head = ["", "true"]
    for label in results:
        head += [f"{label}: as it is", "repaired"]
    rows = [head, ["---"] * len(head)]
    cause = ["cause"] + [""]
    for d in results.values():
        v = d["verdict"]
        cause += ["", " + ".join([v["cause"], *v["also"]]) + f", {100 * v['confidence']:.0f} %"]
    rows.append(cause)
    for name, (label, truth) in TRUTH.items():
        row = [label, f"{truth:.4g}"]
        for d in results.values():
            before, after = (parameter(d[k]["parameters"], name) for k in ("baseline", "corrected"))
            interval = parameter({s["name"]: s["interval"] for s in d["verdict"]["summary"]["sizes"]}, name)
            cell = "" if after is None else f"{after:.4f} ({100 * (after / truth - 1):+.1f} %)"
            cell += f", {interval[0]:.3f} to {interval[1]:.3f}" if interval else ""
            row += ["" if before is None else f"{before:.4f}", cell]
        rows.append(row)
    for key, label in (("fit_nmse", "NMSE fitted"), ("holdout_nmse", "NMSE held out")):
        row = [label, ""]
        for d in results.values():
            row += [f"{d[k][key]:.2g}" for k in ("baseline", "corrected")]
        rows.append(row)
    for channel, unit, noise in (("stress", "MPa", integrator.NOISE), ("inside", "K", integrator.NOISE_TEMPERATURE)):
        row = [f"{channel} held out, {unit} (noise)", f"{noise}"]
        for folder in folders:
            left = [remaining(folder, channel, by) for by in ("simulated", "repaired")]
            row += ["" if x is None else f"{x:.3g}" for x in left]
        rows.append(row)
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)


def draw(hysteron, results, out):
    """heating.svg: the beginning of the run held out, from channels/*.csv of the diagnosis."""
    strains = [float(r["strain[-]"]) for r in csv.DictReader((integrator.STUDY / f"{SHOWN}.csv").open())]
    rows = list(csv.DictReader((results / "study/channels" / f"{SHOWN}.csv").open()))
    shown = [(g, r) for g, r in zip(strains, rows) if float(r["time[s]"]) <= SECONDS]
    numbers = lambda values: "{" + " ".join(f"{float(x):.4f}" for x in values) + "}"
    strain = numbers(g for g, _ in shown)
    curves = [("recorded", "recorded"), ("model as it is", "simulated"), ("repaired", "repaired")]
    words = " ".join(
        f'{"-dots" if column == "recorded" else "-line"} "{label}" {strain} {numbers(r[f"stress_{column}[MPa]"] for _, r in shown)}'
        for label, column in curves
    )
    script = out / "heating.tcl"
    script.write_text(f'figure heating.svg -title "held out: 23 degC, 1 Hz" -x "shear strain" -y "shear stress, MPa" {words}\n')
    subprocess.run([hysteron, "run", script.name], cwd=out, check=True)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/thesis"))
    p.add_argument("--hysteron", default="hysteron")
    p.add_argument("--threads", default="1")
    p.add_argument("--results", type=pathlib.Path, help="folder with the diagnoses of an earlier call")
    a = p.parse_args()
    a.out.mkdir(parents=True, exist_ok=True)
    results = a.results or a.out
    if a.results is None:
        for study in STUDIES:
            words = [a.hysteron, "diagnose", integrator.STUDY / f"{study}.toml", "--threads", a.threads, "--out", a.out / study]
            subprocess.run(words, check=True)
    found = {label: json.loads((results / study / "diagnosis.json").read_text()) for study, label in STUDIES.items()}
    print(table(found, [results / study for study in STUDIES]))
    draw(a.hysteron, results, a.out)


if __name__ == "__main__":
    main()
