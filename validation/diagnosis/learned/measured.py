#!/usr/bin/env python3
"""Laws learned from measured recordings and from cases made elsewhere, and the error of the runs held out.

    validation/diagnosis/learned/measured.py [--data DIR] [--cases DIR] [--jobs N] [--out DIR] [--engine HYSTERON]

Writes its table to the README. DIR is the folder that `recordings/run.py` takes. --cases names a folder of cases with their truth, of
which those are learned whose cause is `unknown`; it may be given twice. Standard library only.
"""
import argparse
import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "recordings"))
import run  # noqa: E402

from learn import held_out, learned, write_table  # noqa: E402

# Largest error of the runs held out that is asked of a study, mean NMSE.
ASKED = {
    "steel_coupon/perfectly_plastic": 0.012, "steel_coupon/bilinear": 0.012, "polymer/tension": 0.10,
    "hydraulic_damper/temperature_known": 0.006, "hydraulic_damper/temperature_dropped": 0.006,
    "mr_damper/no_voltage": 0.04, "rocking_wall/bilinear": 0.035, "plate_wall/bilinear": 0.10, "bncs/without_LAC100": 0.07,
    "masonry_wall/bilinear": None, "polymer/shear": None, "friction_damper/no_backlash": None,
}
# Error over that of the noise that is asked of a made case.
ASKED_OVER_NOISE = 1.5
HEAD = "| study | kinds of memory | fitted, user → law | blocks held back | held out, user → law | asked | outside the range | seconds |"


def line(name, asked, found):
    limit = f"{asked:.2g}" if asked else ""
    if "refused" in found:
        return f"| {name} | no law | | | | {limit} | | {found['seconds']:.1f} |"
    user, law = held_out(found)
    return (f"| {name} | {found['family']} | {' → '.join(found['fitted'])} | {found['blocks'][1]} | {user:.2e} → {law:.2e} | {limit} "
            f"| {found['outside']} % | {found['seconds']:.1f} |")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--data", type=Path)
    p.add_argument("--cases", type=Path, action="append", default=[])
    p.add_argument("--jobs", type=int, default=1)
    p.add_argument("--out", type=Path, default=Path("results/learned"))
    p.add_argument("--engine", default="target/release/hysteron")
    args = p.parse_args()
    engine, out = str(Path(args.engine).resolve()), args.out.resolve()
    studies = []
    for key, asked in ASKED.items():
        source, variant = key.split("/")
        if run.prepared(args.data, source, out / source):
            file, _ = run.study_of(source, variant, out / source)
            studies.append((key, asked, out / source / file))
    for truth in (t for cases in args.cases for t in sorted(cases.resolve().glob("*/truth.json"))):
        said = json.loads(truth.read_text())
        if said["cause"] == "unknown":
            studies.append((truth.parent.name, ASKED_OVER_NOISE * said["noise_floor_nmse_holdout"], truth.parent / "study.toml"))

    def row(study):
        name, asked, file = study
        made = line(name, asked, learned(engine, file, out / "laws" / name))
        print(made, flush=True)
        return made
    with ThreadPoolExecutor(args.jobs) as pool:
        rows = list(pool.map(row, studies))
    write_table(HERE / "README.md", "measured", HEAD, rows)


main()
