#!/usr/bin/env python3
"""Fits models made by hand for the runs held out of a study, and writes their errors beside the diagnosis: handmade.csv.

    validation/recordings/handmade.py OUT [--engine HYSTERON]

OUT is the folder of results of run.py with its BUILD, which has the recordings of each source. A model made by hand knows which
condition a run was recorded in: its parameters are fitted to the runs of that condition alone, which were fitted in the study too.
"""
import argparse
import csv
import json
import re
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent
# Source, study, runs that are fitted; those that the study holds out stay so. The model is that of the study.
CASES = [
    ("switched", "brake_repeated", ["30lb_1in_again"], "its own friction"),
    ("switched", "brake_36_30", ["30lb_1in"], "its own friction"),
    ("switched", "brake_36_0", ["0lb_1in"], "its own friction"),
    ("switched", "valve_24_12", ["valve_12_a"], "its own power law"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--engine", default="hysteron")
    args = parser.parse_args()
    table = HERE / "handmade.csv"
    rows = {}
    if table.exists():
        with table.open() as f:
            rows = {(r["source"], r["study"]): list(r.values()) for r in csv.DictReader(f)}
    for source, study, fitted, model in CASES:
        folder = args.out / source
        if not folder.is_dir():
            print(f"{source}: run.py has not prepared it")
            continue
        text = (folder / f"{study}.toml").read_text()
        head, *runs = text.split("[[run]]")
        kept = [r for r in runs if 'role      = "holdout"' in r or re.search(r'name\s*=\s*"([^"]+)"', r)[1] in fitted]
        (folder / "_handmade.toml").write_text("[[run]]".join([head, *kept]))
        subprocess.run([args.engine, "calibrate", "_handmade.toml", "--out", "_handmade"], cwd=folder, check=True, capture_output=True)
        said = json.loads((folder / "_handmade/calibration.json").read_text())
        rows[source, study] = [source, study, model, f"{said['holdout']:.4g}"]
        print(*rows[source, study], flush=True)
    with table.open("w") as f:
        csv.writer(f, lineterminator="\n").writerows([["source", "study", "model", "held_out"], *(rows[k] for k in sorted(rows))])


if __name__ == "__main__":
    main()
