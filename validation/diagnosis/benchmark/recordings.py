#!/usr/bin/env python3
"""Scores answers to measured recordings whose cause is known.

    python3 validation/diagnosis/benchmark/recordings.py [--answers FILE] [--markdown FILE]

FILE has the columns of `../../recordings/answers.csv`, of which `source`, `study`, `cause`, `also` and `probability` count; that table itself by default.
What is known of each study, and who says so, stands in `../../recordings/expected.csv`.
"""

import argparse
import csv
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, ".."))
from evaluation.rates import wilson  # noqa: E402

RECORDINGS = os.path.join(HERE, "..", "..", "recordings")
# Names that say what was done, and not what an engineer would expect.
CERTAIN = ("put in", "the label of the test", "the pretension in the names of the files", "the actuators' motion in the recording", "recorded as it is")


def rows(path):
    with open(path, newline="") as f:
        return list(csv.DictReader(f))


def expected_of(row, expected):
    """The row of expected.csv for a study: by its name, by what is known of it, or by its source."""
    own = {e["study"]: e for e in expected if e["source"] == row["source"]}
    return own.get(row["study"]) or own.get(row["known"].split(" (")[0]) or own.get("*")


def judged(row, names):
    """`right`, `other` or `none named` of an answer."""
    right = names.split(" or ")
    if row["cause"] in right or any(a in right for a in row["also"].split(" + ")):
        return "right"
    return "none named" if row["cause"] in ("none", "unknown") else "other"


def line(title, scored):
    right = sum(j == "right" for j, _ in scored)
    low, high = wilson(right, len(scored))
    sure = [j for j, p in scored if p >= 0.9]
    return f"| {title} | {len(scored)} | {right} ({100 * low:.0f} to {100 * high:.0f} %) | {sum(j == 'other' for j, _ in scored)} | {sum(j == 'none named' for j, _ in scored)} | {sum(j != 'right' for j in sure)} of {len(sure)} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--answers", default=os.path.join(RECORDINGS, "answers.csv"))
    parser.add_argument("--markdown", help="a file for the table")
    args = parser.parse_args()
    expected = rows(os.path.join(RECORDINGS, "expected.csv"))
    groups = {"the cause was put in, switched or recorded": [], "an engineer would name it": []}
    for row in rows(args.answers):
        known = expected_of(row, expected)
        if known is None:
            sys.exit(f"expected.csv has no row for {row['source']} {row['study']}")
        certain = known["who"].startswith(CERTAIN)
        groups[list(groups)[not certain]].append((judged(row, known["names"]), float(row["probability"])))
    lines = ["| known because | studies | right (95 % interval) | another cause | none or unknown instead | wrong at 90 % and more |", "| --- | --- | --- | --- | --- | --- |"]
    lines += [line(title, scored) for title, scored in groups.items() if scored]
    text = "\n".join(lines) + "\n"
    print(text, end="")
    if args.markdown:
        with open(args.markdown, "w") as f:
            f.write(f"# Answers to measured recordings\n\nWritten by `recordings.py --markdown`.\n\n{text}")


if __name__ == "__main__":
    main()
