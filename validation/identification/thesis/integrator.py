#!/usr/bin/env python3
"""Rheology of high damping rubber with self-heating and softening, integrated by scipy.

    integrator.py [--seed N] [--out DIR] [--temperatures T1 T2 T3 T4]

writes the recordings of `tcl-like-inputs/hdr_heating_study`. Nothing of hysteron takes part: the equations of D. A. Nguyen,
"A rheology model of high damping rubber bearings for seismic analysis at room and low temperatures", dissertation (Eqs 3.1 to
3.13), are integrated between the events of the sliders by Radau's method. The rubber is heated by all work that is not
stored (Eq 5.3), and its stresses have the factor F = 1 + R exp(-g/g0) of the largest strain g so far (Simo, 1987).

Units: MPa, s, degC. Needs numpy and scipy.
"""

import argparse
import math
import pathlib

import numpy as np
from scipy.integrate import solve_ivp

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
STUDY = ROOT / "tcl-like-inputs/hdr_heating_study"

# The rubber that is concealed. Factors on the parts of compound HDR3, composite heat capacity of specimen A (Eq 5.3:
# 1.15 x 1.732 + 7.85 x 0.432 x 5 x 2.3/30 MPa/K), softening.
FACTORS = {"spring": 1.06, "friction": 0.92, "overstress": 1.08, "viscosity": 0.95}
CAPACITY = 1.15 * 1.732 + 7.85 * 0.432 * 5 * 2.3 / 30.0
EXCESS, STRAIN = 0.25, 0.6
NOISE, NOISE_TEMPERATURE = 0.02, 0.2
# Rows of the recording for each cycle.
SAMPLES = 80


def table(name="HDR3"):
    """Rows of a compound: temperature and ten parameters."""
    return np.loadtxt(ROOT / f"models/compounds/{name}.txt")


class Rubber:
    """Parameters over temperature; the rows of the table beyond its ends."""

    def __init__(self, rows, factors=None, capacity=math.inf, excess=0.0, strain=1.0):
        f = {"spring": 1.0, "friction": 1.0, "overstress": 1.0, "viscosity": 1.0, **(factors or {})}
        by = [f["friction"], f["spring"], f["spring"], f["friction"], 1.0, *3 * [f["overstress"]], f["viscosity"], 1.0]
        self.temperatures, self.values = rows[:, 0], rows[:, 1:] * by
        self.capacity, self.excess, self.strain = capacity, excess, strain

    def at(self, temperature):
        return [np.interp(temperature, self.temperatures, column) for column in self.values.T]

    def factor(self, peak):
        return 1.0 + self.excess * math.exp(-peak / self.strain)

    def stored(self, temperature, g, e1, b, e2):
        """Elastic energy per volume before the factor: strains of the springs are those of C2eq, C1eq, C2oe, C1oe."""
        c1, c2, c3, _, m, d1, d2, *_ = self.at(temperature)
        return 0.5 * (c1 * e1 * e1 + c2 * g * g + d1 * e2 * e2 + d2 * b * b) + c3 / (m + 1.0) * abs(g) ** (m + 1.0)


class Piece:
    """A piece of the motion on which the strain goes one way: g(t), its rate, and the state of the sliders."""

    def __init__(self, rubber, motion, slips, start, peak):
        self.rubber, self.motion, self.slips, self.peak = rubber, motion, slips, peak
        self.t0, (self.s1, self.d, self.s2, self.temperature) = start

    def elastic(self, g, y):
        """Strains of the equilibrium spring, the elasto-plastic part of the overstress, and its spring."""
        s1, d, s2, temperature = y
        p = self.rubber.at(temperature)
        e1 = self.slips[0] * p[3] / p[0] if self.slips[0] else g - s1
        b = g - d
        e2 = self.slips[1] * p[7] / p[5] if self.slips[1] else b - s2
        return p, e1, b, e2

    def largest(self, g):
        return max(self.peak, abs(g))

    def rates(self, t, y):
        """Rates of both sliders, of the dashpot and of the temperature."""
        g, v = self.motion(t)
        rubber, temperature = self.rubber, y[3]
        p, e1, b, e2 = self.elastic(g, y)
        over = p[5] * e2 + p[6] * b
        d = math.copysign((abs(over) / p[8]) ** (1.0 / p[9]), over)
        # The widths of the sliders change with the temperature, by a difference over a hundredth of a degree.
        h = 0.01
        q = rubber.at(temperature + h)
        w1, w2 = (q[3] / q[0] - p[3] / p[0]) / h, (q[7] / q[5] - p[7] / p[5]) / h
        factor = rubber.factor(self.largest(g))
        growing = abs(g) >= self.peak and g * v > 0.0
        fall = rubber.excess / rubber.strain * math.exp(-self.largest(g) / rubber.strain) * abs(v) if growing else 0.0
        stored = rubber.stored(temperature, g, e1, b, e2)
        by_temperature = (rubber.stored(temperature + h, g, e1, b, e2) - stored) / h
        # Heat of sliders and dashpot, of softening, and of springs whose stiffness falls; sliders move as the temperature does.
        s1, s2 = self.slips
        still = factor * (s1 * p[3] * v + s2 * p[7] * (v - d) + over * d) + fall * stored
        moving = factor * (by_temperature + abs(s1) * p[3] * w1 + abs(s2) * p[7] * w2)
        warm = still / (rubber.capacity + moving) if math.isfinite(rubber.capacity) else 0.0
        slide1 = v - s1 * w1 * warm if s1 else 0.0
        slide2 = v - d - s2 * w2 * warm if s2 else 0.0
        return [slide1, d, slide2, warm]

    def stress(self, t, y):
        g, _ = self.motion(t)
        p, e1, b, e2 = self.elastic(g, y)
        tau = p[0] * e1 + p[1] * g + math.copysign(p[2] * abs(g) ** p[4], g) + p[5] * e2 + p[6] * b
        return self.rubber.factor(self.largest(g)) * tau

    def events(self):
        """A slider begins to slip at its limit, and sticks when it would move back."""

        def reaches(index, sign):
            def event(t, y):
                p, e1, _, e2 = self.elastic(self.motion(t)[0], y)
                return sign * (e1, e2)[index] - (p[3] / p[0], p[7] / p[5])[index]

            event.direction, event.change = 1, (index, sign)
            return event

        def sticks(index):
            def event(t, y):
                return self.slips[index] * self.rates(t, y)[2 * index]

            event.direction, event.change = -1, (index, 0)
            return event

        out = []
        for index in (0, 1):
            out += [sticks(index)] if self.slips[index] else [reaches(index, 1), reaches(index, -1)]
        for event in out:
            event.terminal = True
        return out


