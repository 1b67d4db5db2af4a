"""Faults of a channel: a recording y(t) of the true response x(t) on an even grid."""

import math
import random

from .signals import peak


class Fault:
    """Strength s from 0 to about 1; `run` None means all runs. Drawn from a seed as effects are."""

    def __init__(self, seed, s, channel, run, seconds, slow):
        self.s, self.channel, self.run, self.seconds, self.slow = s, channel, run, seconds, slow
        self.draw(random.Random(seed))

    def hits(self, run, channel):
        return channel == self.channel and (self.run is None or run == self.run)

    def draw(self, rng):
        pass


class Gain(Fault):
    def draw(self, rng):
        self.g = 1.0 + self.s * rng.choice((-0.5, 0.6))

    def apply(self, x, dt, top):
        return [self.g * v for v in x]


class Lag(Fault):
    """Late by a share of the slowest thing that matters: the period `slow`."""

    def draw(self, rng):
        self.lag = self.s * rng.uniform(0.06, 0.1) * self.slow

    def apply(self, x, dt, top):
        shift = self.lag / dt
        whole = int(shift)
        part = shift - whole
        out = []
        for i in range(len(x)):
            a = x[max(0, i - whole)]
            b = x[max(0, i - whole - 1)]
            out.append(a + (b - a) * part)
        return out


class Drift(Fault):
    """The zero jumps, ramps, or warms up."""

    def draw(self, rng):
        self.kind = rng.choice(("jump", "ramp", "warm", "jump and ramp"))
        self.at = rng.uniform(0.3, 0.6)
        self.size = self.s * 0.35 * rng.choice((-1.0, 1.0))

    def apply(self, x, dt, top):
        out = []
        for i, v in enumerate(x):
            a = i * dt / self.seconds
            if self.kind == "jump":
                d = 1.0 if a > self.at else 0.0
            elif self.kind == "ramp":
                d = a
            elif self.kind == "warm":
                d = 1.0 - math.exp(-a / 0.3)
            else:
                d = (0.6 if a > self.at else 0.0) + 0.4 * a
            out.append(v + self.size * top * d)
        return out


class Clip(Fault):
    def draw(self, rng):
        self.level = 1.0 - 0.65 * self.s

    def apply(self, x, dt, top):
        level = self.level * top
        return [max(-level, min(level, v)) for v in x]


class Hum(Fault):
    """Unknown: mains hum that follows a machine's duty cycle."""

    def draw(self, rng):
        self.f, self.on, self.phase = rng.uniform(9.0, 16.0), rng.uniform(0.8, 2.0), rng.uniform(0, 6)

    def apply(self, x, dt, top):
        out = []
        for i, v in enumerate(x):
            t = i * dt
            gate = 0.5 + 0.5 * math.tanh(4.0 * math.sin(math.pi * t / self.on))
            out.append(v + self.s * 0.2 * top * gate * math.sin(2 * math.pi * self.f * t + self.phase))
        return out


class Ringing(Fault):
    """Unknown: the rig's frame swings at its own frequency, struck by changes of the force."""

    def draw(self, rng):
        self.w, self.zeta = 2 * math.pi * rng.uniform(3.0, 7.0), rng.uniform(0.015, 0.03)

    def apply(self, x, dt, top):
        y = v = 0.0
        out, rates = [], [0.0]
        for i in range(1, len(x)):
            rates.append((x[i] - x[i - 1]) / dt)
        size = None
        ring = []
        n = 4
        h = dt / n
        for i in range(len(x)):
            a = rates[i]
            for _ in range(n):
                v += h * (a * self.w - 2 * self.zeta * self.w * v - self.w**2 * y)
                y += h * v
            ring.append(v)
        size = peak(ring)
        return [b + self.s * 0.3 * top * r / size for b, r in zip(x, ring)]


class Bursts(Fault):
    """Unknown: another machine shakes the channel now and then, at frequencies of its own."""

    def draw(self, rng):
        self.blows = [(rng.uniform(0.1, 0.9), rng.uniform(1.2, 3.0), rng.choice((-1, 1)) * rng.uniform(0.5, 1.0)) for _ in range(5)]

    def apply(self, x, dt, top):
        out = []
        for i, v in enumerate(x):
            t = i * dt
            d = 0.0
            for at, f, a in self.blows:
                s = t - at * self.seconds
                if s > 0.0:
                    d += a * math.sin(2 * math.pi * f * s) * math.exp(-1.2 * s)
            out.append(v + self.s * 0.4 * top * d)
        return out


FAULT = {
    "sensor_gain": Gain,
    "sensor_lag": Lag,
    "sensor_drift": Drift,
    "sensor_clipping": Clip,
    "hum": Hum,
    "ringing": Ringing,
    "bursts": Bursts,
}
