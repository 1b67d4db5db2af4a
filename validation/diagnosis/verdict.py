#!/usr/bin/env python3
"""Fits the weights of the verdict to diagnosed cases, and shows what they are worth on authors that the fit has not seen.

    python3 validation/diagnosis/verdict.py collect --batches results/diagnosis --trials DIR --csv DIR/trials.csv
    python3 validation/diagnosis/verdict.py fit        # weights, predictions, verdict.md and verdict.svg
    python3 validation/diagnosis/verdict.py tables     # verdict.md and verdict.svg only

`collect` keeps the evidence of every diagnosed case in evidence.jsonl.xz, in place of older evidence of the same case. DIR is the folder that
`trials.py run --keep DIR --csv DIR/trials.csv` has filled. With `--left-out` the cases are those whose concealed cause was taken out of the library.
"""

import argparse
import csv
import glob
import json
import lzma
import math
import os
import subprocess
import sys
import tempfile

from benchmark import metrics
from evaluation.rates import wilson
from evaluation.svg import MARK, Picture, axes, bars

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
EVIDENCE = os.path.join(HERE, "evidence.jsonl.xz")
PREDICTIONS, FEATURES = os.path.join(HERE, "verdict_predictions.csv"), os.path.join(HERE, "verdict_features.csv")
WEIGHTS = os.path.join(ROOT, "crates", "diagnose", "src", "evidence", "verdict_weights.rs")
DIGITS = 5
MAX_SELF_CHECK = 1e-3
# Cases whose cause was taken out of the library count less: one effect in four or five is taken to be none of the library.
LEFT_OUT_WEIGHT = 0.33


def read(path):
    with open(path) as f:
        return json.load(f)


def rounded(x):
    """Numbers with few digits, which compress well."""
    if isinstance(x, float):
        return float(f"{x:.{DIGITS}g}")
    if isinstance(x, dict):
        return {k: rounded(v) for k, v in x.items()}
    return [rounded(v) for v in x] if isinstance(x, list) else x


def line(case, group, truth, said, left_out):
    verdict = said["verdict"]
    right = ["unknown"] if left_out else metrics.causes(truth)
    return {"case": case, "group": group, "weight": LEFT_OUT_WEIGHT if left_out else 1.0, "right": right, "answer": [verdict["cause"], *verdict["also"]], "confidence": verdict["confidence"],
            "evidence": rounded(said["evidence"])}


def of_batches(folder, left_out):
    for path in glob.glob(os.path.join(folder, "batch-*", "knocked_out" if left_out else "results", "*", "diagnosis.json")):
        batch, name = path.split(os.sep)[-4], path.split(os.sep)[-2]
        truth = read(os.path.join(folder, batch, "truth", name + ".json"))
        yield line(f"{batch}/{name}{' left out' if left_out else ''}", batch, truth, read(path), left_out)


def of_trials(folder, table, left_out, imperfect):
    with open(table) as f:
        rows = [r for r in csv.DictReader(f) if r["status"] == "done" and float(r["self_check"] or 0.0) <= MAX_SELF_CHECK]
    for r in rows:
        path = os.path.join(folder, r["seed"], "out", "diagnosis.json")
        if os.path.exists(path):
            truth = {"cause": r["cause"], "also": r["also"].split()}
            # All left out are of one author, so that every third seed is a group.
            group = f"left out {int(r['seed']) % 3 + 1}" if left_out else f"{'imperfect' if imperfect else 'trials'} {r['family']}"
            yield line(f"{'imperfect ' if imperfect else ''}trial {r['seed']}{' left out' if left_out else ''}", group, truth, read(path), left_out)


def known():
    if not os.path.exists(EVIDENCE):
        return {}
    with lzma.open(EVIDENCE, "rt") as f:
        return {one["case"]: one for one in map(json.loads, f)}


def collect(args):
    cases = known()
    found = list(of_batches(args.batches, args.left_out)) if args.batches else []
    if args.trials:
        found += of_trials(args.trials, args.csv or os.path.join(args.trials, "trials.csv"), args.left_out, args.imperfect)
    cases.update((one["case"], one) for one in found)
    with lzma.open(EVIDENCE, "wt", preset=9 | lzma.PRESET_EXTREME) as f:
        for name in sorted(cases):
            f.write(json.dumps(cases[name], separators=(",", ":")) + "\n")
    print(f"{len(found)} cases read, {len(cases)} kept")


def fit(args):
    with tempfile.TemporaryDirectory() as scratch:
        plain = os.path.join(scratch, "cases.jsonl")
        with lzma.open(EVIDENCE, "rt") as source, open(plain, "w") as f:
            f.write(source.read())
        command = ["cargo", "run", "--quiet", "--release", "--package", "hysteron-diagnose", "--example", "fit_verdict", "--"]
        subprocess.run(command + [plain, PREDICTIONS, FEATURES, WEIGHTS], cwd=ROOT, check=True)
    tables(args)


def predictions():
    with open(PREDICTIONS) as f:
        return list(csv.DictReader(f))


BINS = ((0.0, 0.5), (0.5, 0.7), (0.7, 0.8), (0.8, 0.9), (0.9, 0.95), (0.95, 1.01))


def share(k, n):
    low, high = wilson(k, n)
    return f"{100 * k / n:.0f} % ({100 * low:.0f} to {100 * high:.0f})" if n else ""


