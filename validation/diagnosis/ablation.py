#!/usr/bin/env python3
"""Makes each number of the verdict's prior neutral in turn, and counts the verdicts that change.

    python3 validation/diagnosis/ablation.py [--cases 20] [--only NAME ...] [--threads N]

Each number is changed in a copy of the source, which is built once for it. The cases are the quickest trials of the seeds from --seed on. Rows go to
ablation.csv; numbers that have a row are not tried again, so that a run goes on where it was stopped. A number takes some minutes, all of them most of a day.
"""

import argparse
import csv
import json
import os
import re
import shutil
import subprocess
import sys

from generator.plan import draw, plan

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
TABLE = os.path.join(HERE, "ablation.csv")
PRIOR = os.path.join("crates", "diagnose", "src", "prior.rs")
NUMBER = re.compile(r"^    ([A-Z_]+): (\w+) = ([^,\[\]]+), \"", re.M)
QUICK = ("pad", "frame")

# Values at which a number says nothing. All others are halved.
NEUTRAL = {
    "COMPLETE_MODEL_LOG_ODDS": "0.0",
    "ONE_EFFECT_LOG_ODDS": "0.0",
    "RANGE_FAULT_IN_ALL_RUNS_LOG_ODDS": "0.0",
    "VISIBLE_FAULT_LOG_ODDS": "0.0",
    "AUXILIARY_CHANNEL_LOG_ODDS": "0.0",
    "EQUAL_FORM_LOG_EVIDENCE": "0.0",
    "MAX_NOISE_ROOT": "1.0",
    "MAX_LINEAR_STEP": "1.0",
    "MIN_REPAIR_GAIN": "0.0",
    "MIN_STRUCTURE_FOR_PAIRS": "1.0",
    "MIN_REPORTED_PROBABILITY": "0.0",
    "PREDICTED_SHARE": "0.0",
    "MIN_HOLDOUT_SIGNAL_RATIO": "1.0",
    "NEGLIGIBLE_RESIDUAL": "1e-12",
    "REGRESSION_RIDGE": "1e-9",
    "NEGLIGIBLE_STEP_ERROR": "1.0",
    "MAX_STEP_PARTS": "1",
}


def neutral(name, kind, value):
    if name in NEUTRAL:
        return NEUTRAL[name]
    return f"{float(value) / 2!r}" if kind == "f64" else str(max(1, int(value) // 2))


def build(tree):
    subprocess.run(["cargo", "build", "--quiet", "--release", "--target-dir", os.path.join(tree, "target")], cwd=tree, check=True)
    return os.path.join(tree, "target", "release", "hysteron")


def copied(out):
    """A copy of the source that is built apart from the working tree."""
    tree = os.path.join(out, "tree")
    if not os.path.exists(tree):
        names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
        for name in filter(None, names):
            target = os.path.join(tree, name)
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copy2(os.path.join(ROOT, name), target)
    shutil.copyfile(os.path.join(ROOT, PRIOR), os.path.join(tree, PRIOR))
    return tree


def cases(args):
    """Folders of the studies, made of their seeds."""
    seed = args.seed
    for _ in range(args.cases):
        while plan(seed)[0] not in QUICK:
            seed += 1
        folder = os.path.join(args.out, "cases", str(seed))
        if not os.path.exists(os.path.join(folder, "study.toml")):
            draw(seed).write(folder)
        yield seed, folder
        seed += 1


def answers(engine, studies, out, threads):
    """{seed: (causes, confidence)}; the answer of an engine that fails is its exit status."""
    said = {}
    for seed, folder in studies:
        to = os.path.join(out, str(seed))
        command = [engine, "diagnose", os.path.join(folder, "study.toml"), "--out", to, "--threads", str(threads)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            said[seed] = (f"exit {done.returncode}", 0.0)
            continue
        with open(os.path.join(to, "diagnosis.json")) as f:
            verdict = json.load(f)["verdict"]
        said[seed] = (" + ".join([verdict["cause"], *verdict["also"]]), verdict["confidence"])
    return said


def tried():
    if not os.path.exists(TABLE):
        with open(TABLE, "w") as f:
            csv.writer(f, lineterminator="\n").writerow(["number", "value", "tried", "cases", "verdicts_changed", "mean_change_of_confidence"])
    with open(TABLE) as f:
        return {row["number"] for row in csv.DictReader(f)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=20)
    parser.add_argument("--seed", type=int, default=77000)
    parser.add_argument("--only", nargs="*", help="these numbers alone")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--out", default=os.path.join(ROOT, "results", "ablation"))
    args = parser.parse_args()
    studies, tree = list(cases(args)), copied(args.out)
    with open(os.path.join(tree, PRIOR)) as f:
        source = f.read()
    usual = answers(build(tree), studies, os.path.join(args.out, "usual"), args.threads)
    done = tried()
    for name, kind, value in NUMBER.findall(source):
        if name in done or args.only and name not in args.only:
            continue
        other = neutral(name, kind, value)
        with open(os.path.join(tree, PRIOR), "w") as f:
            f.write(source.replace(f"{name}: {kind} = {value},", f"{name}: {kind} = {other},"))
        now = answers(build(tree), studies, os.path.join(args.out, name), args.threads)
        changed = sum(now[s][0] != usual[s][0] for s in usual)
        moved = sum(abs(now[s][1] - usual[s][1]) for s in usual) / len(usual)
        with open(TABLE, "a") as f:
            csv.writer(f, lineterminator="\n").writerow([name, value, other, len(usual), changed, f"{moved:.3f}"])
        print(f"{name}: {value} -> {other}, {changed} of {len(usual)} verdicts change", flush=True)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
