#!/usr/bin/env python3
"""Writes every table and chart of this folder from its csv files, and the faults in ../recordings.

    python3 validation/diagnosis/tables.py            # write them
    python3 validation/diagnosis/tables.py --check    # say which are not current, exit status 1 if any
"""

import argparse
import os
import sys

from evaluation import batch_tables, trial_tables

HERE = os.path.dirname(os.path.abspath(__file__))
RECORDINGS = os.path.join(HERE, "..", "recordings")
BEGIN, END = "<!-- batches: written by tables.py -->\n", "<!-- end of batches -->"


def here(name):
    return os.path.join(HERE, name)


def current(name):
    if not os.path.exists(here(name)):
        return ""
    with open(here(name)) as f:
        return f.read()


def with_summary(readme, lines):
    """The README with the table of batches between its marks."""
    before, rest = readme.split(BEGIN)
    return before + BEGIN + "\n" + "\n".join(lines) + "\n\n" + END + rest.split(END)[1]


def generated():
    """{name: text} of every generated file."""
    trials = trial_tables.Trials(here("trials.csv"))
    batches, outcomes, misses = (batch_tables.rows_of(here(name)) for name in ("batches.csv", "outcomes.csv", "misses.csv"))
    matrix, picture = batch_tables.confusion(trials, outcomes, RECORDINGS)
    return {
        "README.md": with_summary(current("README.md"), batch_tables.summary(batches, outcomes)),
        "outcomes.md": batch_tables.markdown(batches, outcomes, misses),
        "confusion.md": matrix,
        "confusion.svg": picture,
        "trials.md": trial_tables.markdown(trials, here("builds.csv")),
        "imperfect.md": trial_tables.imperfect(trial_tables.Trials(here("imperfect.csv"))),
        "trials.svg": trial_tables.curves(trials),
        "trials_confusion.svg": trial_tables.confusion(trials),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if a file is not current")
    args = parser.parse_args()
    stale = [(name, text) for name, text in generated().items() if current(name) != text]
    for name, text in stale:
        print(("not current: " if args.check else "written: ") + name)
        if not args.check:
            with open(here(name), "w") as f:
                f.write(text)
    sys.exit(1 if args.check and stale else 0)


if __name__ == "__main__":
    main()
