"""From a model with something concealed to a study folder with its truth."""

import json
import math
import os
import random

from . import signals
from .faults import FAULT
from .model import number

LEAST_NOISE, MOST_NOISE = 0.015, 0.1
STRONGEST = 1.0
WHOLE = ("bidirectional_coupling",)  # effects that are there or not: the noise makes them large or small


def decimated(x, n=250):
    step = max(1, len(x) // n)
    return x[::step]


class Case:
    """`effects` is a list of causes or of kinds of unknown; `ratio` is effect over noise: rms of what the analyst's parameters
    cannot take up (by their sensitivities) over rms of the noise, both over the standard deviation of the channel."""

    imperfections = None

    def __init__(self, model, truth, effects, ratio, rng):
        self.model, self.truth, self.effects, self.ratio, self.rng = model, truth, effects, ratio, rng
        self.seeds = [rng.randrange(1 << 30) for _ in effects]
        self.places = [model.place(e, rng) for e in effects]
        self.fit = [r for r in model.runs if r.role == "fit"]
        self.clean = {r.name: model.respond(r, model.parameters, []) for r in model.runs}
        self.tops = {c.name: max(signals.peak(self.clean[r.name][c.name]) for r in self.fit) for c in model.channels}
        self.basis = self.sensitivities()
        self.level = 10 ** rng.uniform(-1.75, -1.2)
        self.strengths = [0.0] * len(effects)
        self.achieved = [0.0] * len(effects)
        for i in range(len(effects)):
            self.choose_strength(i)
        if effects and ratio:
            most = max(self.achieved)
            if most < ratio * self.level or effects[0] in WHOLE:
                self.level = min(MOST_NOISE, max(LEAST_NOISE, most / ratio))

    # -------------------------------------------------------------- strength

    def response(self, run, strengths):
        """Channels of a run with the effects at these strengths."""
        inside = self.concealed(strengths)
        return self.faulty(run, self.model.respond(run, self.model.parameters, inside) if inside else self.clean[run.name], strengths)

    def recorded(self, run):
        """Channels of a run as they are recorded, without noise."""
        if not self.imperfections:
            return self.response(run, self.strengths)
        return self.faulty(run, self.imperfections.respond(run, self.concealed(self.strengths)), self.strengths)

    def concealed(self, strengths):
        m = self.model
        return [m.conceal(e, s, k, p) for e, s, k, p in zip(self.effects, strengths, self.seeds, self.places) if e not in FAULT and s > 0.0]

    def faulty(self, run, out, strengths):
        """Channels with the faults of sensors at these strengths."""
        out = {c: list(v) for c, v in out.items()}
        for e, s, seed, place in zip(self.effects, strengths, self.seeds, self.places):
            if e in FAULT and s > 0.0:
                fault = FAULT[e](seed, s, *place, run.seconds, self.model.slow)
                for channel in out:
                    if fault.hits(run.name, channel):
                        out[channel] = fault.apply(out[channel], run.every, self.tops[channel])
        return out

    def stacked(self, responses):
        """Fitted runs and channels one after the other, each of weight 1 over its clean variance."""
        out = []
        for r in self.fit:
            for c in self.model.channels:
                clean = decimated(self.clean[r.name][c.name])
                w = 1.0 / math.sqrt(signals.variance(clean) * len(clean) * len(self.fit) * len(self.model.channels))
                out += [v * w for v in decimated(responses[r.name][c.name])]
        return out

    def sensitivities(self):
        """An orthonormal basis of the responses to small changes of the analyst's parameters."""
        m = self.model
        zero = self.stacked(self.clean)
        basis = []
        for name, value in m.parameters.items():
            moved = dict(m.parameters)
            moved[name] = value * 1.01
            col = self.stacked({r.name: m.respond(r, moved, []) for r in self.fit})
            col = [a - b for a, b in zip(col, zero)]
            for b in basis:
                dot = sum(x * y for x, y in zip(col, b))
                col = [x - dot * y for x, y in zip(col, b)]
            norm = math.sqrt(sum(x * x for x in col))
            if norm > 1e-9:
                basis.append([x / norm for x in col])
        return basis

    def residual(self, strengths):
        """The part of the effects that no small change of the parameters gives, stacked."""
        r = self.stacked({r.name: self.response(r, strengths) for r in self.fit})
        return self.off_parameters(r, self.stacked(self.clean))

    def off_parameters(self, r, zero):
        """The part of a stacked response that no small change of the parameters gives from another one."""
        r = [a - b for a, b in zip(r, zero)]
        for b in self.basis:
            dot = sum(x * y for x, y in zip(r, b))
            r = [x - dot * y for x, y in zip(r, b)]
        return r

    def size(self, i, s):
        strengths = [s if j == i else 0.0 for j in range(len(self.effects))]
        return math.sqrt(sum(x * x for x in self.residual(strengths)))

    def choose_strength(self, i):
        """By false position on the logarithms, as the effect grows with its strength to a power of about one."""
        if self.effects[i] in WHOLE:
            self.strengths[i], self.achieved[i] = STRONGEST, self.size(i, STRONGEST)
            return
        target = self.ratio * self.level * (1.0 if i == 0 else self.rng.uniform(0.6, 1.0))
        low, high = 0.02, STRONGEST
        top = self.size(i, high)
        s, got = high, top
        if top > target:
            s = high * max(0.02, target / top)
            for _ in range(5):
                got = self.size(i, s)
                if abs(math.log(max(got, 1e-12) / target)) < 0.08:
                    break
                low, high = (s, high) if got < target else (low, s)
                guess = s * target / max(got, 1e-12)
                s = guess if low < guess < high else math.sqrt(low * high)
        self.strengths[i], self.achieved[i] = s, got

    # -------------------------------------------------------------- where

    def where(self):
        """Run and channel of the largest share of the unfitted effect, those that hold a fair part of it, and windows if it is local."""
        r = self.residual(self.strengths)
        shares, spans, at = {}, {}, 0
        for run in self.fit:
            for c in self.model.channels:
                n = len(decimated(self.clean[run.name][c.name]))
                part = r[at:at + n]
                at += n
                shares[run.name, c.name] = sum(x * x for x in part)
                spans[run.name, c.name] = [x * x for x in part]
        (run, channel), top = max(shares.items(), key=lambda kv: kv[1])
        runs = sorted({a for (a, _), v in shares.items() if v > 0.2 * top})
        channels = sorted({b for (_, b), v in shares.items() if v > 0.2 * top})
        place = self.places[0]
        where = {"run": run, "channel": channel, "accept_runs": runs, "accept_channels": channels}
        if isinstance(place, str):
            where["at"] = place
        seconds = next(x.seconds for x in self.fit if x.name == run)
        windows = local(spans[run, channel], seconds)
        if windows:
            where["windows"] = windows
        return where

    # -------------------------------------------------------------- files

    def write(self, folder):
        os.makedirs(folder, exist_ok=True)
        m, rng = self.model, self.rng
        kind = rng.choice(signals.NOISES)
        each = {c.name: rng.uniform(0.7, 1.4) for c in m.channels}
        floors = {"fit": [], "holdout": []}
        for run in m.runs:
            response = self.recorded(run)
            step = run.dt * rng.uniform(1.05, 1.6)
            if run.seconds / step > 1500:
                step = run.seconds / 1500
            t, times = rng.uniform(0.2, 0.9) * run.dt, []
            while t < run.seconds:
                times.append(t)
                t += step
            columns = [("time[s]", [f"{x:.6g}" for x in times])]
            for c in m.channels:
                x = response[c.name]
                true = [sample(x, run.every, t) for t in times]
                var = signals.variance(true)
                size = self.level * each[c.name] * math.sqrt(var)
                if self.imperfections:
                    noise = self.imperfections.noise_of(kind, true, step, size)
                else:
                    noise = [size * v for v in signals.noise(rng, kind, len(times), step)]
                floors[run.role].append(sum(v * v for v in noise) / len(noise) / var)
                values = [f"{a + b:.6g}" for a, b in zip(true, noise)]
                if rng.random() < 0.2:
                    values[rng.randrange(len(values))] = ""
                columns.append((f"{c.name}[{c.unit}]", values))
            columns += m.context(run, times, rng)
            with open(os.path.join(folder, run.name + ".csv"), "w") as f:
                f.write(",".join(h for h, _ in columns) + "\n")
                f.writelines(",".join(row) + "\n" for row in zip(*(v for _, v in columns)))
            for name, values in m.settings(run)[1].items():
                with open(os.path.join(folder, name), "w") as f:
                    f.writelines(f"{v:.9g}\n" for v in values)
        bounds = {}
        script = m.script
        for name, value in m.parameters.items():
            low, high = value * rng.uniform(0.4, 0.7), value * rng.uniform(1.4, 2.3)
            bounds[name] = (low, high)
            script = script.replace(f"@{name}@", number(value * rng.uniform(0.75, 1.3)))
        with open(os.path.join(folder, "model.tcl"), "w") as f:
            f.write(script)
        with open(os.path.join(folder, "study.toml"), "w") as f:
            f.write(self.study(bounds))
        mean = {k: sum(v) / len(v) for k, v in floors.items()}
        truth = {
            "cause": self.truth[0],
            "also": list(self.truth[1:]),
            "where": self.where() if self.effects else {},
            "kinds": self.effects,
            "strengths": [float(number(s)) for s in self.strengths],
            "effect_over_noise": [float(f"{a / self.level:.4g}") for a in self.achieved],
            "noise": kind,
            "noise_floor_nmse_fit": mean["fit"],
            "noise_floor_nmse_holdout": mean["holdout"],
            "underlying_parameters": {k: float(number(v)) for k, v in m.parameters.items()},
            "family": m.family,
        }
        if self.imperfections:
            truth["imperfections"] = self.imperfections.said
            # The small effect is there. Its name is no invention.
            truth["accept_as_arguable"] = [kind for kind, *_ in self.imperfections.shape]
        with open(os.path.join(folder, "truth.json"), "w") as f:
            json.dump(truth, f, indent=1)
            f.write("\n")
        return truth

    def study(self, bounds):
        m = self.model
        out = [f'title = "{m.title}"', 'model = "model.tcl"', ""]
        for name, (low, high) in bounds.items():
            out += ["[[parameter]]", f'name  = "{name}"', f"lower = {low:.6g}", f"upper = {high:.6g}", ""]
        for run in m.runs:
            values = ", ".join(f"{k} = {json.dumps(v)}" for k, v in m.settings(run)[0].items())
            out += ["[[run]]", f'name      = "{run.name}"', f'role      = "{run.role}"', f'recording = "{run.name}.csv"', f"set       = {{ {values} }}", ""]
            for c in m.channels:
                out += ["[[run.observe]]", f'channel = "{c.name}"', f'output  = "{c.output}"', f"column  = {c.column}", f'at      = "{c.at}"', ""]
        return "\n".join(out)


def sample(x, dt, t):
    i = min(int(t / dt), len(x) - 2)
    return x[i] + (x[i + 1] - x[i]) * (t / dt - i)


def local(squares, seconds):
    """The fewest spans that hold 80 % of the squares, if they are less than 40 % of the time."""
    bins = 120
    n = len(squares)
    sums = [0.0] * bins
    for i, v in enumerate(squares):
        sums[min(bins - 1, i * bins // n)] += v
    total, held, chosen = sum(sums), 0.0, set()
    for b in sorted(range(bins), key=lambda b: -sums[b]):
        if held >= 0.8 * total:
            break
        chosen.add(b)
        held += sums[b]
    spans = []
    for b in sorted(chosen):
        if spans and b - spans[-1][1] <= 3:
            spans[-1][1] = b + 1
        else:
            spans.append([b, b + 1])
    w = seconds / bins
    if sum(b - a for a, b in spans) > 0.4 * bins:
        return None
    return [[float(f"{a * w:.4g}"), float(f"{b * w:.4g}")] for a, b in spans]
