"""Tables of the sealed batches: one row a batch, one a case, and the confusion matrix over all that has a known truth."""

import csv
import os

from .rates import table, wilson
from .svg import matrix
from .trial_tables import NO_CAUSE

FIELDS = ("batch", "state", "case", "concealed", "answer", "confidence", "right", "place", "fitted", "fitted_repaired", "held_out", "held_out_repaired", "noise")
OPENED, LATER, KNOCKED_OUT = "opened", "later", "knocked out"
# Batch 1 stands in the matrix by its later answers, as it has since it was made; nine of ten were right as opened.
IN_MATRIX = {"1": LATER}
SURE, EQUIVALENT = 80, 2.0  # confidence in %, and factor on the held out NMSE of the repair by the whole library
CASE_HEADS = ("case", "concealed", "answer", "confidence", "right", "place", "fitted NMSE", "held out NMSE", "noise")
KNOCK_HEADS = ("case", "left out", "answer", "confidence", "held out NMSE", "whole", "it is")


def rows_of(path):
    with open(path, newline="") as f:
        return list(csv.DictReader(f))


def chosen(outcomes, batch, state):
    return [r for r in outcomes if r["batch"] == batch and r["state"] == state]


def score(rows):
    return f"{sum(r['right'] == 'yes' for r in rows)} of {len(rows)}"


def summary(batches, outcomes):
    """The table of the README: one row a batch."""
    rows = []
    for b in batches:
        opened = chosen(outcomes, b["batch"], OPENED)
        rows.append((b["batch"], b["cases"], b["models"], b["author"], b["concealed_by"], b["drawn"], b["made_again"], f"`{b['seal'][:12]}`", score(opened) if opened else "not yet run"))
    heads = ("batch", "cases", "models", "author", "concealed by", "drawn by", "made again to the byte", "seal", "right as opened")
    return table(heads, rows)


def case_row(r):
    return (r["case"], r["concealed"], r["answer"], f"{r['confidence']} %", r["right"], r["place"],
            f"{r['fitted']} → {r['fitted_repaired']}", f"{r['held_out']} → {r['held_out_repaired']}", r["noise"])


def kind_of(r, whole):
    """The class of an answer whose cause was taken out of the library."""
    if r["answer"] in NO_CAUSE:
        return r["answer"]
    if float(r["held_out_repaired"]) <= EQUIVALENT * float(whole):
        return "an equivalent"
    return "hesitant" if float(r["confidence"]) < SURE else "confident and wrong"


def knocked_out(outcomes, batch):
    """Lines on the cases whose concealed cause was taken out of the library."""
    rows, counts = [], {}
    whole = {r["case"]: r["held_out_repaired"] for r in chosen(outcomes, batch, LATER) or chosen(outcomes, batch, OPENED)}
    for r in chosen(outcomes, batch, KNOCKED_OUT):
        kind = kind_of(r, whole[r["case"]])
        counts[kind] = counts.get(kind, 0) + 1
        rows.append((r["case"], r["concealed"], r["answer"], f"{r['confidence']} %", f"{r['held_out']} → {r['held_out_repaired']}", whole[r["case"]], kind))
    if not rows:
        return []
    return ["", "### The concealed cause taken out of the library", "",
            f"*Whole* is the held out NMSE of the repair by the whole library. An answer is *an equivalent* if its repair has at most {EQUIVALENT:g} times that.",
            f"It is *hesitant* if its confidence is below {SURE} %. What is left is *confident and wrong*.", "",
            *table(KNOCK_HEADS, rows), "", ", ".join(f"{n} {kind}" for kind, n in sorted(counts.items())) + "."]


