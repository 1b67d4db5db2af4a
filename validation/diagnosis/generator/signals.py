"""Motions, ground motions and noise, from a seeded `random.Random`."""

import bisect
import math


def interpolate(times, values, at):
    """Linear interpolation, constant beyond the ends."""
    i = bisect.bisect_right(times, at)
    if i <= 0:
        return values[0]
    if i >= len(times):
        return values[-1]
    t0, t1 = times[i - 1], times[i]
    return values[i - 1] + (values[i] - values[i - 1]) * (at - t0) / (t1 - t0)


def interpolate_even(x, at):
    """Linear interpolation between samples, constant beyond the ends."""
    if at <= 0.0:
        return x[0]
    i = min(int(at), len(x) - 2)
    return x[i] + (x[i + 1] - x[i]) * min(1.0, at - i)


def peak(x):
    return max(abs(v) for v in x)


def variance(x):
    mean = sum(x) / len(x)
    return sum((v - mean) ** 2 for v in x) / len(x)


def scaled(x, to):
    top = peak(x)
    return [v * to / top for v in x]


# ------------------------------------------------------------------ imposed motions


def cycles(amplitudes, frequency, dt, rest=0.3, pause=None):
    """One sine a value of `amplitudes`, after `rest` seconds; `pause` = (after this cycle, seconds). The size changes smoothly,
    so that the speed does not jump."""
    per = max(8, round(1.0 / frequency / dt))
    quiet = [0.0] * max(2, round(rest / dt))
    blocks = [amplitudes[: pause[0]], amplitudes[pause[0]:]] if pause else [amplitudes]
    out = list(quiet)
    for b, block in enumerate(blocks):
        for i, a in enumerate(block):
            before = block[i - 1] if i else 0.0
            after = a if i + 1 < len(block) else 0.0
            for j in range(1, per + 1):
                s = j / per
                rise, fall = smooth(4.0 * s), smooth(4.0 * s - 3.0)
                size = before + (a - before) * rise + (after - a) * fall
                out.append(size * math.sin(2 * math.pi * s))
        if b + 1 < len(blocks):
            out += [0.0] * round(pause[1] / dt)
    return out + quiet


def smooth(x):
    x = min(1.0, max(0.0, x))
    return x * x * (3.0 - 2.0 * x)


def sweep(amplitude, f0, f1, seconds, dt):
    """A sine whose frequency grows from f0 to f1, faded in and out."""
    out, phase, n = [], 0.0, round(seconds / dt)
    for i in range(n + 1):
        s = i / n
        out.append(amplitude * math.sin(phase) * fade(s))
        phase += 2 * math.pi * f0 * (f1 / f0) ** s * dt
    return out


def fade(s):
    """1 in the middle of 0..1, 0 at its ends."""
    edge = 0.1
    x = min(s, 1.0 - s) / edge
    return 1.0 if x >= 1.0 else 0.5 - 0.5 * math.cos(math.pi * max(x, 0.0))


def wander(rng, amplitude, f0, f1, seconds, dt, slope=1.0):
    """Sines of random phase between f0 and f1 whose size falls with frequency^slope: a seismic stroke of an isolator."""
    tones = []
    for i in range(14):
        f = f0 * (f1 / f0) ** ((i + rng.random()) / 14)
        tones.append((f, (f0 / f) ** slope * rng.uniform(0.5, 1.5), rng.uniform(0, 2 * math.pi)))
    n = round(seconds / dt)
    out = [fade(i / n) * sum(a * math.sin(2 * math.pi * f * i * dt + p) for f, a, p in tones) for i in range(n + 1)]
    return scaled(out, amplitude)


def quake(rng, pga, seconds, dt):
    """White noise through the ground of Kanai and Tajimi, the high pass of Clough and Penzien, and an envelope."""
    wg, zg = 2 * math.pi * rng.uniform(1.2, 2.5), rng.uniform(0.4, 0.7)
    wf, zf = 2 * math.pi * rng.uniform(0.2, 0.35), 0.6
    rise, fall = 0.12 * seconds, 0.55 * seconds
    xg = vg = xf = vf = 0.0
    out = []
    for i in range(round(seconds / dt)):
        t = i * dt
        window = (t / rise) ** 2 if t < rise else 1.0 if t < fall else math.exp(-5 * (t - fall) / seconds)
        ag = -2 * zg * wg * vg - wg * wg * xg - rng.gauss(0, 1) * window
        vg += ag * dt
        xg += vg * dt
        filtered = -2 * zg * wg * vg - wg * wg * xg
        af = -2 * zf * wf * vf - wf * wf * xf - filtered
        vf += af * dt
        xf += vf * dt
        out.append(-2 * zf * wf * vf - wf * wf * xf - filtered)
    out = scaled(out, pga)
    return [v * min(1.0, i * dt / 0.3) for i, v in enumerate(out)]


# ------------------------------------------------------------------ noise


def coloured(rng, n, dt, tau):
    """First-order noise of correlation time tau and variance 1."""
    a = math.exp(-dt / tau)
    x, out = rng.gauss(0, 1), []
    for _ in range(n):
        x = a * x + math.sqrt(1 - a * a) * rng.gauss(0, 1)
        out.append(x)
    return out


def pink(rng, n, dt, slow=0.5):
    """A sum of first-order noises an octave apart; `slow` > 0.5 makes the long ones stronger: it tempts to call a drift."""
    out = [0.0] * n
    tau = dt
    octaves = []
    while tau < n * dt:
        octaves.append(tau)
        tau *= 2.0
    for k, tau in enumerate(octaves):
        size = 2.0 ** ((slow - 0.5) * k)
        for i, v in enumerate(coloured(rng, n, dt, tau)):
            out[i] += size * v
    return out


NOISES = ("white", "coloured", "pink", "slow_pink", "coloured_and_white")


def noise(rng, kind, n, dt):
    """Noise of the kind, of mean square 1."""
    if kind == "white":
        out = [rng.gauss(0, 1) for _ in range(n)]
    elif kind == "coloured":
        out = coloured(rng, n, dt, rng.uniform(0.02, 0.15))
    elif kind == "pink":
        out = pink(rng, n, dt)
    elif kind == "slow_pink":
        out = pink(rng, n, dt, slow=0.8)
    else:
        tau = rng.uniform(0.1, 0.5)
        out = [a + rng.gauss(0, 0.7) for a in coloured(rng, n, dt, tau)]
    rms = math.sqrt(sum(v * v for v in out) / n)
    return [v / rms for v in out]
