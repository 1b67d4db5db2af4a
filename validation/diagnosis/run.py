#!/usr/bin/env python3
"""Diagnoses the cases of a sealed batch and scores the answers against the truths.

    python3 validation/diagnosis/run.py --engine target/release/hysteron --batch 2
    python3 validation/diagnosis/run.py --engine target/release/hysteron --batch 2 --knock-out
    python3 validation/diagnosis/run.py --batch 2 --verify

The second takes what is concealed in each case out of the library. The third only unpacks the batch and checks its files and seals.

Cases that have a result in the output folder are not diagnosed again, and one that was interrupted is resumed, so that a run goes on where it was
stopped. `--record later` keeps the scores in outcomes.csv; `tables.py` makes the tables of them.
"""

import argparse
import csv
import json
import os
import subprocess
import sys
import time

from evaluation import archive
from evaluation.batch_tables import FIELDS, KNOCKED_OUT, LATER, NO_CAUSE, OPENED, rows_of
from evaluation.score import located, right

HERE = os.path.dirname(os.path.abspath(__file__))
OUTCOMES = os.path.join(HERE, "outcomes.csv")
ROOT = os.path.join(HERE, "..", "..")


def read(*path):
    with open(os.path.join(*path)) as f:
        return json.load(f)


def unpacked(batch, out):
    """The folder with the files of a batch, checked against their digest and their seals."""
    known = {row["batch"]: row for row in rows_of(os.path.join(HERE, "batches.csv"))}
    if batch not in known:
        raise SystemExit(f"no batch {batch}: there are {', '.join(known)}")
    folder = os.path.join(out, f"batch-{batch}")
    found = archive.unpack(os.path.join(HERE, "batches", f"{batch}.tar.xz"), folder)
    if found != known[batch]["files"]:
        raise SystemExit(f"batch {batch}: its files are not those that batches.csv names")
    if archive.sha256(os.path.join(folder, archive.SEALS)) != known[batch]["seal"]:
        raise SystemExit(f"batch {batch}: its list of seals is not the one that batches.csv names")
    broken = archive.broken_seals(folder)
    if broken:
        raise SystemExit(f"batch {batch}: not what was sealed: {', '.join(broken)}")
    return folder


def causes(truth):
    return [truth["cause"], *(truth.get("also") or [])]


def diagnose(args, study, out, without):
    """Runs the engine. What it says goes to said.txt. Returns what went wrong, or nothing."""
    command = [args.engine, "diagnose", study, "--out", out, "--verbose", "--threads", str(args.threads)]
    if os.path.exists(os.path.join(out, "diagnosis-checkpoint.json")):
        command.append("--resume")
    done = subprocess.run(command + (["--without", *without] if without else []), capture_output=True, text=True)
    os.makedirs(out, exist_ok=True)
    with open(os.path.join(out, "said.txt"), "w") as f:
        f.write(done.stdout + done.stderr)
    return f"exit {done.returncode}: {(done.stderr.strip().splitlines() or ['nothing said'])[-1]}" if done.returncode else ""


def scored(batch, state, name, truth, said):
    """The row of outcomes.csv of an answer."""
    verdict, base, after = said["verdict"], said["baseline"], said["corrected"] or said["baseline"]
    row = {"batch": batch, "state": state, "case": name, "concealed": " + ".join(causes(truth)), "answer": " + ".join([verdict["cause"], *verdict.get("also", [])]),
           "confidence": f"{100 * verdict['confidence']:.0f}", "held_out": f"{base['holdout_nmse']:.2g}", "held_out_repaired": f"{after['holdout_nmse']:.2g}"}
    if state != KNOCKED_OUT:
        place, _ = located(truth, said.get("mismatch", []))
        row.update(right="yes" if right(truth, verdict) else "no", place={1: "yes", 0: "no"}.get(place, ""), fitted=f"{base['fit_nmse']:.2g}",
                   fitted_repaired=f"{after['fit_nmse']:.2g}", noise=f"{truth['noise_floor_nmse_holdout']:.2g}")
    return row


def record(rows):
    """Puts rows into outcomes.csv in place of those of the same case and state."""
    def key(r):
        return r["batch"], r["state"], r["case"]

    old = rows_of(OUTCOMES)
    new = {key(r): r for r in rows}
    kept = [new.pop(key(r), r) for r in old] + list(new.values())
    states = (OPENED, LATER, KNOCKED_OUT)
    kept.sort(key=lambda r: (int(r["batch"]), states.index(r["state"]), r["case"]))
    write(OUTCOMES, kept)


def write(path, rows):
    with open(path, "w", newline="") as f:
        out = csv.DictWriter(f, FIELDS, lineterminator="\n", restval="")
        out.writeheader()
        out.writerows(rows)


def cases(args, folder):
    """(name, truth, causes to leave out) of the cases to diagnose."""
    names = sorted(os.listdir(os.path.join(folder, "cases")))
    unknown = set(args.case or []) - set(names)
    if unknown:
        raise SystemExit(f"no case {', '.join(sorted(unknown))}: there are {', '.join(names)}")
    for name in args.case or names:
        truth = read(folder, "truth", name + ".json")
        if not args.knock_out:
            yield name, truth, []
        elif truth["cause"] not in NO_CAUSE:
            yield name, truth, causes(truth)


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", default="hysteron", help="the program to test")
    parser.add_argument("--batch", required=True, help="number of the batch")
    parser.add_argument("--case", action="append", metavar="NAME", help="this case alone; may be repeated")
    parser.add_argument("--knock-out", action="store_true", help="leave what is concealed out of the library")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--out", default=os.path.join(ROOT, "results", "diagnosis"), help="folder of cases and results (results/diagnosis)")
    parser.add_argument("--verify", action="store_true", help="unpack and check the batch, diagnose nothing")
    parser.add_argument("--record", choices=(OPENED, LATER), help="keep the scores in outcomes.csv under this state")
    return parser.parse_args()


def main():
    args = options()
    folder = unpacked(args.batch, args.out)
    if args.verify:
        print(f"{folder}: files and seals are those of batches.csv")
        return
    state = KNOCKED_OUT if args.knock_out else args.record or LATER
    todo, rows, failed, started, ran = list(cases(args, folder)), [], [], time.time(), 0
    for i, (name, truth, without) in enumerate(todo, 1):
        out = os.path.join(folder, "knocked_out" if args.knock_out else "results", name)
        result, began = os.path.join(out, "diagnosis.json"), time.time()
        if not os.path.exists(result):
            ran += 1
            problem = diagnose(args, os.path.join(folder, "cases", name, "study.toml"), out, without)
            if problem:
                failed.append(name)
                print(f"{i}/{len(todo)} {name}: {problem}", flush=True)
                continue
        row = scored(args.batch, state, name, truth, read(result))
        rows.append(row)
        passed = time.time() - started
        left = passed / ran * (len(todo) - i) if ran else 0.0
        print(f"{i}/{len(todo)} {name}: {row['concealed']} -> {row['answer']} {row['confidence']} % {row.get('right', '')}, {time.time() - began:.0f} s; "
              f"{passed / 60:.0f} min so far, about {left / 60:.0f} min left", flush=True)
    write(os.path.join(folder, f"{state.replace(' ', '_')}.csv"), rows)
    if args.record:
        record(rows)
    if not args.knock_out:
        print(f"{sum(r['right'] == 'yes' for r in rows)} of {len(rows)} right")
    if failed:
        sys.exit("no answer: " + ", ".join(failed))


if __name__ == "__main__":
    main()
