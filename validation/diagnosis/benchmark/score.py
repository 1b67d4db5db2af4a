#!/usr/bin/env python3
"""Scores answers to the cases of the sealed batches, and those of simple rules beside them.

    python3 validation/diagnosis/run.py --engine target/release/hysteron --batch 7      # unpacks and diagnoses a batch
    python3 validation/diagnosis/benchmark/score.py [--results results/diagnosis] [--answers NAME] [--markdown FILE]

`--answers` names the folder beside `cases` that holds the answers of a contestant, `results` by default.
"""

import argparse
import glob
import json
import os
import random
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from benchmark import baselines, metrics  # noqa: E402

try:  # the methods on residuals alone need numpy
    from benchmark import latent_force, residual, sparse_regression

    RESIDUAL_METHODS = {"sparse regression of the residual": sparse_regression.method, "latent force (Gaussian process)": latent_force.method}
except ImportError:
    RESIDUAL_METHODS = {}
from evaluation.rates import wilson  # noqa: E402


def read(path):
    with open(path) as f:
        return json.load(f)


def answered(results, answers):
    """(folder of the case, truth, answer, folder of the answer) of every case with an answer."""
    for path in sorted(glob.glob(os.path.join(results, "batch-*", answers, "*", "diagnosis.json"))):
        batch, name = os.path.dirname(os.path.dirname(os.path.dirname(path))), os.path.basename(os.path.dirname(path))
        yield os.path.join(batch, "cases", name), read(os.path.join(batch, "truth", name + ".json")), read(path), os.path.dirname(path)


def share(values):
    """`12 of 15 (80 %, 55 to 93)` of true values; empty for none."""
    known = [v for v in values if v is not None]
    if not known:
        return ""
    low, high = wilson(sum(known), len(known))
    return f"{sum(known)} of {len(known)} ({100 * sum(known) / len(known):.0f} %, {100 * low:.0f} to {100 * high:.0f})"


def margin(first, other):
    """`+0.12 (0.03 to 0.21)`: how much more often the first contestant is right than the other, with a 95 % interval of paired resampling."""
    draw = random.Random(1)
    differences = [a - b for a, b in zip(first, other)]
    means = sorted(sum(draw.choices(differences, k=len(differences))) / len(differences) for _ in range(4000))
    return f"{sum(differences) / len(differences):+.2f} ({means[100]:+.2f} to {means[-101]:+.2f})"


def row(name, scored, first=None):
    """Cells of a contestant. `scored`: (truth, answer), `first`: those of the one whose margin is counted."""
    listed = [(t, a) for t, a in scored if t["cause"] not in metrics.NO_CAUSE]
    pairs = [(t, a) for t, a in listed if len(metrics.causes(t)) > 1]
    right = [(a["verdict"]["confidence"], metrics.any_right(t, a)) for t, a in scored]
    sure = [not r for p, r in right if p >= 0.9]
    curve = metrics.risk_coverage(right)
    half = [risk for coverage, risk in curve if coverage <= 0.5]
    gaps = [g for g in (metrics.gap_closed(t, a) for t, a in listed if a.get("corrected")) if g is not None]
    errors = [e for t, a in listed if a.get("corrected") for e in metrics.parameter_errors(t, a)]
    return {
        "answers": name,
        "cases": len(scored),
        "right": share([r for _, r in right]),
        "margin of the first": margin([metrics.any_right(t, a) for t, a in first], [r for _, r in right]) if first else "",
        "any effect": share([metrics.any_right(t, a) for t, a in listed]),
        "all effects": share([metrics.all_right(t, a) for t, a in listed]),
        "both of a pair": share([metrics.all_right(t, a) for t, a in pairs]),
        "nulls": share([metrics.any_right(t, a) for t, a in scored if t["cause"] == "none"]),
        "unknown": share([metrics.any_right(t, a) for t, a in scored if t["cause"] == "unknown"]),
        "wrong at 90 % and more": share(sure),
        "wrong in the surer half": f"{100 * half[-1]:.0f} %" if half else "",
        "Brier": f"{sum(metrics.brier(t, a) for t, a in scored) / len(scored):.3f}",
        "run and channel": share([metrics.place_right(t, a) for t, a in scored if t["cause"] != "none"]),
        "element or node": share([metrics.element_right(t, a) for t, a in listed]),
        "gap closed, median": f"{metrics.median(gaps):.2f}" if gaps else "",
        "user's parameters, median error before and after": f"{metrics.median([e[1] for e in errors]):.3f}, {metrics.median([e[2] for e in errors]):.3f}" if errors else "",
    }


def table(rows):
    """Contestants as columns."""
    keys = [k for k in rows[0] if any(r[k] != "" for r in rows)]
    lines = ["| " + " | ".join(str(r[keys[0]]) for r in [{keys[0]: ""}, *rows]) + " |", "|" + " --- |" * (len(rows) + 1)]
    lines += ["| " + " | ".join([key, *(str(r[key]) for r in rows)]) + " |" for key in keys[1:]]
    return "\n".join(lines) + "\n"


def matching(first, some):
    """Answers of the first contestant to the cases of another."""
    truths = [id(case[1]) for case in some]
    return [(t, a) for t, a in first if id(t) in truths]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", default=os.path.join("results", "diagnosis"), help="folder that run.py fills")
    parser.add_argument("--answers", default="results", help="folder of a contestant's answers beside `cases`")
    parser.add_argument("--markdown", help="a file for the table")
    args = parser.parse_args()
    cases = list(answered(args.results, args.answers))
    if not cases:
        sys.exit(f"no answers in {args.results}/batch-*/{args.answers}")
    first = [(t, a) for _, t, a, _ in cases]
    rows = [row(args.answers, first)]
    with_evidence = [(f, t, a) for f, t, a, _ in cases if a.get("evidence")]
    if with_evidence:
        rows += [row(rule, [(t, baselines.answer(rule, a, f)) for f, t, a in with_evidence], matching(first, with_evidence)) for rule in baselines.RULES]
    with_channels = [(f, t, to) for f, t, _, to in cases if os.path.isdir(os.path.join(to, "channels"))]
    if with_channels:
        for name, method in RESIDUAL_METHODS.items():
            rows.append(row(name, [(t, residual.answers(f, to, method)) for f, t, to in with_channels], matching(first, with_channels)))
    text = table(rows)
    print(text, end="")
    if args.markdown:
        with open(args.markdown, "w") as f:
            f.write(text)


if __name__ == "__main__":
    main()
