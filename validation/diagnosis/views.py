#!/usr/bin/env python3
"""Writes the same tests down in other ways, diagnoses each, and prints a table of the first names.

    views.py --engine target/release/hysteron --out results/views CASE ... [--view NAME ...] [--quantities FILE]

A case is a folder with study.toml, model.tcl, motions and recordings. The views:

    plain                 as it is
    samples-N             N samples a cycle: an anti-aliased decimation of the recordings, or an interpolation
    cut                   the first 70 % of the recordings
    N-mm, lbf-in          other units of model, motions and recordings; need --quantities
    start-0.7, start-1.5  the values of the parameters in the script times this, within their bounds

A cycle is the mean distance of the upward zero crossings of the recorded channel. FILE says what the numbers of the script mean, one a line:
a text of the script in front of a number, a tab, the exponent of force, a tab, the exponent of length. Lines that begin with
`parameter NAME`, `variable NAME`, `motions` and `channel NAME` do the same for bounds of the study, variables of its runs, files of motions and
channels. A case whose table is done is not diagnosed again. Needs Python 3.9 and nothing else.
"""

import argparse
import csv
import math
import pathlib
import re
import shutil
import subprocess
import json
import sys
import time

SHORT = 0.7
# Unit of force and of length of a view, with the factors on numbers in N and m.
SYSTEMS = {"N-mm": ("N", 1.0, "mm", 1e3), "lbf-in": ("lbf", 1 / 4.4482216152605, "in", 1 / 0.0254)}
VIEWS = ["plain", "samples-40", "samples-100", "samples-400", "cut", "N-mm", "lbf-in", "start-0.7", "start-1.5"]
# Half width of the kernel of a decimation, in samples of the result.
KERNEL = 4.0
# Pass band of a decimation, in parts of the highest frequency of the result.
PASS = 0.9


def table(path):
    with open(path) as f:
        rows = list(csv.reader(f))
    return rows[0], [[float(x) if x.strip() else math.nan for x in r] for r in rows[1:] if r]


def write_table(path, head, rows):
    with open(path, "w", newline="") as f:
        w = csv.writer(f, lineterminator="\n")
        w.writerow(head)
        w.writerows(["" if math.isnan(x) else f"{x:.7g}" for x in r] for r in rows)


def cycle(times, values):
    """Mean distance of upward crossings of the mean, those of noise left out: a crossing follows a value below a tenth of the amplitude."""
    known = [v for v in values if not math.isnan(v)]
    mean = sum(known) / len(known)
    level = 0.1 * max(abs(v - mean) for v in known)
    crossings, below = [], False
    for t, v in zip(times, values):
        if v - mean < -level:
            below = True
        elif v - mean > level and below:
            crossings.append(t)
            below = False
    return (crossings[-1] - crossings[0]) / (len(crossings) - 1)


def decimated(times, values, at, step):
    """Means weighted by a windowed sinc, at other times a `step` apart."""
    out, first, reach = [], 0, KERNEL * step
    for t in at:
        while times[first] < t - reach:
            first += 1
        total = weights = 0.0
        for i in range(first, len(times)):
            x = (times[i] - t) / step
            if x > KERNEL:
                break
            y = math.pi * PASS * x
            w = (math.sin(y) / y if y else 1.0) * (0.5 + 0.5 * math.cos(math.pi * x / KERNEL))
            if not math.isnan(values[i]):
                total, weights = total + w * values[i], weights + w
        out.append(total / weights if weights else math.nan)
    return out


def interpolated(times, values, at):
    """Cubic interpolation with slopes by central differences; what has a missing neighbour is missing."""
    def slope(i):
        a, b = max(i - 1, 0), min(i + 1, len(times) - 1)
        return (values[b] - values[a]) / (times[b] - times[a])

    out, i = [], 0
    for t in at:
        while i + 2 < len(times) and times[i + 1] <= t:
            i += 1
        h = times[i + 1] - times[i]
        s = (t - times[i]) / h
        a, b = (1 + 2 * s) * (1 - s) ** 2, s * (1 - s) ** 2
        c, d = s * s * (3 - 2 * s), s * s * (s - 1)
        out.append(a * values[i] + b * h * slope(i) + c * values[i + 1] + d * h * slope(i + 1))
    return out


def resampled(head, rows, channels, per_cycle):
    times = [r[0] for r in rows]
    columns = list(zip(*rows))
    first = next(columns[k] for k, h in enumerate(head) if h.split("[")[0] in channels)
    step = cycle(times, first) / per_cycle
    at = [times[0] + i * step for i in range(int((times[-1] - times[0]) / step) + 1)]
    if step > (times[-1] - times[0]) / (len(times) - 1):
        new = [decimated(times, c, at, step) for c in columns[1:]]
    else:
        new = [interpolated(times, c, at) for c in columns[1:]]
    return [list(r) for r in zip(at, *new)]


def recordings(folder):
    text = (folder / "study.toml").read_text()
    return [folder / n for n in dict.fromkeys(re.findall(r'^recording\s*=\s*"(.*)"', text, re.M))], set(re.findall(r'^channel\s*=\s*"(.*)"', text, re.M))