def reliability(scored):
    lines = ["| probability | answers | mean | right |", "| --- | --- | --- | --- |"]
    for low, high in BINS:
        inside = [(p, r) for p, r in scored if low <= p < high]
        mean = f"{100 * sum(p for p, _ in inside) / len(inside):.0f} %" if inside else ""
        lines.append(f"| {100 * low:.0f} to {100 * min(high, 1.0):.0f} % | {len(inside)} | {mean} | {share(sum(r for _, r in inside), len(inside))} |")
    return "\n".join(lines)


def groups(rows, cases):
    lines = ["| group | cases | right | right before | wrong at 90 % and more | log score |", "| --- | --- | --- | --- | --- | --- |"]
    for group in [*sorted({r["group"] for r in rows}), "all but those left out"]:
        inside = [r for r in rows if group == r["group"] or group.startswith("all") and not r["group"].startswith("left out")]
        sure = [r for r in inside if float(r["probability"]) >= 0.9]
        score = sum(math.log(max(float(r["probability_of_right"]), 1e-4)) for r in inside) / len(inside)
        before = sum(right_before(cases[r["case"]]) for r in inside)
        lines.append(f"| {group} | {len(inside)} | {sum(r['right'] == '1' for r in inside)} | {before} | {sum(r['right'] == '0' for r in sure)} of {len(sure)} | {score:.2f} |")
    return "\n".join(lines)


def right_before(one):
    truth = {"cause": one["right"][0], "also": one["right"][1:]}
    return metrics.any_right(truth, {"verdict": {"cause": one["answer"][0], "also": one["answer"][1:]}})


def tables(_):
    rows, cases = predictions(), known()
    authored = [r for r in rows if not r["group"].startswith("left out")]
    scored = [(float(r["probability"]), r["right"] == "1") for r in authored]
    left_out = [r for r in rows if r["group"].startswith("left out")]
    sure = sum(r["answer"] not in metrics.NO_CAUSE and float(r["probability"]) >= 0.9 for r in left_out)
    unsure = sum(r["answer"] in metrics.NO_CAUSE or float(r["probability"]) < 0.8 for r in left_out)
    brier = sum((p - r) ** 2 for p, r in scored) / len(scored)
    curve = metrics.risk_coverage(scored)
    at = {share_: min(curve, key=lambda c: abs(c[0] - share_))[1] for share_ in (0.25, 0.5, 0.75, 1.0)}
    with open(FEATURES) as f:
        features = list(csv.DictReader(f))
    text = f"""# The verdict's probabilities on authors that the fit has not seen

Written by `verdict.py tables`. Each group is predicted by weights that were fitted to all other groups. *Right* is the first cause alone. *Right before* is what the build that
made the evidence answered, with either effect of a pair. In the groups *left out* the concealed cause was taken out of the library, so that only `unknown` is right.

## By group

{groups(rows, cases)}

## Reliability

![Reliability, and wrong answers among the surest](verdict.svg)

{reliability(scored)}

Brier score of *the first cause is right*: {brier:.3f}. Wrong among the surest quarter, half, three quarters and all: {", ".join(f"{100 * v:.0f} %" for v in at.values())}.

With the concealed cause taken out of the library ({len(left_out)} cases, not in the table above): no name, or a name below 80 %, in {unsure}; a name at 90 % and more in {sure}. Most of these names are laws that do nearly the same, such as heating in
place of degradation.

## Features

*Lost* is the mean log score that is lost without a feature, on unseen groups. *Changed* counts the answers that change.

| feature | weight | lost | changed |
| --- | --- | --- | --- |
""" + "\n".join(f"| `{r['feature']}` | {float(r['weight']):.2f} | {float(r['score_lost_without']):.4f} | {r['answers_changed_without']} |" for r in features) + "\n"
    for name, content in (("verdict.md", text), ("verdict.svg", charts(scored, curve))):
        with open(os.path.join(HERE, name), "w") as f:
            f.write(content)


def charts(scored, curve):
    """Reliability, and the share of wrong answers among the surest."""
    p, x, y, w, h = Picture(640, 250), 50, 30, 240, 170
    axes(p, x, y, w, h, "right answers by probability, %", [(v, f"{100 * v:.0f}") for v in (0, 0.5, 1)], "probability, %", "")
    p.line(x, y + h, x + w, y, "#d0d7de")
    middle = [((low + min(high, 1.0)) / 2, [r for q, r in scored if low <= q < high]) for low, high in BINS]
    bars(p, x, y, w, h, [(at, sum(inside), len(inside)) for at, inside in middle])
    x += 320
    axes(p, x, y, w, h, "wrong answers among the surest, %", [(v, f"{100 * v:.0f}") for v in (0, 0.5, 1)], "share of the cases, %", "")
    points = [(x + w * c, y + h * (1 - risk)) for c, risk in curve]
    for a, b in zip(points, points[1:]):
        p.line(*a, *b, MARK, 1.4)
    return p.svg()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    p = commands.add_parser("collect", help="keep the evidence of diagnosed cases")
    p.add_argument("--batches", help="folder that run.py fills")
    p.add_argument("--trials", help="folder of `trials.py run --keep`")
    p.add_argument("--csv", help="table of these trials")
    p.add_argument("--left-out", action="store_true", help="the concealed cause was taken out of the library, so that `unknown` is right")
    p.add_argument("--imperfect", action="store_true", help="the trials were made with `trials.py run --imperfect`: groups of their own")
    p.set_defaults(call=collect)
    commands.add_parser("fit", help="fit the weights and write the tables").set_defaults(call=fit)
    commands.add_parser("tables", help="write the tables from the predictions").set_defaults(call=tables)
    args = parser.parse_args()
    args.call(args)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
