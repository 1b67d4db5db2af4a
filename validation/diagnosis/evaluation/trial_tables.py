"""Tables and charts of the seeded trials in trials.csv."""

import csv
import math

from .rates import fraction, median, rate, table
from .svg import Picture, axes, bars, matrix

EDGES = (0.0, 1.5, 2.5, 4.0, 7.0, 12.0, 99.0)  # classes of effect over noise
CLEAR = 4.0  # effect over noise from which a cause should be found
CONFIDENCES = (0.0, 0.4, 0.6, 0.8, 0.9, 0.95, 1.01)
MAX_SELF_CHECK = 1e-3  # NMSE of the script with the effect off against the generator
NO_CAUSE = ("none", "unknown")


def size(r):
    """Effect over noise as drawn, but at most what the fitted baseline left: a nonlinear fit takes up more than sensitivities say."""
    left = float(r["baseline_fit"]) / float(r["floor_fit"]) - 1.0
    return min(float(r["effect_over_noise"]), math.sqrt(max(left, 0.0)))


class Trials:
    """The rows of trials.csv by what is concealed in them."""

    def __init__(self, path):
        with open(path) as f:
            self.all = list(csv.DictReader(f))
        self.failed = [r for r in self.all if r["status"] != "done"]
        answered = [r for r in self.all if r["status"] == "done"]
        self.untrusted = [r for r in answered if float(r["self_check"]) > MAX_SELF_CHECK]
        self.rows = [r for r in answered if float(r["self_check"]) <= MAX_SELF_CHECK]
        self.null = [r for r in self.rows if r["cause"] == "none"]
        self.unknown = [r for r in self.rows if r["cause"] == "unknown"]
        named = [r for r in self.rows if r["cause"] not in NO_CAUSE]
        self.pairs = [r for r in named if r["also"]]
        self.single = [r for r in named if not r["also"]]
        self.causes = sorted({r["cause"] for r in self.single})


def in_class(rows, low, high):
    return [r for r in rows if low <= size(r) < high]


def summary(t):
    clear = [r for r in t.single if size(r) >= CLEAR]
    named = sum(r["verdict"] not in NO_CAUSE for r in t.unknown)
    return ["", *table(["", ""], [
        (f"cause right, effect over noise at least {CLEAR:g}", rate(clear)),
        ("cause right, any size", rate(t.single)),
        ("one of two effects right", rate(t.pairs)),
        ("nothing called where nothing is", rate(t.null)),
        ("unknown left unknown", rate(t.unknown)),
        ("a listed cause called where it is unknown", f"{named} of {len(t.unknown)}"),
        ("run and channel right", rate([r for r in clear + t.pairs if r["right"] == "1"], "place")),
        ("windows, intersection over union, median (cases)", median(clear, "iou")),
        ("share of the distance to the noise floor that the repair covers on held out runs, median (cases)", median(clear, "gain")),
        ("processor time of a case, s, median (cases)", median(t.rows, "cpu_s", "{:.1f}")),
    ])]


def by_cause(t):
    classes = list(zip(EDGES, EDGES[1:]))
    rows = []
    for cause in t.causes:
        mine = [r for r in t.single if r["cause"] == cause]
        cells = []
        for low, high in classes:
            inside = in_class(mine, low, high)
            cells.append(f"{sum(int(r['right']) for r in inside)}/{len(inside)}" if inside else "")
        wrong = {}
        for r in mine:
            if r["right"] == "0":
                wrong[r["verdict"]] = wrong.get(r["verdict"], 0) + 1
        confused = ", ".join(f"{k} {n}" for k, n in sorted(wrong.items(), key=lambda kv: -kv[1]))
        rows.append([cause, *cells, median([r for r in mine if size(r) >= CLEAR], "gain"), confused])
    heads = [f"{a:g} to {b:g}" if b < 99 else f"over {a:g}" for a, b in classes]
    return ["", "## By cause", "", "Right of all, by effect over noise.", "", *table(["cause", *heads, "gain", "confused with"], rows)]


def by_kind(t):
    noises = [(kind, rate([r for r in t.null if r["noise"] == kind])) for kind in sorted({r["noise"] for r in t.null})]
    unknowns = []
    for kind in sorted({r["kinds"] for r in t.unknown}):
        rows = [r for r in t.unknown if r["kinds"] == kind]
        unknowns.append((kind, rate(rows), ", ".join(sorted({r["verdict"] for r in rows if r["verdict"] != "unknown"}))))
    return ["", "## Nulls by noise", "", *table(["noise", "quiet"], noises),
            "", "## Unknowns by kind", "", *table(["kind", "left unknown", "called"], unknowns),
            *by_confidence(t)]