def scaled(text, factor):
    return f"{float(text) * factor:.12g}"


def in_units(folder, view, quantities):
    force_unit, force, length_unit, length = SYSTEMS[view]
    model, study = (folder / "model.tcl").read_text(), (folder / "study.toml").read_text()
    number = r"([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)"
    for line in pathlib.Path(quantities).read_text().splitlines():
        if not line.strip():
            continue
        what, of_force, of_length = line.split("\t")
        factor = force ** float(of_force) * length ** float(of_length)
        change = lambda m: m.group(1) + scaled(m.group(2), factor)  # noqa: E731
        if what.startswith("parameter "):
            name = re.escape(what.split()[1])
            block = re.compile(rf'(name\s*=\s*"{name}"\n(?:.*\n)*?)(?=\n|\[\[|\Z)')
            study, n = block.subn(lambda m: re.sub(rf"((?:lower|upper)\s*=\s*){number}", change, m.group(1)), study)
        elif what.startswith("variable "):
            study, n = re.subn(rf"(\b{re.escape(what.split()[1])}\s*=\s*){number}", change, study)
        elif what == "motions":
            files = list(folder.glob("*.dat"))
            for file in files:
                file.write_text("\n".join(scaled(x, factor) for x in file.read_text().split()) + "\n")
            n = len(files)
        elif what.startswith("channel "):
            n, name = 0, what.split()[1]
            for file in recordings(folder)[0]:
                head, rows = table(file)
                for k, h in enumerate(head):
                    if h.split("[")[0] == name:
                        unit = force_unit if float(of_force) else length_unit
                        head[k], n = f"{name}[{unit}]", n + 1
                        for r in rows:
                            r[k] *= factor
                write_table(file, head, rows)
        else:
            model, n = re.subn(rf"({re.escape(what)}\s*){number}", change, model)
        if not n:
            sys.exit(f"{folder}: nothing is {what!r}")
    model = re.sub(r"^# units:.*$", f"# units: {force_unit}, {length_unit}, s", model, flags=re.M)
    (folder / "model.tcl").write_text(model)
    (folder / "study.toml").write_text(study)


def from_elsewhere(folder, factor):
    model, study = (folder / "model.tcl").read_text(), (folder / "study.toml").read_text()
    for name, lower, upper in re.findall(r'name\s*=\s*"(\w+)"\nlower\s*=\s*(\S+)\nupper\s*=\s*(\S+)', study):
        def moved(m):
            low, high = float(lower), float(upper)
            return m.group(1) + f"{min(max(factor * float(m.group(2)), low), high):.9g}"

        model = re.sub(rf"(pset\s+{name}\s+)([-+0-9.eE]+)", moved, model)
    (folder / "model.tcl").write_text(model)


def write(case, view, folder, quantities):
    if folder.exists():
        shutil.rmtree(folder)
    shutil.copytree(case, folder)
    files, channels = recordings(folder)
    for file in files:
        head, rows = table(file)
        if view.startswith("samples-"):
            rows = resampled(head, rows, channels, int(view.split("-")[1]))
        elif view == "cut":
            rows = rows[: int(SHORT * len(rows))]
        else:
            continue
        write_table(file, head, rows)
    if view in SYSTEMS:
        in_units(folder, view, quantities)
    elif view.startswith("start-"):
        from_elsewhere(folder, float(view.split("-")[1]))


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("cases", nargs="+", type=pathlib.Path, metavar="CASE")
    p.add_argument("--engine", default="hysteron")
    p.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/views"))
    p.add_argument("--view", action="append", choices=VIEWS)
    p.add_argument("--quantities")
    p.add_argument("--threads", default="1")
    a = p.parse_args()
    print(f"{'case':16} {'view':12} {'answer':40} {'%':>3} {'held out':>9} {'repaired':>9} {'s':>5}")
    for case in a.cases:
        for view in a.view or VIEWS:
            if view in SYSTEMS and not a.quantities:
                continue
            folder = a.out / case.name / view
            result, seconds = folder / "out/diagnosis.json", folder / "out/seconds.txt"
            if not result.exists():
                write(case, view, folder, a.quantities)
                began = time.time()
                words = [a.engine, "diagnose", folder / "study.toml", "--threads", a.threads, "--out", folder / "out"]
                done = subprocess.run(words, capture_output=True, text=True)
                if done.returncode:
                    print(f"{case.name:16} {view:12} {(done.stderr.strip().splitlines() or ['nothing said'])[0]}", flush=True)
                    continue
                seconds.write_text(f"{time.time() - began:.0f}\n")
            d = json.loads(result.read_text())
            v, base = d["verdict"], d["baseline"]
            after = d["corrected"] or base
            print(f"{case.name:16} {view:12} {' + '.join([v['cause'], *v['also']]):40} {100 * v['confidence']:3.0f} {base['holdout_nmse'] or 0:9.2g} "
                  f"{after['holdout_nmse'] or 0:9.2g} {seconds.read_text().strip():>5}", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
