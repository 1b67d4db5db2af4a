"""trials.csv as a table and pictures."""

import csv
import math
import os
import statistics

EDGES = (0.0, 1.5, 2.5, 4.0, 7.0, 12.0, 99.0)
CLEAR = 4.0
CONFIDENCES = (0.0, 0.4, 0.6, 0.8, 0.9, 0.95, 1.01)
TRUST = 1e-3  # self check
INK, PALE, MARK = "#1b1f24", "#d0d7de", "#0b62a8"


def wilson(hits, n, z=1.96):
    """Interval of a rate (Wilson 1927), 95 %."""
    if not n:
        return 0.0, 1.0
    p = hits / n
    mid = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    return max(0.0, mid - half), min(1.0, mid + half)


def rate(rows, key="right"):
    hits = [int(r[key]) for r in rows if r[key] != ""]
    if not hits:
        return "-"
    low, high = wilson(sum(hits), len(hits))
    return f"{sum(hits)} of {len(hits)} ({100 * low:.0f} to {100 * high:.0f} %)"


def middle(rows, key, form="{:.2f}"):
    values = [float(r[key]) for r in rows if r[key] not in ("", None)]
    return form.format(statistics.median(values)) + f" ({len(values)})" if values else "-"


def size(r):
    """Effect over noise: as drawn, but no more than what the fitted baseline left (a nonlinear fit takes up more than sensitivities say)."""
    left = float(r["baseline_fit"]) / float(r["floor_fit"]) - 1.0
    return min(float(r["effect_over_noise"]), math.sqrt(max(left, 0.0)))


class Trials:
    def __init__(self, path):
        with open(path) as f:
            self.all = list(csv.DictReader(f))
        self.failed = [r for r in self.all if r["status"] != "done"]
        told = [r for r in self.all if r["status"] == "done"]
        self.untrusted = [r for r in told if float(r["self_check"]) > TRUST]
        self.rows = [r for r in told if float(r["self_check"]) <= TRUST]
        self.null = [r for r in self.rows if r["cause"] == "none"]
        self.unknown = [r for r in self.rows if r["cause"] == "unknown"]
        named = [r for r in self.rows if r["cause"] not in ("none", "unknown")]
        self.pairs = [r for r in named if r["also"]]
        self.single = [r for r in named if not r["also"]]
        self.causes = sorted({r["cause"] for r in self.single})