def run(rubber, ambient, pieces, times):
    """Stress and temperature at some times. A piece has its end, and a function that gives strain and rate of one sign."""
    y, slips, peak, t = [0.0, 0.0, 0.0, ambient], [0, 0], 0.0, 0.0
    out = np.zeros((len(times), 2))
    out[:, 1] = ambient
    for end, motion in pieces:
        # A slider that would move back sticks.
        begin = Piece(rubber, motion, list(slips), (t, y), peak).rates(t + 1e-9, y)
        for index in (0, 1):
            if slips[index] * begin[2 * index] < 0.0:
                slips[index] = 0
        while t < end:
            piece = Piece(rubber, motion, list(slips), (t, y), peak)
            events = piece.events()
            done = solve_ivp(
                piece.rates, (t, end), y, "Radau", events=events, rtol=1e-8, atol=1e-10, dense_output=True,
                max_step=(end - t) / 4.0 if end - t < 60.0 else math.inf,
            )  # fmt: skip
            if not done.success:
                raise RuntimeError(done.message)
            stop = done.t[-1]
            inside = (times > t) & (times <= stop)
            for i in np.flatnonzero(inside):
                state = done.sol(times[i])
                out[i] = piece.stress(times[i], state), state[3]
            y, t = list(done.y[:, -1]), stop
            # The plastic strains of the sliders that slipped.
            g = motion(t)[0]
            _, e1, b, e2 = piece.elastic(g, y)
            y[0], y[2] = g - e1, b - e2
            for event, hits in zip(events, done.t_events):
                if len(hits):
                    index, sign = event.change
                    slips[index] = sign
            if t >= end:
                peak = max(peak, abs(motion(end)[0]))
    return out


def sine(amplitude, hz, cycles, samples=SAMPLES):
    w = 2.0 * math.pi * hz
    motion = lambda t: (amplitude * math.sin(w * t), amplitude * w * math.cos(w * t))
    ends = [(0.25 + 0.5 * i) / hz for i in range(2 * cycles)] + [cycles / hz]
    return [(end, motion) for end in ends], np.arange(samples * cycles + 1) / (samples * hz)


def triangle(amplitude, rate, cycles, samples=SAMPLES):
    """CS of Table 2.2: to and fro at a constant rate."""
    quarter = amplitude / rate
    count = 2 * cycles + 1
    ends = [quarter * (1 + 2 * i) for i in range(count - 1)] + [4 * quarter * cycles]

    def piece(i):
        sign = 1.0 if i % 2 == 0 else -1.0
        return lambda t: (sign * rate * (t - 2.0 * quarter * i), sign * rate)

    return [(end, piece(i)) for i, end in enumerate(ends)], np.arange(samples * cycles + 1) * 4.0 * quarter / samples


def recordings(temperatures):
    """Fitted: eleven cycles at 0.5 Hz at two temperatures. Held out: other temperatures, rates and amplitudes."""
    a, b, c, d = temperatures
    return {
        "sine_a": (a, sine(1.75, 0.5, 11)),
        "sine_b": (b, sine(1.75, 0.5, 11)),
        "slow_c": (c, triangle(1.25, 1.5, 6)),
        "fast_d": (d, sine(1.5, 1.0, 11)),
    }


def write(out, temperatures, seed):
    out.mkdir(parents=True, exist_ok=True)
    noise = np.random.default_rng(seed)
    rubber = Rubber(table(), FACTORS, CAPACITY, EXCESS, STRAIN)
    for name, (ambient, (pieces, times)) in recordings(temperatures).items():
        exact = run(rubber, ambient, pieces, times)
        stress = exact[:, 0] + NOISE * noise.standard_normal(len(times))
        inside = exact[:, 1] + NOISE_TEMPERATURE * noise.standard_normal(len(times))
        strain = [next(motion for end, motion in pieces if t <= end + 1e-9)(t)[0] for t in times]
        rows = ["time[s],strain[-],stress[MPa],inside[degC]"]
        rows += [f"{t:.6g},{g:.6f},{s:.4f},{x:.2f}" for t, g, s, x in zip(times, strain, stress, inside)]
        (out / f"{name}.csv").write_text("\n".join(rows) + "\n")
        print(f"{name}: {ambient} degC, {len(times)} rows, stress {exact[:, 0].min():.2f} to {exact[:, 0].max():.2f} MPa, "
              f"inside at the end {exact[-1, 1]:.1f} degC")  # fmt: skip


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--out", type=pathlib.Path, default=STUDY)
    p.add_argument("--temperatures", type=float, nargs=4, default=[-30.0, -10.0, -20.0, 23.0])
    a = p.parse_args()
    write(a.out, a.temperatures, a.seed)


if __name__ == "__main__":
    main()
