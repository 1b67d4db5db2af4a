#!/usr/bin/env python3
"""All that the diagnosis was asked with a truth that is known, from the outcomes of `power`, `blind`, `structures`, `unfamiliar`, `foreign`, `published`, `rehearsed`, `encore` and `real`: confusion.md and confusion.svg.

    python3 confusion.py
"""

import csv
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "power"))

from table import matrix, wilson  # noqa: E402


def rows_of(path, first):
    """Rows of the table in a Markdown file whose head begins with `first`."""
    out = []
    with open(os.path.join(HERE, path)) as f:
        lines = iter(f)
        for line in lines:
            if line.startswith(f"| {first} |"):
                head = [w.strip() for w in line.strip().strip("|").split("|")]
                next(lines)
                for row in lines:
                    if not row.startswith("|"):
                        break
                    out.append(dict(zip(head, (w.strip() for w in row.strip().strip("|").split("|")))))
    return out


def made():
    """Trials of `power`: either effect of a pair is right."""
    with open(os.path.join(HERE, "power", "trials.csv")) as f:
        for r in csv.DictReader(f):
            if r["status"] == "done":
                causes = [r["cause"], *r["also"].split()]
                yield "power", causes, [r["verdict"], *r["verdict_also"].split()], float(r["confidence"])


def concealed():
    """Cases of `blind`, `structures`, `unfamiliar`, `foreign`, `published`, `rehearsed` and `encore`, all but the first as their truths were opened."""
    for folder, file in (("blind", "outcome.md"), ("structures", "opened.md"), ("unfamiliar", "opened.md"), ("foreign", "opened.md"), ("published", "opened.md"),
                         ("rehearsed", "opened.md"), ("encore", "opened.md")):
        for r in rows_of(os.path.join(folder, file), "case"):
            yield folder, r["concealed"].split(" + "), r["answer"].split(" + "), float(r["confidence"].split()[0]) / 100.0


def faults():
    """Faults put into real recordings; as recorded there is none, but a model of a real thing is never whole."""
    for r in rows_of(os.path.join("real", "rig_faults", "outcome.md"), "case"):
        truth = "unknown" if r["known"] == "no fault" else r["known"].split()[0]
        yield "faults in real recordings", [truth], r["answer"].split(" + "), float(r["confidence"].split()[0]) / 100.0


def agreed(causes, told):
    return told[0] == causes[0] if causes[0] in ("none", "unknown") else bool(set(causes) & set(told))


def main():
    rows = [*made(), *concealed(), *faults()]
    # What was told of a pair stands with the effect that it names.
    pairs = [(next((c for c in causes if c in told), causes[0]), next((v for v in told if v in causes), told[0])) for _, causes, told, _ in rows]
    matrix(pairs, os.path.join(HERE, "confusion.svg"), "concealed (rows) and told (columns), effects of any size")
    out = ["# Everything with a truth that is known", "", "Written by `confusion.py` from the outcomes of [power](power), [blind](blind), [structures](structures), [unfamiliar](unfamiliar), [foreign](foreign), [published](published), [rehearsed](rehearsed) and [encore](encore) as their truths were opened, and [real/rig_faults](real/rig_faults). "
           "*Right* is either effect of a pair; of a recording as it is, whose model is never whole, `unknown`.", "", "![confusion](confusion.svg)", "",
           "| proof | asked | right (95 % interval) | unknown or none instead of a name | a wrong name | of these with 90 % or more |", "| --- | --- | --- | --- | --- | --- |"]
    for name in [*dict.fromkeys(r[0] for r in rows), "all"]:
        mine = [r for r in rows if name in (r[0], "all")]
        good = sum(agreed(r[1], r[2]) for r in mine)
        wrong = [r for r in mine if not agreed(r[1], r[2])]
        silent = [r for r in wrong if r[2][0] in ("none", "unknown")]
        sure = [r for r in wrong if r not in silent and r[3] >= 0.9]
        low, high = wilson(good, len(mine))
        out.append(f"| {name} | {len(mine)} | {good} ({100 * low:.0f} to {100 * high:.0f} %) | {len(silent)} | {len(wrong) - len(silent)} | {len(sure)} |")
    with open(os.path.join(HERE, "confusion.md"), "w") as f:
        f.write("\n".join(out) + "\n")


if __name__ == "__main__":
    main()
