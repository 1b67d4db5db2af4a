"""Sparse regression of the residual on terms that stand for the causes of the library.

Each cause has one or a few terms: functions of the deformation, the speed, the simulated force, the work done and time, on grids of their inner
parameters. The first term is the one with the least squared error; terms are added as long as Schwarz' criterion falls, three at most. The causes'
probabilities are those of Schwarz' weights among single terms, `none` being no term. A residual of which less than half is explained is `unknown`.
A second cause is named where its term halves what the terms before it leave.
"""

import numpy as np

from benchmark.residual import channel_runs, independent_samples

MOST_TERMS = 3
EXPLAINED = 0.5
# Fractions of the largest value on which inner parameters lie.
GRID = (0.2, 0.4, 0.6, 0.8)


class Scales:
    """Largest values over the fitted runs, so that terms mean the same in every run."""

    def __init__(self, fitted, channel):
        self.force = max(np.nanmax(abs(r.channels[channel][1])) for r in fitted) or 1.0
        self.time = max(np.ptp(r.time) for r in fitted)
        self.motion = [max(np.nanmax(abs(r.motions[i][0])) for r in fitted) or 1.0 for i in range(min(len(r.motions) for r in fitted))]
        self.speed = [max(np.nanmax(abs(r.motions[i][1])) for r in fitted) or 1.0 for i in range(len(self.motion))]
        self.work = max((work(r, channel)[-1] for r in fitted if r.motions), default=1.0) or 1.0


def work(run, channel):
    """Work of the simulated force, which only grows."""
    f, (x, _) = run.channels[channel][1], run.motions[0]
    return np.concatenate(([0.0], np.cumsum(np.abs(0.5 * (f[1:] + f[:-1]) * np.diff(x)))))


def heat(power, time, decay):
    """Response of a first-order loss of heat to a power."""
    out = np.zeros_like(power)
    for i in range(1, len(power)):
        dt = time[i] - time[i - 1]
        out[i] = (out[i - 1] + power[i] * dt) * np.exp(-dt / decay)
    return out


def sensor_terms(run, channel, s):
    f = run.channels[channel][1]
    t = (run.time - run.time[0]) / s.time
    yield "sensor_gain", ("gain",), f
    yield "sensor_lag", ("lag",), np.gradient(f, run.time) * s.time
    yield "sensor_drift", ("offset",), s.force * np.ones_like(f)
    yield "sensor_drift", ("drift",), s.force * t
    for g in GRID:
        yield "sensor_clipping", ("level", g), np.clip(f, -g * s.force, g * s.force) - f


def motion_terms(run, channel, s):
    f, (x, v), t = run.channels[channel][1], run.motions[0], run.time
    u, w = x / s.motion[0], v / s.speed[0]
    largest = np.maximum.accumulate(np.abs(u))
    done = work(run, channel) / s.work
    yield "friction", ("sign",), s.force * np.tanh(w / 0.02)
    yield "damping", ("dashpot",), s.force * w
    for power in (0.2, 0.5):
        yield "rate_dependence", ("overstress", power), s.force * np.sign(w) * np.abs(w) ** power
        yield "rate_dependence", ("factor", power), f * np.abs(w) ** power
    for power in (3, 5):
        yield "strain_stiffening", ("power", power), s.force * u**power
    for rest in (0.3, 1.0):
        yield "cyclic_degradation", ("work", rest), f * (1.0 - np.exp(-done / rest))
        yield "mullins_softening", ("virgin", rest), f * np.exp(-largest / rest)
        yield "mullins_softening", ("below", rest), f * (1.0 - np.exp(-(largest - np.abs(u)) / rest))
    for decay in (0.1, 0.5):
        yield "self_heating", ("heat", decay), f * heat(np.abs(f * v), t, decay * s.time) / s.work
    for g in (0.1, 0.3):
        yield "pinching", ("zero", g), f * np.exp(-((u / g) ** 2))
    for g in GRID:
        for side in (1, -1):
            yield "gap_impact", ("gap", g, side), s.force * side * np.maximum(side * u - g, 0.0)
        yield "superstructure_yielding", ("limit", g), f - np.clip(f, -g * s.force, g * s.force)
    if len(run.motions) > 1:
        other = run.motions[1][0] / s.motion[1]
        yield "bidirectional_coupling", ("orbit",), f * np.abs(other)
        yield "axial_shear_interaction", ("load",), x * other
    if run.temperature is not None:
        yield "ambient_temperature", ("temperature",), f * run.temperature / 20.0