def markdown(batches, outcomes, misses):
    """outcomes.md: all cases of all batches."""
    out = ["# Sealed batches: outcome", "", "Written by `tables.py` from `outcomes.csv` and `misses.csv`.",
           "*As opened* is the answer of the build before the truth was known. *Later* is a diagnosis again, with the truth in sight: it proves only that the cause of the miss was understood."]
    for b in batches:
        out += ["", f"## Batch {b['batch']}", "", f"Models: {b['models']}.", *([b["note"]] if b["note"] else [])]
        for state, title in ((OPENED, "As opened"), (LATER, "Later")):
            rows = chosen(outcomes, b["batch"], state)
            if rows:
                out += ["", f"### {title}", "", *table(CASE_HEADS, map(case_row, rows)), "", f"{score(rows)} right."]
        out += knocked_out(outcomes, b["batch"])
        mine = [m for m in misses if m["batch"] == b["batch"]]
        if mine:
            out += ["", "### Misses", "", *table(("case", "concealed", "cause of the miss", "since"), [(m["case"], m["concealed"], m["cause_of_the_miss"], m["since"]) for m in mine])]
    return "\n".join(out) + "\n"


def markdown_rows(path, first):
    """Rows of the tables in a Markdown file whose head begins with `first`."""
    out, head = [], None
    with open(path) as f:
        for line in f:
            cells = [w.strip() for w in line.strip().strip("|").split("|")]
            if line.startswith(f"| {first} |"):
                head = cells
            elif not line.startswith("|"):
                head = None
            elif head and not line.startswith("| ---"):
                out.append(dict(zip(head, cells)))
    return out


def known_truths(trials, outcomes, recordings):
    """(set, causes concealed, causes answered, confidence) of everything with a known truth."""
    for r in trials.all:
        if r["status"] == "done":
            yield "trials", [r["cause"], *r["also"].split()], [r["verdict"], *r["verdict_also"].split()], float(r["confidence"])
    for r in outcomes:
        if r["state"] == IN_MATRIX.get(r["batch"], OPENED):
            yield f"batch {r['batch']}", r["concealed"].split(" + "), r["answer"].split(" + "), float(r["confidence"]) / 100.0
    # A model of a real specimen is never whole, so that its recording without a fault is an unknown.
    for r in markdown_rows(os.path.join(recordings, "rig_faults", "outcome.md"), "case"):
        truth = "unknown" if r["known"] == "no fault" else r["known"].split()[0]
        yield "faults in real recordings", [truth], r["answer"].split(" + "), float(r["confidence"].split()[0]) / 100.0


def agreed(causes, answered):
    return answered[0] == causes[0] if causes[0] in NO_CAUSE else bool(set(causes) & set(answered))


def confusion(trials, outcomes, recordings):
    """confusion.md and confusion.svg."""
    rows = list(known_truths(trials, outcomes, recordings))
    # The answer to a pair stands with the effect that it names.
    pairs = [(next((c for c in causes if c in answered), causes[0]), next((v for v in answered if v in causes), answered[0])) for _, causes, answered, _ in rows]
    lines = []
    for name in [*dict.fromkeys(r[0] for r in rows), "all"]:
        mine = [r for r in rows if name in (r[0], "all")]
        wrong = [r for r in mine if not agreed(r[1], r[2])]
        silent = [r for r in wrong if r[2][0] in NO_CAUSE]
        sure = [r for r in wrong if r[2][0] not in NO_CAUSE and r[3] >= 0.9]
        good = len(mine) - len(wrong)
        low, high = wilson(good, len(mine))
        lines.append((name, len(mine), f"{good} ({100 * low:.0f} to {100 * high:.0f} %)", len(silent), len(wrong) - len(silent), len(sure)))
    out = ["# Everything with a known truth", "",
           "Written by `tables.py` from the [seeded trials](trials.md), the [sealed batches](outcomes.md) as opened (batch 1 as diagnosed later) and the [faults put into real recordings](../recordings/rig_faults).",
           "*Right* is either effect of a pair. Of a recording without a fault, whose model is never whole, `unknown` is right.", "", "![confusion](confusion.svg)", "",
           *table(("set", "cases", "right (95 % interval)", "unknown or none instead of a cause", "a wrong cause", "of these with 90 % or more"), lines)]
    return "\n".join(out) + "\n", matrix(pairs, "concealed (rows) and told (columns), effects of any size")
