#!/usr/bin/env python3
"""Diagnoses the studies of `cases/` and, once the truths are there, checks their seals and writes outcome.md.

    python3 run.py --engine ../../target/release/hysteron
    python3 run.py --engine ../../target/release/hysteron --knock-out     # then: each without what was concealed in it
    python3 run.py --engine ../../target/release/hysteron --folder ../structures
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "power"))

from score import located, right  # noqa: E402


def diagnose(args, name, without=()):
    out = os.path.join(args.out, name + ("-without" if without else ""))
    started = time.time()
    done = subprocess.run([args.engine, "diagnose", os.path.join(args.folder, "cases", name, "study.toml"), "--out", out, "--verbose", "--threads", str(args.threads),
                           *(["--without", *without] if without else [])],
                          capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{name}: {done.stderr}")
    with open(os.path.join(out, "said.txt"), "w") as f:
        f.write(done.stdout)
    print(f"{name}: {done.stdout.splitlines()[0]} ({time.time() - started:.0f} s)", flush=True)


def seals(folder):
    """Files whose content is not what was sealed before the run."""
    broken = []
    with open(os.path.join(folder, "sealed.sha256")) as f:
        for line in f:
            digest, path = line.split()
            with open(os.path.join(folder, path), "rb") as g:
                if hashlib.sha256(g.read()).hexdigest() != digest:
                    broken.append(path)
    return broken


def table(args, names):
    rows = ["# Concealed by OpenSees: outcome", "", "Written by `run.py`.", "",
            "| case | concealed | answer | confidence | right | place | fitted NMSE | held out NMSE | noise |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    hits = 0
    for name in names:
        with open(os.path.join(args.folder, "truth", name + ".json")) as f:
            truth = json.load(f)
        with open(os.path.join(args.out, name, "diagnosis.json")) as f:
            said = json.load(f)
        verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
        ok = right(truth, verdict)
        hits += ok
        place, _ = located(truth, said.get("mismatch", []))
        cells = [name, " + ".join([truth["cause"], *(truth.get("also") or [])]), " + ".join([verdict["cause"], *verdict.get("also", [])]), f"{100 * verdict['confidence']:.0f} %",
                 "yes" if ok else "no", {1: "yes", 0: "no"}.get(place, ""), f"{base['fit_nmse']:.2g} → {after['fit_nmse']:.2g}",
                 f"{base['holdout_nmse']:.2g} → {after['holdout_nmse']:.2g}", f"{truth['noise_floor_nmse_holdout']:.2g}"]
        rows.append("| " + " | ".join(cells) + " |")
    rows += ["", f"{hits} of {len(names)} right."]
    with open(os.path.join(args.folder, "outcome.md"), "w") as f:
        f.write("\n".join(rows) + "\n")


def read(*path):
    with open(os.path.join(*path)) as f:
        return json.load(f)


def knock_out(args, names):
    """Each case with the causes that were concealed taken out of the library: knocked_out.md."""
    rows = ["# Concealed by OpenSees: the cause taken out of the library", "", "Written by `run.py --knock-out`.", "",
            "*Whole* is the held out NMSE of the repair by the whole library. An answer is an *equivalent* where the repaired model predicts the runs held out nearly as well (at most twice that),",
            "*hesitant* where its confidence is below 80 %; what is left is *confident and wrong*.", "",
            "| case | left out | answer | confidence | held out NMSE | whole | it is |", "| --- | --- | --- | --- | --- | --- | --- |"]
    counts = {}
    for name in names:
        truth, whole = read(args.folder, "truth", name + ".json"), read(args.out, name, "diagnosis.json")
        if truth["cause"] in ("none", "unknown"):
            continue
        without = [truth["cause"], *(truth.get("also") or [])]
        diagnose(args, name, without)
        said = read(args.out, name + "-without", "diagnosis.json")
        verdict, held = said["verdict"], [d["corrected"]["holdout_nmse"] for d in (said, whole)]
        if verdict["cause"] in ("unknown", "none"):
            kind = verdict["cause"]
        elif held[0] <= 2 * held[1]:
            kind = "an equivalent"
        else:
            kind = "hesitant" if verdict["confidence"] < 0.8 else "confident and wrong"
        counts[kind] = counts.get(kind, 0) + 1
        rows.append("| " + " | ".join([name, " + ".join(without), " + ".join([verdict["cause"], *verdict.get("also", [])]), f"{100 * verdict['confidence']:.0f} %",
                                       f"{said['baseline']['holdout_nmse']:.2g} → {held[0]:.2g}", f"{held[1]:.2g}", kind]) + " |")
    rows += ["", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())) + "."]
    with open(os.path.join(args.folder, "knocked_out.md"), "w") as f:
        f.write("\n".join(rows) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", default="hysteron")
    parser.add_argument("--folder", default=HERE, help="where cases and truths are")
    parser.add_argument("--out", help="FOLDER/results")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--only", nargs="*", help="names of cases")
    parser.add_argument("--knock-out", action="store_true", help="without the causes that were concealed, after a run with them")
    args = parser.parse_args()
    args.out = args.out or os.path.join(args.folder, "results")
    names = sorted(os.listdir(os.path.join(args.folder, "cases")))
    if args.knock_out:
        knock_out(args, names)
        return
    for name in args.only or names:
        diagnose(args, name)
    if os.path.isdir(os.path.join(args.folder, "truth")):
        broken = seals(args.folder)
        if broken:
            raise SystemExit("not what was sealed: " + ", ".join(broken))
        if all(os.path.exists(os.path.join(args.out, name, "diagnosis.json")) for name in names):
            table(args, names)


if __name__ == "__main__":
    main()
