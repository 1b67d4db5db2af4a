"""Residuals of the calibrated baseline, and the motion that belongs to them, for methods that see no hypothesis of hysteron.

Recorded and simulated channels are those of `channels/*.csv` of an answer; the simulated ones are the analyst's model with its parameters calibrated.
"""

import csv
import glob
import os
import re
import tomllib

import numpy as np

# Units of a deformation, as written in heads of columns.
LENGTHS = ("m", "mm", "cm", "in", "ft", "1", "%", "-", "")


class Run:
    """A run: time, channels {name: (recorded, simulated)} and the deformation and speed of the device, by direction."""

    def __init__(self, name, role, time, channels, motions, temperature):
        self.name, self.role, self.time, self.channels, self.temperature = name, role, time, channels, temperature
        self.motions = [(x, np.gradient(x, time)) for x in motions]


def columns(path):
    """{head: values} of a CSV file; comment lines are left out."""
    with open(path, newline="") as f:
        rows = [row for row in csv.reader(f) if row and not row[0].startswith("#")]
    values = np.array([[float(x) if x else np.nan for x in row] for row in rows[1:]])
    return dict(zip(rows[0], values.T))


def imposed(folder, run, time):
    """Imposed motions of a run, at the times of its recording."""
    settings, out = run.get("set", {}), []
    for key in sorted(settings):
        value = settings[key]
        if isinstance(value, str) and os.path.exists(os.path.join(folder, value)) and "dt" in settings:
            x = np.array(open(os.path.join(folder, value)).read().split(), float)
            out.append(np.interp(time, settings["dt"] * np.arange(len(x)), x))
    return out


def runs(folder, answer_folder):
    """Runs of a case whose channels an answer has."""
    with open(os.path.join(folder, "study.toml"), "rb") as f:
        study = tomllib.load(f)
    with open(os.path.join(folder, study["model"])) as f:
        shaken = "UniformExcitation" in f.read()
    out = []
    for run in study["run"]:
        path = os.path.join(answer_folder, "channels", run["name"] + ".csv")
        if not os.path.exists(path):
            continue
        table = columns(path)
        time = next(iter(table.values()))
        channels, lengths = {}, []
        for head, recorded in table.items():
            name, unit = re.fullmatch(r"([^\[]*)(?:\[(.*)\])?", head).groups()
            if name.endswith("_recorded"):
                simulated = table[head.replace("_recorded", "_simulated")]
                channels[name.removesuffix("_recorded")] = (recorded, simulated)
                if unit in LENGTHS:
                    lengths.append(simulated)
        temperature = next((v for k, v in run.get("set", {}).items() if k.lower() in ("t", "temp", "temperature")), None)
        motions = lengths[:1] if shaken else imposed(folder, run, time)
        out.append(Run(run["name"], run["role"], time, channels, motions, temperature))
    return out


def channel_runs(found, channel, role):
    return [r for r in found if r.role == role and channel in r.channels]


def nmse(recorded, predicted):
    keep = np.isfinite(recorded) & np.isfinite(predicted)
    scale = np.sum((recorded[keep] - np.mean(recorded[keep])) ** 2)
    return float(np.sum((recorded[keep] - predicted[keep]) ** 2) / scale) if scale > 0 else 0.0


def worst_channel(found):
    """(run, channel) among the fitted with the largest error."""
    errors = [(nmse(*c), r.name, name) for r in found if r.role == "fit" for name, c in r.channels.items()]
    return max(errors)[1:]


def independent_samples(residual):
    """Number of samples that count, from the correlation of neighbours."""
    z = residual - residual.mean()
    power = float(z @ z)
    rho = float(z[1:] @ z[:-1]) / power if power > 0 else 0.0
    return max(10.0, len(z) * (1.0 - rho) / (1.0 + max(rho, 0.0)))


def answers(folder, answer_folder, method):
    """An answer in the form of `diagnosis.json`. `method(runs, channel)` gives {cause: probability}, most probable first, further causes, and `predict(run, channel)`."""
    found = runs(folder, answer_folder)
    run, channel = worst_channel(found)
    shares, also, predict = method(found, channel)
    held = [(r, name) for r in found if r.role == "holdout" for name in r.channels]

    def mean(of):
        return float(np.mean([of(r, name) for r, name in held])) if held else None

    before = mean(lambda r, name: nmse(*r.channels[name]))
    after = mean(lambda r, name: nmse(r.channels[name][0], r.channels[name][1] + predict(r, name)))
    (cause, p), *others = shares.items()
    verdict = {"cause": cause, "also": also, "confidence": p, "also_possible": [{"cause": c, "confidence": q} for c, q in others]}
    return {
        "verdict": verdict,
        "mismatch": [{"run": run, "channel": channel}],
        "baseline": {"holdout_nmse": before},
        "corrected": None if before is None or cause == "none" else {"holdout_nmse": after},
    }
