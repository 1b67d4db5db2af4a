#!/usr/bin/env python3
"""Checks the cases of an author outside, and seals them.

    python3 validation/diagnosis/benchmark/submission.py FOLDER [--engine HYSTERON]

FOLDER has the form that README.md here describes. What does not hold is printed, with exit status 1. Else the digests of all files go to
FOLDER/sealed.sha256, whose own digest is printed: the author publishes it before any case is diagnosed.
With an engine each study is checked by `hysteron check` as well.
"""

import argparse
import json
import os
import subprocess
import sys
import tomllib

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from benchmark.metrics import NO_CAUSE, causes  # noqa: E402
from evaluation import archive  # noqa: E402
from evaluation.batch_tables import markdown_rows  # noqa: E402

CAUSES = os.path.join(HERE, "..", "..", "..", "docs", "reference", "causes.md")
AUTHOR = ("name", "knew", "concealed_by", "licence")
TRUTH = ("cause", "sources", "noise_floor_nmse_fit", "noise_floor_nmse_holdout", "self_check_effect_off_nmse")
# With the effect off the script must give the response of the author's own integrator.
MAX_EFFECT_OFF = 1e-3


def known_causes():
    return {row["cause"].strip("`") for row in markdown_rows(CAUSES, "cause")}


def of_study(folder):
    """What is wrong with the study of a case, and its runs with the names of their channels."""
    try:
        with open(os.path.join(folder, "study.toml"), "rb") as f:
            study = tomllib.load(f)
    except (OSError, tomllib.TOMLDecodeError) as e:
        return [f"study.toml: {e}"], {}
    runs = {r.get("name", ""): [o.get("channel", "") for o in r.get("observe", [])] for r in study.get("run", [])}
    wanted = [study.get("model", "")] + [r.get("recording", "") for r in study.get("run", [])]
    faults = [f"study.toml names {name or 'no file'}, which is not there" for name in wanted if not os.path.isfile(os.path.join(folder, name))]
    roles = {r.get("role") for r in study.get("run", [])}
    faults += [f"no run has the role {role}" for role in ("fit", "holdout") if role not in roles]
    return faults, runs


def of_truth(truth, runs, known):
    """What is wrong with a truth, given the runs of its study."""
    faults = [f"the truth has no {key}" for key in TRUTH if key not in truth]
    faults += [f"{c} is no cause: one of docs/reference/causes.md, none or unknown" for c in causes(truth) if c not in known and c not in NO_CAUSE] if "cause" in truth else []
    where = truth.get("where") or {}
    if truth.get("cause") not in NO_CAUSE and where.get("run") not in runs:
        faults.append(f"where.run is {where.get('run')}, which is no run of the study")
    elif where.get("run") in runs and where.get("channel") not in runs[where["run"]]:
        faults.append(f"where.channel is {where.get('channel')}, which that run does not observe")
    off = truth.get("self_check_effect_off_nmse")
    if isinstance(off, (int, float)) and off > MAX_EFFECT_OFF:
        faults.append(f"with the effect off the script is {off:g} away from the author's response, more than {MAX_EFFECT_OFF:g}")
    return faults


def betrayed(folder, truth):
    """Files of a case that hold the name of what they conceal. Names of one word, as damping, are words of any script."""
    for name in sorted(os.listdir(folder)):
        if name.endswith((".toml", ".tcl", ".py")):
            with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as f:
                text = f.read().lower()
            for cause in causes(truth):
                if "_" in cause and cause in text:
                    yield f"{name} holds the word {cause}"


def of_case(root, name, known, engine):
    """What is wrong with a case."""
    folder, path = os.path.join(root, "cases", name), os.path.join(root, "truth", name + ".json")
    faults, runs = of_study(folder)
    try:
        with open(path) as f:
            truth = json.load(f)
    except (OSError, json.JSONDecodeError) as e:
        return [*faults, f"truth/{name}.json: {e}"]
    faults += of_truth(truth, runs, known)
    if "cause" in truth:
        faults += betrayed(folder, truth)
    if engine and not faults:
        done = subprocess.run([engine, "check", os.path.join(folder, "study.toml")], capture_output=True, text=True)
        if done.returncode:
            faults.append((done.stderr.strip().splitlines() or ["hysteron check refuses it"])[0])
    return faults


def of_author(root):
    try:
        with open(os.path.join(root, "author.toml"), "rb") as f:
            author = tomllib.load(f)
    except (OSError, tomllib.TOMLDecodeError) as e:
        return [f"author.toml: {e}"]
    return [f"author.toml has no {key}" for key in AUTHOR if not author.get(key)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--engine", help="hysteron, which then checks each study")
    args = parser.parse_args()
    cases = os.path.join(args.folder, "cases")
    names = sorted(os.listdir(cases)) if os.path.isdir(cases) else []
    faults = [("", fault) for fault in of_author(args.folder)] + ([] if names else [("", "there are no cases")])
    known = known_causes()
    faults += [(name, fault) for name in names for fault in of_case(args.folder, name, known, args.engine)]
    for name, fault in faults:
        print(f"{name or args.folder}: {fault}")
    if faults:
        sys.exit(1)
    sealed = [p for p in archive.files_below(args.folder) if p != archive.SEALS]
    with open(os.path.join(args.folder, archive.SEALS), "w") as f:
        f.writelines(f"{archive.sha256(os.path.join(args.folder, p))}  {p}\n" for p in sealed)
    print(f"{len(names)} cases, sealed: {archive.sha256(os.path.join(args.folder, archive.SEALS))}")


if __name__ == "__main__":
    main()
