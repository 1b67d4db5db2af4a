"""Small errors of a model that is only roughly right, beside what is concealed: no real model is free of them.

The recordings have them, the analyst's script has not. They are drawn apart from the case, which stays as it is without them."""

import math
import random

from . import signals

# Laws of a device that bend its loop a little, by family. Those of the truth and of its look-alikes are left out.
SHAPES = ("strain_stiffening", "friction", "cyclic_degradation", "rate_dependence")
SHAPED = {"pad": SHAPES, "building": ("strain_stiffening", "friction"), "pier": ("strain_stiffening", "friction"), "frame": (), "platform": ()}
LIKE = {
    "strain_stiffening": ("axial_shear_interaction", "gap_impact", "mullins_softening", "sensor_clipping"),
    "friction": ("rate_dependence", "damping", "sensor_gain", "bidirectional_coupling", "varying_axial_load"),
    "cyclic_degradation": ("self_heating", "mullins_softening", "pinching"),
    "rate_dependence": ("friction", "damping", "mullins_softening", "sensor_lag", "ambient_temperature"),
}
NOISES = ("steady", "bursts", "quantised", "band_limited", "proportional", "hum")
LEAST_SHAPE, MOST_SHAPE = 0.3, 0.4  # of the noise, and of the concealed effect


class Imperfections:
    """Errors of the kinds that a seed draws: parameters that differ by run, masses, the shape of a law, a filter, the kind of noise."""

    def __init__(self, seed, case):
        rng = self.rng = random.Random(f"imperfect {seed}")
        m = self.model = case.model
        repeat = 10 ** rng.uniform(-2.5, -1.7)
        self.parameters = {r.name: {k: v * (1.0 + rng.gauss(0, repeat)) for k, v in m.parameters.items()} for r in m.runs}
        spread = rng.uniform(0.0, 0.04)
        self.masses = [x * (1.0 + rng.gauss(0, spread)) for x in m.masses] if hasattr(m, "masses") else None
        self.delay = rng.uniform(0.0, 0.002) * m.slow
        self.noise = rng.choice(NOISES)
        self.hum = rng.uniform(9.0, 16.0)
        self.said = {"parameters_by_run": repeat, "masses": spread if self.masses else 0.0, "delay_s": self.delay, "noise": self.noise}
        self.shape = self.choose_shape(case, rng)

    def choose_shape(self, case, rng):
        """A small effect of another kind in the device: its size lies between a part of the noise and a part of the effect."""
        m = self.model
        inside = [e for e in SHAPED[m.family] if e not in case.truth and not any(t in LIKE[e] for t in case.truth)]
        if not inside or getattr(m, "orbit", False) or getattr(m, "vertical_test", False):
            return []
        kind, seed = rng.choice(inside), rng.randrange(1 << 30)
        place = m.place(kind, rng)
        low = LEAST_SHAPE * case.level
        high = max([case.level] + [MOST_SHAPE * a for a in case.achieved])
        wanted = low * (high / low) ** rng.random()
        zero = case.stacked(case.clean)

        def size(s):
            moved = {r.name: m.respond(r, m.parameters, [m.conceal(kind, s, seed, place)]) for r in case.fit}
            return math.sqrt(sum(x * x for x in case.off_parameters(case.stacked(moved), zero)))

        s = 0.1
        for _ in range(4):
            s = min(1.0, max(1e-3, s * wanted / max(size(s), 1e-12)))
        self.said["shape"] = {"kind": kind, "strength": float(f"{s:.4g}"), "over_noise": float(f"{size(s) / case.level:.4g}")}
        return [(kind, s, seed, place)]

    def respond(self, run, concealed):
        """Channels of a run as the real structure gives them, with what is concealed."""
        m = self.model
        masses = getattr(m, "masses", None)
        if self.masses:
            m.masses = self.masses
        try:
            small = [m.conceal(kind, s, seed, place) for kind, s, seed, place in self.shape]
            out = m.respond(run, self.parameters[run.name], concealed + small)
        finally:
            if self.masses:
                m.masses = masses
        return {c: late(x, run.every, self.delay) for c, x in out.items()}

    def noise_of(self, kind, true, step, size):
        """Noise of a channel with the mean square of the size. `kind` is the colour of a steady one."""
        rng, n = self.rng, len(true)
        if self.noise == "quantised":
            q = size * math.sqrt(12.0)
            return [round(x / q) * q - x for x in true]
        out = signals.noise(rng, kind, n, step)
        if self.noise == "bursts":
            out = [v * (4.0 if (i * 12 // n) % 4 == 2 else 0.7) for i, v in enumerate(out)]
        elif self.noise == "band_limited":
            out = [sum(out[max(0, i - 3):i + 4]) for i in range(n)]
        elif self.noise == "proportional":
            top = signals.peak(true)
            out = [v * (0.2 + abs(x) / top) for v, x in zip(out, true)]
        elif self.noise == "hum":
            phase = rng.uniform(0.0, 2.0 * math.pi)
            out = [0.6 * v + math.sin(2.0 * math.pi * self.hum * i * step + phase) for i, v in enumerate(out)]
        rms = math.sqrt(sum(v * v for v in out) / n)
        return [size * v / rms for v in out]


def late(x, dt, delay):
    """The series behind a filter with a delay."""
    return [signals.interpolate_even(x, i - delay / dt) for i in range(len(x))]
