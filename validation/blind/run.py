#!/usr/bin/env python3
"""Diagnoses the studies of `cases/` and, once the truths are there, checks their seals and writes outcome.md.

    python3 run.py --engine ../../target/release/hysteron
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


def diagnose(args, name):
    out = os.path.join(args.out, name)
    started = time.time()
    done = subprocess.run([args.engine, "diagnose", os.path.join(HERE, "cases", name, "study.toml"), "--out", out, "--verbose", "--threads", str(args.threads)],
                          capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{name}: {done.stderr}")
    with open(os.path.join(out, "said.txt"), "w") as f:
        f.write(done.stdout)
    print(f"{name}: {done.stdout.splitlines()[0]} ({time.time() - started:.0f} s)", flush=True)


def seals():
    """Files whose content is not what was sealed before the run."""
    broken = []
    with open(os.path.join(HERE, "sealed.sha256")) as f:
        for line in f:
            digest, path = line.split()
            with open(os.path.join(HERE, path), "rb") as g:
                if hashlib.sha256(g.read()).hexdigest() != digest:
                    broken.append(path)
    return broken


def table(args, names):
    rows = ["# Concealed by OpenSees: outcome", "", "Written by `run.py`.", "",
            "| case | concealed | answer | confidence | right | place | fitted NMSE | held out NMSE | noise |", "| --- | --- | --- | --- | --- | --- | --- | --- | --- |"]
    hits = 0
    for name in names:
        with open(os.path.join(HERE, "truth", name + ".json")) as f:
            truth = json.load(f)
        with open(os.path.join(args.out, name, "diagnosis.json")) as f:
            said = json.load(f)
        verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
        ok = right(truth, verdict)
        hits += ok
        place, _ = located(truth, said.get("mismatch", []))
        cells = [name, " + ".join([truth["cause"], *truth["also"]]), " + ".join([verdict["cause"], *verdict.get("also", [])]), f"{100 * verdict['confidence']:.0f} %",
                 "yes" if ok else "no", {1: "yes", 0: "no"}.get(place, ""), f"{base['fit_nmse']:.2g} → {after['fit_nmse']:.2g}",
                 f"{base['holdout_nmse']:.2g} → {after['holdout_nmse']:.2g}", f"{truth['noise_floor_nmse_holdout']:.2g}"]
        rows.append("| " + " | ".join(cells) + " |")
    rows += ["", f"{hits} of {len(names)} right."]
    with open(os.path.join(HERE, "outcome.md"), "w") as f:
        f.write("\n".join(rows) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", default="hysteron")
    parser.add_argument("--out", default=os.path.join(HERE, "results"))
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--only", nargs="*", help="names of cases")
    args = parser.parse_args()
    names = sorted(os.listdir(os.path.join(HERE, "cases")))
    for name in args.only or names:
        diagnose(args, name)
    if os.path.isdir(os.path.join(HERE, "truth")):
        broken = seals()
        if broken:
            raise SystemExit("not what was sealed: " + ", ".join(broken))
        if all(os.path.exists(os.path.join(args.out, name, "diagnosis.json")) for name in names):
            table(args, names)


if __name__ == "__main__":
    main()
