"""A latent force: the residual as a Gaussian process over the state of the device (after Kennedy and O'Hagan 2001, and Alvarez, Luengo and Lawrence 2009).

The process is fitted over several sets of inputs: deformation, speed, time, work, simulated force and pairs of them. The set with the largest marginal likelihood
says on what the missing force depends, and so which causes are meant. `none` is white noise. It has no `unknown`: a process over time explains all.
"""

import numpy as np

from benchmark.residual import channel_runs
from benchmark.sparse_regression import Scales, work

# Samples of the fitted runs that the process is conditioned on.
SAMPLES = 400
LENGTHS = (0.1, 0.3, 1.0)
NOISES = (0.01, 0.1, 0.5)
# What a dependence on these inputs means.
MEANING = {
    ("deformation",): "strain_stiffening",
    ("speed",): "rate_dependence",
    ("time",): "sensor_drift",
    ("force",): "sensor_gain",
    ("deformation", "direction"): "friction",
    ("force", "work"): "cyclic_degradation",
    ("force", "largest"): "mullins_softening",
    ("force", "slope"): "sensor_lag",
    ("deformation", "across"): "bidirectional_coupling",
}


def inputs(run, channel, s):
    """{input: values between about -1 and 1}."""
    f = run.channels[channel][1]
    slope = np.gradient(f, run.time)
    out = {"time": (run.time - run.time[0]) / s.time, "force": f / s.force, "slope": slope * s.time / s.force / 30.0}
    if run.motions:
        x, v = run.motions[0]
        out |= {"deformation": x / s.motion[0], "speed": v / s.speed[0], "direction": np.tanh(v / s.speed[0] / 0.05)}
        out |= {"work": work(run, channel) / s.work, "largest": np.maximum.accumulate(np.abs(x / s.motion[0]))}
        if len(run.motions) > 1:
            out["across"] = run.motions[1][0] / s.motion[1]
    return out


def stacked(found, channel, s, names):
    return np.concatenate([np.array([inputs(r, channel, s)[n] for n in names]) for r in found], axis=1).T


def kernel(a, b, length):
    d = np.sum(((a[:, None, :] - b[None, :, :]) / length) ** 2, axis=2)
    return np.exp(-0.5 * d)


def fitted_process(x, r):
    """(log marginal likelihood, length, noise) with the largest likelihood; the variance is its own estimate."""
    best = (-np.inf, None, None)
    n = len(r)
    for length in LENGTHS:
        plain = kernel(x, x, length)
        for noise in NOISES:
            c = np.linalg.cholesky(plain + noise * np.eye(n))
            z = np.linalg.solve(c, r)
            value = -0.5 * n * np.log(z @ z / n) - np.sum(np.log(np.diag(c)))
            best = max(best, (float(value), length, noise))
    return best


def method(found, channel):
    """Shares of the causes, no further ones, and the prediction of the residual."""
    def training(name):
        fitted = channel_runs(found, name, "fit")
        s = Scales(fitted, name)
        r = np.concatenate([np.subtract(*run.channels[name]) for run in fitted])
        every = np.unique(np.linspace(0, len(r) - 1, SAMPLES).astype(int))
        every = every[np.isfinite(r[every])]
        return fitted, s, r[every], every

    fitted, s, r, every = training(channel)
    known = set.intersection(*(set(inputs(run, channel, s)) for run in fitted))
    n = len(r)
    likelihood = {"none": -0.5 * n * np.log(r @ r / n)}
    processes = {}
    for names, cause in MEANING.items():
        if known.issuperset(names):
            value, length, noise = fitted_process(stacked(fitted, channel, s, names)[every], r)
            likelihood[cause], processes[cause] = value - np.log(len(LENGTHS) * len(NOISES)), (names, length, noise)
    most = max(likelihood.values())
    weights = {c: np.exp(v - most) for c, v in likelihood.items()}
    total = sum(weights.values())
    shares = dict(sorted(((c, float(w / total)) for c, w in weights.items()), key=lambda kv: -kv[1]))
    cause = next(iter(shares))

    def predict(run, name):
        """The mean of the process of the first cause, conditioned on the fitted runs of the channel."""
        if cause == "none" or not channel_runs(found, name, "fit"):
            return np.zeros_like(run.time)
        names, length, noise = processes[cause]
        with_name, scales, target, kept = training(name)
        x = stacked(with_name, name, scales, names)[kept]
        alpha = np.linalg.solve(kernel(x, x, length) + noise * np.eye(len(kept)), target)
        return kernel(stacked([run], name, scales, names), x, length) @ alpha

    return shares, [], predict
