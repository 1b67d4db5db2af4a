#!/usr/bin/env python3
"""Makes, diagnoses and scores seeded trials: see README.md.

    python3 validation/diagnosis/trials.py run --engine target/release/hysteron --trials 500 --seed 75000    # goes on where trials.csv ends
    python3 validation/diagnosis/trials.py make --seed 1234 --out DIR                                        # the study of one seed, and its truth
"""

import argparse
import contextlib
import csv
import multiprocessing
import os
import shlex

from evaluation import checks, score
from generator.plan import draw, plan

HERE = os.path.dirname(os.path.abspath(__file__))
TABLE = os.path.join(HERE, "trials.csv")


def make(args):
    case = draw(args.seed, args.ratio, args.cause, args.imperfect)
    truth = case.write(args.out)
    print(f"{args.out}: {truth['cause']} {truth['also']} {truth['kinds']} in a {truth['family']}, effect over noise {truth['effect_over_noise']}")


def check(args):
    command = shlex.split(args.command)
    for seed in range(args.seed, args.seed + args.trials):
        case = draw(seed, args.ratio, args.cause)
        m = case.model
        try:
            error = f"{checks.effect_off(case, command):.2e}"
        except (RuntimeError, OSError) as e:
            error = f"failed: {e}"
        print(seed, case.truth, case.effects, m.family, getattr(m, "kind", ""), [f"{a / case.level:.2g}" for a in case.achieved],
              [f"{s:.2g}" for s in case.strengths], f"noise {case.level:.2g}", error, flush=True)


def one(job):
    seed, args = job
    options = ["--threads", "1"] + (["--verbose"] if args.keep else []) + shlex.split(args.options)
    try:
        return score.trial(seed, args.engine, options, args.limit, args.keep, args.ratio, args.cause, args.knock_out, args.imperfect)
    except Exception as e:  # a case that cannot be made is a row too, not the end of the run
        return dict.fromkeys(score.FIELDS, "") | {"seed": seed, "status": f"case: {e!r}"[:120]}


@contextlib.contextmanager
def workers(jobs):
    """A map over that many processes, in whatever order they end; in this one if it is alone, so that nothing outlives it."""
    if jobs == 1:
        yield map
        return
    with multiprocessing.Pool(jobs, maxtasksperchild=20) as pool:
        yield pool.imap_unordered


def run(args):
    done = set()
    if os.path.exists(args.csv):
        with open(args.csv) as f:
            done = {int(row["seed"]) for row in csv.DictReader(f)}
    else:
        with open(args.csv, "w") as f:
            csv.writer(f, lineterminator="\n").writerow(score.FIELDS)
    jobs = [(seed, args) for seed in range(args.seed, args.seed + args.trials) if seed not in done]
    if args.knock_out:
        jobs = [job for job in jobs if plan(job[0])[1][0] not in ("none", "unknown")]
    with workers(args.jobs) as spread:
        for n, row in enumerate(spread(one, jobs), 1):
            with open(args.csv, "a") as f:
                csv.DictWriter(f, score.FIELDS, lineterminator="\n").writerow(row)
            print(f"{n}/{len(jobs)} {row['seed']}: {row['kinds'] or row['cause']} ({row['effect_over_noise']}) -> "
                  f"{row['verdict']} {row['verdict_also']} {row['confidence']} {row['status']} {row['cpu_s']} s", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    p = commands.add_parser("make", help="write the study of a seed")
    p.add_argument("--seed", type=int, required=True)
    p.add_argument("--out", required=True)
    p.set_defaults(call=make)
    q = commands.add_parser("check", help="run the analyst's scripts with nothing concealed and compare with the generator")
    q.add_argument("--seed", type=int, default=1)
    q.add_argument("--trials", type=int, default=20)
    q.add_argument("--command", default="hysteron run --compat opensees", help="what runs a Tcl script")
    q.set_defaults(call=check)
    r = commands.add_parser("run", help="make, diagnose and score cases; goes on where a CSV ends")
    r.add_argument("--trials", type=int, default=500)
    r.add_argument("--seed", type=int, default=1000, help="of the first trial; the others follow")
    r.add_argument("--jobs", type=int, default=os.cpu_count())
    r.add_argument("--engine", default="hysteron")
    r.add_argument("--options", default="", help="more options of `hysteron diagnose`, as '--without friction'")
    r.add_argument("--knock-out", action="store_true", help="leave the truth of each case out of the library; cases without a listed one are left out")
    r.add_argument("--csv", default=TABLE)
    r.add_argument("--keep", help="a folder in which studies and what was said stay")
    r.add_argument("--limit", type=float, default=1800.0, help="seconds a case may take")
    r.set_defaults(call=run)
    for sub in (p, q, r):
        sub.add_argument("--cause", help="instead of the cause of the seed's plan")
        sub.add_argument("--imperfect", action="store_true", help="the model has other small errors too; the table needs a file of its own")
        sub.add_argument("--ratio", type=float, help="effect over noise, instead of the plan's")
    args = parser.parse_args()
    if args.imperfect and getattr(args, "csv", None) == TABLE:
        parser.error("--imperfect: give the table of these trials by --csv")
    args.call(args)


if __name__ == "__main__":
    main()
