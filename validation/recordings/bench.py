"""Shared by all recordings: reading and writing of tables, errors of a model, pictures. Standard library only."""
import csv
import math
import re
import subprocess
from pathlib import Path


def columns(path):
    """The columns of a table, as lists of numbers; empty cells and words are nan."""
    def number(x):
        try:
            return float(x)
        except ValueError:
            return math.nan

    with Path(path).open() as f:
        rows = list(csv.DictReader(f))
    return {name: [number(r[name]) for r in rows] for name in rows[0]}


def resample(t, x, times):
    """Linear interpolation at increasing times."""
    out, j = [], 0
    for s in times:
        while j + 2 < len(t) and t[j + 1] < s:
            j += 1
        w = (s - t[j]) / (t[j + 1] - t[j])
        out.append(x[j] + min(max(w, 0.0), 1.0) * (x[j + 1] - x[j]))
    return out


def write(folder, name, motion, dt, channels):
    """`name.dat` (the motion, a value a line) and `name.csv` (the recording); channels: {"force[kN]": values}."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{name}.dat").write_text("".join(f"{x:.6g}\n" for x in motion))
    heads, values = list(channels), list(channels.values())
    with (folder / f"{name}.csv").open("w") as f:
        f.write(",".join(["time[s]", *heads]) + "\n")
        for i in range(len(motion)):
            f.write(",".join([f"{i * dt:.9g}", *(f"{v[i]:.6g}" for v in values)]) + "\n")


def with_values(script, values):
    """The script with other values behind its `pset` commands."""
    for name, value in values.items():
        script = re.sub(rf"^(\s*pset\s+{re.escape(name)}\s+)\S+", rf"\g<1>{value!r}", script, flags=re.M)
    return script


def simulate(engine, folder, script, run):
    """Runs a script as one run of a study; {channel: (times, values)} and {channel: (times, recorded)}."""
    sets = "".join(f"set {k} {{{v}}}\n" for k, v in run["set"].items())
    wrapper = folder / "_run.tcl"
    wrapper.write_text(sets + script)
    done = subprocess.run([engine, "run", wrapper.name], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        return None
    recording = columns(folder / run["recording"])
    time = recording[next(iter(recording))]
    result = {}
    for seen in run["observe"]:
        rows = [[float(x) for x in line.split()] for line in (folder / seen["output"]).read_text().splitlines()]
        t, y = [0.0] + [r[0] for r in rows], [r[seen["column"]] for r in rows]
        y = [0.0 if rows[0][0] > 0 else y[0]] + y
        column = next(c for c in recording if c.split("[")[0] == seen["channel"])
        result[seen["channel"]] = (time, recording[column], resample(t, y, time))
    return result


def corrected_channel(time, simulated, correction):
    """A simulated channel as the faulty sensor shows it: lag, gain and offset, drift, clip."""
    lag = correction.get("lag_s") or 0.0
    y = resample(time, simulated, [t - lag for t in time]) if lag else list(simulated)
    gain, offset = correction.get("gain"), correction.get("offset")
    y = [(1.0 if gain is None else gain) * v + (offset or 0.0) for v in y]
    if drift := correction.get("drift"):
        d = resample([p[0] for p in drift], [p[1] for p in drift], time) if len(drift) > 1 else [drift[0][1]] * len(time)
        y = [v + w for v, w in zip(y, d)]
    if clip := correction.get("clip"):
        low, high = (-math.inf if clip[0] is None else clip[0]), (math.inf if clip[1] is None else clip[1])
        y = [min(max(v, low), high) for v in y]
    return y


def nmse(recorded, simulated):
    pairs = [(a, b) for a, b in zip(recorded, simulated) if not math.isnan(a)]
    mean = sum(a for a, _ in pairs) / len(pairs)
    return sum((a - b) ** 2 for a, b in pairs) / sum((a - mean) ** 2 for a, _ in pairs)


COLOURS = {"recorded": "#222222", "before": "#d95f02", "after": "#1b7fb5"}


def _path(points):
    """A path through points in tenths of the picture's unit, by differences, which take half of the place; what is not a number is passed over."""
    points = [(round(10 * u), round(10 * v)) for u, v in points if not (math.isnan(u) or math.isnan(v))]
    if not points:
        return ""
    steps = [f"{b[0] - a[0]} {b[1] - a[1]}".replace(" -", "-") for a, b in zip(points, points[1:])]
    return "M{} {}l".format(*points[0]) + " ".join(steps).replace(" -", "-")


def _panel(x0, y0, width, height, title, labels, curves):
    """A plot of {name: (xs, ys)}: axes with their ends, curves thinned to about 900 points."""
    xs = [v for c in curves.values() for v in c[0]]
    ys = [v for c in curves.values() for v in c[1]]
    lo_x, hi_x, lo_y, hi_y = min(xs), max(xs), min(ys), max(ys)
    sx, sy = width / ((hi_x - lo_x) or 1.0), height / ((hi_y - lo_y) or 1.0)
    text = [f'<rect x="{x0}" y="{y0}" width="{width}" height="{height}" fill="none" stroke="#999"/>']
    for name, (a, b) in curves.items():
        step = max(1, len(a) // 900)
        d = _path((x0 + (u - lo_x) * sx, y0 + height - (v - lo_y) * sy) for u, v in zip(a[::step], b[::step]))
        text.append(f'<path transform="scale(.1)" d="{d}" fill="none" stroke="{COLOURS[name]}" stroke-width="{16 if name == "recorded" else 11}"/>')

    def end(v, low, high):
        return f"{0.0 if abs(v) < 1e-6 * (high - low) else v:.3g}"

    label = '<text x="{:.0f}" y="{:.0f}" text-anchor="{}" font-size="12">{}</text>'
    text += [label.format(x0, y0 - 8, "start", title),
             label.format(x0, y0 + height + 15, "start", end(lo_x, lo_x, hi_x)), label.format(x0 + width, y0 + height + 15, "end", end(hi_x, lo_x, hi_x)),
             label.format(x0 + width / 2, y0 + height + 15, "middle", labels[0]),
             label.format(x0 - 5, y0 + height, "end", end(lo_y, lo_y, hi_y)), label.format(x0 - 5, y0 + 11, "end", end(hi_y, lo_y, hi_y)),
             label.format(x0 - 5, y0 + height / 2, "end", labels[1])]
    return "\n".join(text)


def picture(path, panels, columns=2):
    """Panels (title, (x label, y label), {"recorded" | "before" | "after": (xs, ys)}) in a grid."""
    width, height, left, top = 380, 210, 75, 50
    rows = -(-len(panels) // columns)
    body = []
    for i, (title, labels, curves) in enumerate(panels):
        x0, y0 = left + (i % columns) * (width + left), top + (i // columns) * (height + top + 15)
        body.append(_panel(x0, y0, width, height, title, labels, curves))
    legend = " ".join(f'<text x="{left + 90 * k}" y="18" font-size="13" fill="{c}">{n}</text>' for k, (n, c) in enumerate(COLOURS.items()))
    w, h = columns * (width + left) + 25, rows * (height + top + 15) + 15
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" font-family="sans-serif">'
                    f'<rect width="{w}" height="{h}" fill="#fff"/>\n{legend}\n' + "\n".join(body) + "\n</svg>\n")