def by_confidence(t):
    sure = [(f"{100 * a:.0f} to {100 * min(b, 1):.0f} %", rate([r for r in t.rows if a <= float(r["confidence"]) < b])) for a, b in zip(CONFIDENCES, CONFIDENCES[1:])]
    return ["", "## Confidence against frequency", "", *table(["confidence", "right"], sure)]


def by_build(t, path):
    """One row for each range of seeds that a build diagnosed first."""
    rows = []
    with open(path) as f:
        for build in csv.DictReader(f):
            spans = [tuple(map(int, span.split("-"))) for span in build["seeds"].split()]

            def own(trials):
                return [r for r in trials if any(a <= int(r["seed"]) <= b for a, b in spans)]

            single = own(t.single)
            seeds = ", ".join(f"{a} to {b}" for a, b in spans)
            rows.append((seeds, build["new"], *map(fraction, (single, [r for r in single if size(r) >= CLEAR], own(t.pairs), own(t.null), own(t.unknown)))))
    return ["", "## By build", "", "Each range was diagnosed first by the build of its time. None had been looked at before. Each stopped when its time was over, not by its outcome.", "",
            *table(["seeds", "new in the build", "single effects", f"of these at {CLEAR:g} times the noise", "pairs", "nulls quiet", "unknowns left"], rows)]


def failures(t):
    rows = []
    for r in t.rows:
        if r["right"] == "0" and (not r["effect_over_noise"] or size(r) >= CLEAR):
            over = f"{size(r):.1f}" if r["effect_over_noise"] else "-"
            rows.append((r["seed"], r["family"], r["kinds"] or "nothing", over, f"{r['verdict']} {r['verdict_also']}", r["confidence"]))
    rows += [(r["seed"], r["family"], r["kinds"], r["effect_over_noise"], r["status"].replace("|", " "), "") for r in t.failed]
    return ["", "## Failures", "", f"Wrong answers where the effect is at least {CLEAR:g} times the noise, false alarms, and unknowns that were named.", "",
            *table(["seed", "family", "concealed", "over noise", "answer", "confidence"], rows)]


def markdown(t, builds):
    out = ["# Seeded trials: outcome", "",
           "Written by `tables.py` from `trials.csv` and `builds.csv`. Rates with the 95 % interval of Wilson.", "",
           f"{len(t.all)} trials; {len(t.failed)} without an answer, {len(t.untrusted)} left out because script and generator differ by more than {MAX_SELF_CHECK:g}."]
    return "\n".join([*out, *summary(t), *by_cause(t), *by_kind(t), *by_build(t, builds), *failures(t)]) + "\n"


def imperfect(t):
    """imperfect.md: trials of models that are only roughly right, none of which the weights were fitted to."""
    wrong = [(r["seed"], r["family"], r["kinds"] or "nothing", r["effect_over_noise"] or "-", f"{r['verdict']} {r['verdict_also']}", r["confidence"]) for r in t.rows if r["right"] == "0"]
    out = ["# Trials of models that are only roughly right", "",
           "Written by `tables.py` from `imperfect.csv`. Rates with the 95 % interval of Wilson. The weights of the verdict were fitted to none of them.", "",
           f"{len(t.all)} trials; {len(t.failed)} without an answer."]
    heads = ["seed", "family", "concealed", "over noise", "answer", "confidence"]
    return "\n".join([*out, *summary(t), *by_confidence(t), "", "## Wrong answers", "", *table(heads, wrong)]) + "\n"


def curves(t):
    panels = [("all causes", t.single)] + [(c, [r for r in t.single if r["cause"] == c]) for c in t.causes]
    columns, w, h = 4, 170, 90
    rows = math.ceil(len(panels) / columns)
    p = Picture(columns * (w + 60) + 20, rows * (h + 62) + 20)
    n = len(EDGES) - 1
    ticks = [(i / n, f"{a:g}") for i, a in enumerate(EDGES) if 0.0 < a < 99.0]
    for i, (name, mine) in enumerate(panels):
        x, y = 50 + (i % columns) * (w + 60), 26 + (i // columns) * (h + 62)
        axes(p, x, y, w, h, name.replace("_", " "), ticks, "effect over noise", "identified, %")
        groups = []
        for j, (a, b) in enumerate(zip(EDGES, EDGES[1:])):
            inside = [int(r["right"]) for r in in_class(mine, a, b)]
            groups.append(((j + 0.5) / n, sum(inside), len(inside)))
        bars(p, x, y, w, h, groups)
    return p.svg()


def confusion(t):
    rows = [r for r in t.rows if not r["effect_over_noise"] or size(r) >= CLEAR]
    return matrix([(r["cause"], r["verdict"]) for r in rows if not r["also"]],
                  f"concealed (rows) and told (columns); effect at least {CLEAR:g} times the noise")