def markdown(t):
    clear = [r for r in t.single if size(r) >= CLEAR]
    out = ["# Power of the diagnosis: outcome", "",
           "Written by `power.py table` from `trials.csv`. Rates with the 95 % interval of Wilson.", "",
           f"{len(t.all)} trials; {len(t.failed)} without an answer, {len(t.untrusted)} left out because script and generator differ by more than 1e-3.", "",
           "| | |", "| --- | --- |",
           f"| cause right, effect over noise at least {CLEAR:g} | {rate(clear)} |",
           f"| cause right, any size | {rate(t.single)} |",
           f"| one of two effects right | {rate(t.pairs)} |",
           f"| nothing called where nothing is | {rate(t.null)} |",
           f"| unknown left unknown | {rate(t.unknown)} |",
           f"| a listed cause called where it is unknown | {sum(r['verdict'] not in ('none', 'unknown') for r in t.unknown)} of {len(t.unknown)} |",
           f"| run and channel right | {rate([r for r in clear + t.pairs if r['right'] == '1'], 'place')} |",
           f"| windows, intersection over union, median (cases) | {middle(clear, 'iou')} |",
           f"| share of the distance to the noise floor that the repair covers on held out runs, median (cases) | {middle(clear, 'gain')} |",
           f"| processor time of a case, s, median (cases) | {middle(t.rows, 'cpu_s', '{:.1f}')} |", "",
           "## By cause", "", "Right of all, by effect over noise.", ""]
    heads = [f"{a:g} to {b:g}" if b < 99 else f"over {a:g}" for a, b in zip(EDGES, EDGES[1:])]
    out += ["| cause | " + " | ".join(heads) + " | gain | confused with |", "| --- |" + " --- |" * (len(heads) + 2)]
    for cause in t.causes:
        mine = [r for r in t.single if r["cause"] == cause]
        cells = []
        for a, b in zip(EDGES, EDGES[1:]):
            rows = [r for r in mine if a <= size(r) < b]
            cells.append(f"{sum(int(r['right']) for r in rows)}/{len(rows)}" if rows else "")
        wrong = {}
        for r in mine:
            if r["right"] == "0":
                wrong[r["verdict"]] = wrong.get(r["verdict"], 0) + 1
        said = ", ".join(f"{k} {n}" for k, n in sorted(wrong.items(), key=lambda kv: -kv[1]))
        out.append(f"| {cause} | " + " | ".join(cells) + f" | {middle([r for r in mine if size(r) >= CLEAR], 'gain')} | {said} |")
    out += ["", "## Nulls by noise", "", "| noise | quiet |", "| --- | --- |"]
    for kind in sorted({r["noise"] for r in t.null}):
        out.append(f"| {kind} | {rate([r for r in t.null if r['noise'] == kind])} |")
    out += ["", "## Unknowns by kind", "", "| kind | left unknown | called |", "| --- | --- | --- |"]
    for kind in sorted({r["kinds"] for r in t.unknown}):
        rows = [r for r in t.unknown if r["kinds"] == kind]
        called = ", ".join(sorted({r["verdict"] for r in rows if r["verdict"] != "unknown"}))
        out.append(f"| {kind} | {rate(rows)} | {called} |")
    out += ["", "## Confidence against frequency", "", "| confidence | right |", "| --- | --- |"]
    for a, b in zip(CONFIDENCES, CONFIDENCES[1:]):
        out.append(f"| {100 * a:.0f} to {100 * min(b, 1):.0f} % | {rate([r for r in t.rows if a <= float(r['confidence']) < b])} |")
    out += ["", "## Failures", "", "Wrong answers where the effect is at least " + f"{CLEAR:g} times the noise, false alarms, and unknowns that were named.", "",
            "| seed | family | concealed | over noise | answer | confidence |", "| --- | --- | --- | --- | --- | --- |"]
    for r in t.rows:
        if r["right"] == "0" and (not r["effect_over_noise"] or size(r) >= CLEAR):
            over = f"{size(r):.1f}" if r["effect_over_noise"] else "-"
            out.append(f"| {r['seed']} | {r['family']} | {r['kinds'] or 'nothing'} | {over} | {r['verdict']} {r['verdict_also']} | {r['confidence']} |")
    for r in t.failed:
        out.append(f"| {r['seed']} | {r['family']} | {r['kinds']} | {r['effect_over_noise']} | {r['status'].replace('|', ' ')} | |")
    return "\n".join(out) + "\n"


# ------------------------------------------------------------------ pictures


class Picture:
    def __init__(self, width, height):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="11" fill="{INK}">',
                      f'<rect width="{width}" height="{height}" fill="#ffffff"/>']

    def line(self, x1, y1, x2, y2, colour=INK, width=1.0, dash=""):
        dash = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}" stroke-width="{width}"{dash}/>')

    def text(self, x, y, said, anchor="middle", turn=0, size=11, colour=INK):
        turn = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{colour}"{turn}>{said}</text>')

    def box(self, x, y, w, h, fill, edge="none"):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{w:.1f}" height="{h:.1f}" fill="{fill}" stroke="{edge}"/>')

    def dot(self, x, y, r=3.0):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{MARK}"/>')

    def save(self, path):
        with open(path, "w") as f:
            f.write("\n".join(self.parts) + "\n</svg>\n")


def axes(p, x, y, w, h, title, xticks, across, up):
    for v in (0, 50, 100):
        level = y + h * (1 - v / 100)
        p.line(x, level, x + w, level, PALE)
        p.text(x - 5, level + 4, f"{v}", "end", size=9)
    p.line(x, y + h, x + w, y + h)
    for at, said in xticks:
        p.line(x + w * at, y + h, x + w * at, y + h + 3)
        p.text(x + w * at, y + h + 13, said, size=9)
    p.text(x + w / 2, y - 6, title)
    if across:
        p.text(x + w / 2, y + h + 26, across, size=9)
    if up:
        p.text(x - 28, y + h / 2, up, turn=-90, size=9)