def terms(run, channel, s):
    """{(cause, detail): values} at the samples of a run."""
    out = {(cause, detail): y for cause, detail, y in sensor_terms(run, channel, s)}
    if run.motions:
        out |= {(cause, detail): y for cause, detail, y in motion_terms(run, channel, s)}
    return out


def design(found, channel, s):
    """Terms that all runs have, as columns, and the residual."""
    tables = [terms(r, channel, s) for r in found]
    names = [k for k in tables[0] if all(k in t for t in tables)]
    matrix = np.array([np.concatenate([t[k] for t in tables]) for k in names])
    residual = np.concatenate([np.subtract(*r.channels[channel]) for r in found])
    keep = np.isfinite(residual) & np.isfinite(matrix).all(axis=0)
    return names, matrix[:, keep].T, residual[keep]


def selected(matrix, residual):
    """Columns of the greedy selection with the error that each leaves, the weights of single columns and of none, and the share that is left."""
    n = None

    def score(cols):
        nonlocal n
        a = matrix[:, cols]
        left = residual - a @ np.linalg.lstsq(a, residual, rcond=None)[0] if cols else residual
        return float(left @ left) / len(left), left

    error, _ = score([])
    single = np.array([score([i])[0] for i in range(matrix.shape[1])])
    _, left = score([int(np.argmin(single))])
    n = independent_samples(left)
    chosen, after, best = [], [], n * np.log(error)
    while len(chosen) < MOST_TERMS:
        rest = [i for i in range(matrix.shape[1]) if i not in chosen]
        errors = [score(chosen + [i])[0] for i in rest]
        now = n * np.log(min(errors)) + (len(chosen) + 1) * np.log(n)
        if now >= best:
            break
        chosen.append(rest[int(np.argmin(errors))])
        after.append(min(errors))
        best = now
    weights = -0.5 * np.concatenate((n * np.log(single) + np.log(n), [n * np.log(error)]))
    return chosen, after, np.exp(weights - weights.max()), score(chosen)[0] / error


def method(found, channel):
    """Shares of the causes, further causes and the prediction of the residual."""
    fitted = channel_runs(found, channel, "fit")
    names, matrix, residual = design(fitted, channel, Scales(fitted, channel))
    chosen, after, weights, left = selected(matrix, residual)
    shares = {}
    for (cause, _), w in zip([*names, ("none", ())], weights / weights.sum()):
        shares[cause] = shares.get(cause, 0.0) + float(w)
    if not chosen:
        shares = {"none": shares["none"], **{c: p for c, p in shares.items() if c != "none"}}
    elif 1.0 - left < EXPLAINED:
        shares = {"unknown": 1.0 - EXPLAINED, **{c: EXPLAINED * p for c, p in shares.items()}}
    else:
        shares = dict(sorted(shares.items(), key=lambda kv: -kv[1]))
    kept = [names[i] for i in chosen]
    first = next(iter(shares))
    halving = [names[i][0] for i, now, before in zip(chosen[1:], after[1:], after) if now < 0.5 * before]
    also = [] if first in ("none", "unknown") else sorted(set(halving) - {first})

    def predict(run, name):
        """The kept terms, with coefficients of the runs in which the channel was fitted."""
        training = channel_runs(found, name, "fit")
        if not kept or not training:
            return np.zeros_like(run.time)
        s = Scales(training, name)
        known, a, r = design(training, name, s)
        cols = [known.index(k) for k in kept if k in known]
        beta = np.linalg.lstsq(a[:, cols], r, rcond=None)[0]
        values = terms(run, name, s)
        return sum(b * values[known[c]] for b, c in zip(beta, cols) if known[c] in values)

    return shares, also, predict
