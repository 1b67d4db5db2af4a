#!/usr/bin/env python3
"""Diagnoses a folder of cases with known truths and prints a table of the answers.

    python3 validation/diagnosis/folders.py --engine target/release/hysteron --out results/folders FOLDER ...

A case is a folder with study.toml and truth.json. A case without a truth.json has that of the case whose name is its own up to the last hyphen
(`08-hron-turned` has that of `08-hron`). Cases run one after the other. Those with a result in the output folder are not diagnosed again.
"""

import argparse
import json
import os
import subprocess
import sys
import time

from evaluation.score import right


def truth_of(folder, name):
    while True:
        path = os.path.join(folder, name, "truth.json")
        if os.path.exists(path):
            with open(path) as f:
                return json.load(f)
        if "-" not in name:
            return None
        name = name.rsplit("-", 1)[0]


def cases(folders):
    for folder in folders:
        for name in sorted(os.listdir(folder)):
            truth = truth_of(folder, name)
            if truth and os.path.exists(os.path.join(folder, name, "study.toml")):
                yield folder, name, truth


def diagnosed(args, folder, name):
    """The content of diagnosis.json and the seconds that it took, or what went wrong."""
    out = os.path.join(args.out, os.path.basename(os.path.normpath(folder)), name)
    result, began = os.path.join(out, "diagnosis.json"), time.time()
    if not os.path.exists(result):
        command = [args.engine, "diagnose", os.path.join(folder, name, "study.toml"), "--out", out, "--verbose", "--threads", str(args.threads)]
        done = subprocess.run(command, capture_output=True, text=True)
        os.makedirs(out, exist_ok=True)
        with open(os.path.join(out, "said.txt"), "w") as f:
            f.write(done.stdout + done.stderr)
        with open(os.path.join(out, "seconds.txt"), "w") as f:
            f.write(f"{time.time() - began:.0f}\n")
        if done.returncode:
            return None, f"exit {done.returncode}: {(done.stderr.strip().splitlines() or ['nothing said'])[-1]}"
    with open(result) as f:
        said = json.load(f)
    try:
        with open(os.path.join(out, "seconds.txt")) as f:
            return said, f.read().strip()
    except OSError:
        return said, "?"


def judged(truth, verdict):
    """`right`, `arguable` (what the truth's author accepts), `unknown` of an effect that the library has, or `wrong`."""
    if right(truth, verdict):
        return "right"
    if verdict["cause"] in truth.get("accept_as_arguable", []):
        return "arguable"
    return "unknown" if verdict["cause"] == "unknown" else "wrong"


def number(x):
    return "-" if x is None else f"{x:.2g}"


def line(name, truth, said, seconds):
    verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
    concealed = " + ".join([truth["cause"], *(truth.get("also") or [])])
    answer = " + ".join([verdict["cause"], *verdict.get("also", [])])
    state = judged(truth, verdict)
    sure = "!" if state in ("wrong", "unknown") and verdict["confidence"] >= 0.9 else ""
    return (f"{name:18} {concealed:32} {answer:40} {100 * verdict['confidence']:3.0f} {number(base['holdout_nmse']):>8} {number(after['holdout_nmse']):>8} "
            f"{number(truth.get('noise_floor_nmse_holdout')):>8} {seconds:>5} {state}{sure}"), state, bool(sure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--engine", default="hysteron", help="the program to test")
    parser.add_argument("--out", default=os.path.join("results", "folders"), help="folder of the results")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--only", action="append", metavar="TEXT", help="cases whose name has this text; may be repeated")
    args = parser.parse_args()
    print(f"{'case':18} {'truth':32} {'answer':40} {'%':>3} {'held out':>8} {'repaired':>8} {'noise':>8} {'s':>5}")
    counts, sure_and_wrong, failed = {}, 0, []
    # Of each kind of truth, what was answered rightly, and all; answers with an effect that is not in the truth.
    kinds, surplus = {"none": [0, 0], "unknown": [0, 0], "a cause": [0, 0]}, 0
    for folder, name, truth in cases(args.folders):
        if args.only and not any(text in name for text in args.only):
            continue
        said, seconds = diagnosed(args, folder, name)
        if said is None:
            failed.append(name)
            print(f"{name:18} {seconds}", flush=True)
            continue
        text, state, sure = line(name, truth, said, seconds)
        counts[state] = counts.get(state, 0) + 1
        sure_and_wrong += sure
        of_kind = kinds[truth["cause"] if truth["cause"] in kinds else "a cause"]
        of_kind[0] += state == "right"
        of_kind[1] += 1
        surplus += state == "right" and not set(said["verdict"].get("also", [])) <= {truth["cause"], *(truth.get("also") or [])}
        print(text, flush=True)
    print(", ".join(f"{n} {state}" for state, n in sorted(counts.items())), f"; wrong at 90 % and more: {sure_and_wrong} of {sum(counts.values())}")
    print("; ".join(f"{kind}: {ok} of {n}" for kind, (ok, n) in kinds.items()), f"; right with an effect too many: {surplus}")
    if failed:
        sys.exit("no answer: " + ", ".join(failed))


if __name__ == "__main__":
    main()