def bars(p, x, y, w, h, groups):
    """Rates with intervals: (place 0..1, hits, n)."""
    last = None
    for at, hits, n in groups:
        if not n:
            continue
        cx, cy = x + w * at, y + h * (1 - hits / n)
        low, high = wilson(hits, n)
        p.line(cx, y + h * (1 - low), cx, y + h * (1 - high), MARK, 1.0)
        if last:
            p.line(*last, cx, cy, MARK, 1.4)
        p.dot(cx, cy)
        p.text(cx + 5, cy - 4 if hits < n else cy + 11, f"{n}", "start", size=8, colour="#57606a")
        last = cx, cy


def curves(t, path):
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
            inside = [int(r["right"]) for r in mine if a <= size(r) < b]
            groups.append(((j + 0.5) / n, sum(inside), len(inside)))
        bars(p, x, y, w, h, groups)
    p.save(path)


def calibration(t, path):
    p = Picture(460, 380)
    x, y, w, h = 60, 40, 370, 280
    axes(p, x, y, w, h, "Confidence against frequency", [(v / 100, f"{v}") for v in range(0, 101, 20)], "confidence told, %", "right, %")
    p.line(x, y + h, x + w, y, "#57606a", 1.0, "4 3")
    groups = []
    for a, b in zip(CONFIDENCES, CONFIDENCES[1:]):
        inside = [r for r in t.rows if a <= float(r["confidence"]) < b]
        if inside:
            groups.append((sum(float(r["confidence"]) for r in inside) / len(inside), sum(int(r["right"]) for r in inside), len(inside)))
    bars(p, x, y, w, h, groups)
    p.save(path)


def confusion(t, path):
    rows = [r for r in t.rows if not r["effect_over_noise"] or size(r) >= CLEAR]
    matrix([(r["cause"], r["verdict"]) for r in rows if not r["also"]], path,
           f"concealed (rows) and told (columns); effect at least {CLEAR:g} times the noise")


def matrix(pairs, path, legend):
    """A picture of pairs (concealed, told)."""
    truths = sorted({c for c, _ in pairs}, key=lambda c: (c in ("none", "unknown"), c))
    said = truths + sorted({v for _, v in pairs} - set(truths))
    cell, left, top = 22, 170, 170
    p = Picture(left + cell * len(said) + 100, top + cell * len(truths) + 40)
    for j, name in enumerate(said):
        p.text(left + cell * (j + 0.5) + 4, top - 6, name.replace("_", " "), "start", turn=-60, size=10)
    for i, name in enumerate(truths):
        mine = [v for c, v in pairs if c == name]
        p.text(left - 6, top + cell * (i + 0.5) + 4, f"{name.replace('_', ' ')} ({len(mine)})", "end", size=10)
        for j, other in enumerate(said):
            n = mine.count(other)
            share = n / len(mine)
            shade = tuple(round(255 + share * (c - 255)) for c in ((11, 98, 168) if name == other else (178, 60, 40)))
            p.box(left + cell * j, top + cell * i, cell, cell, "rgb(%d,%d,%d)" % shade, PALE)
            if n:
                p.text(left + cell * (j + 0.5), top + cell * (i + 0.5) + 4, str(n), size=10, colour="#ffffff" if share > 0.55 else INK)
    p.text(10, top + cell * len(truths) + 22, legend, "start", size=10)
    p.save(path)


def write(path, folder):
    t = Trials(path)
    with open(os.path.join(folder, "table.md"), "w") as f:
        f.write(markdown(t))
    curves(t, os.path.join(folder, "power.svg"))
    calibration(t, os.path.join(folder, "calibration.svg"))
    confusion(t, os.path.join(folder, "confusion.svg"))
