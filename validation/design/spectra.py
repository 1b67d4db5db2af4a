#!/usr/bin/env python3
"""Spectra, rotations and fragility fits of hysteron against scipy.

    validation/design/spectra.py [--hysteron PROGRAM]

Needs numpy and scipy. Each oscillator is integrated by DOP853 over the record's straight lines; RotD50 and RotD100 come from
180 rotated records, GMRotI50 is left out. Spectra of pairs are
those of samples at 1/100 of the period, which miss a peak by (pi/100)^2/2 = 4.9e-4 at most; scipy has finer samples. The fit is a minimum of -ln L by Nelder and Mead's method, as in Baker (2015).
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize
from scipy.stats import binom, norm

ROOT = Path(__file__).resolve().parents[2]
MOTIONS = ROOT / "tcl-like-inputs/ground_motions"
G = 9.80665
PERIODS = [0.1, 0.5, 1.0, 2.5]
DAMPING = [0.05, 0.2]


def response(a, dt, period, damping):
    """Displacements of an oscillator at 200 points a period, one period of free vibration included."""
    w = 2 * np.pi / period
    end = dt * (len(a) - 1)
    t_all = np.arange(len(a)) * dt
    u, out = np.zeros(2), [np.zeros(1)]
    step = lambda t, y: [y[1], -np.interp(t, t_all, a, right=0.0) - 2 * damping * w * y[1] - w * w * y[0]]
    points = max(2, int(np.ceil(200 * dt / period)) + 1)
    for i in range(len(a) - 1):
        t = np.linspace(t_all[i], t_all[i + 1], points)
        done = solve_ivp(step, (t[0], t[-1]), u, method="DOP853", t_eval=t, rtol=1e-9, atol=1e-12)
        u = done.y[:, -1]
        out.append(done.y[0, 1:])
    t = np.linspace(end, end + period, 201)
    free = solve_ivp(lambda t, y: [y[1], -2 * damping * w * y[1] - w * w * y[0]], (t[0], t[-1]), u, method="DOP853", t_eval=t, rtol=1e-9, atol=1e-12)
    out.append(free.y[0, 1:])
    return np.concatenate(out)


def spectra(hysteron):
    files = [MOTIONS / "meloland_1979_270_g.txt", MOTIONS / "meloland_1979_360_g.txt"]
    records = [np.array(" ".join(f.read_text().split()).split(), float) * G for f in files]
    dt, worst = 0.01, 0.0
    # The strong part is enough, and the files are written anew.
    records = [r[:1000] for r in records]
    with tempfile.TemporaryDirectory() as work:
        names = []
        for k, r in enumerate(records):
            names.append(f"{work}/{k}.txt")
            np.savetxt(names[-1], r / G)
        command = [hysteron, "motions", *names, "--pairs", "--dt", str(dt), "--unit", "g", "--periods", *map(str, PERIODS)]
        command += ["--damping", *[str(100 * d) for d in DAMPING], "--out", f"{work}/out"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        found = json.loads((Path(work) / "out/motions.json").read_text())
    angles = np.radians(np.arange(180))
    for part in found["spectra"]:
        for row, period in zip(part["rows"], PERIODS):
            x, y = (response(r, dt, period, part["damping"]) for r in records)
            w2 = (2 * np.pi / period) ** 2 / G
            turned = np.array([np.max(np.abs(x * np.cos(a) + y * np.sin(a))) for a in angles]) * w2
            px, py = np.max(np.abs(x)) * w2, np.max(np.abs(y)) * w2
            expected = {"rotd50": np.median(turned), "rotd100": turned.max(), "srss": np.hypot(px, py), "geomean": np.sqrt(px * py)}
            for how, value in expected.items():
                name = next(k for k in row if k.startswith(how))
                off = abs(row[name] / value - 1)
                worst = max(worst, off)
                print(f"{part['damping']:5.2f} {period:5.2f} s {how:8s} {row[name]:.6f} {value:.6f} {off:.1e}")
    return worst


def fits(hysteron):
    """Counts from Baker's likelihood, fitted by both."""
    cases = {
        "45 records, laxmandahal/pyFragility, example": (
            [0.178, 0.274, 0.444, 0.56, 0.652, 0.79, 0.982, 1.246, 1.564, 2.014, 2.417, 3.021, 3.625, 4.028, 4.431, 5.035],
            [45] * 16,
            [0, 0, 0, 0, 0, 4, 13, 23, 38, 41, 44, 45, 45, 45, 45, 45],
        ),
        "three stripes of different size": ([1.0, 1.5, 2.0], [59, 50, 44], [2, 25, 43]),
        "few records": ([0.2, 0.4, 0.6, 0.8], [7] * 4, [0, 2, 4, 6]),
    }
    worst = 0.0
    for name, (im, n, k) in cases.items():
        im, n, k = map(np.array, (im, n, k))
        minus = lambda p: -np.sum(binom.logpmf(k, n, norm.cdf(np.log(im / p[0]) / abs(p[1]))))
        best = minimize(minus, [0.8, 0.4], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-12, "maxiter": 20000}).x
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as f:
            f.write("im,records,reached\n" + "".join(f"{a},{b},{c}\n" for a, b, c in zip(im, n, k)))
            f.flush()
            found = json.loads(subprocess.run([hysteron, "fragility", f.name, "--json"], capture_output=True, text=True, check=True).stdout)
        off = max(abs(found["median"] / best[0] - 1), abs(found["beta"] / abs(best[1]) - 1))
        worst = max(worst, off)
        print(f"{name}: median {found['median']:.6f} {best[0]:.6f}, beta {found['beta']:.6f} {abs(best[1]):.6f}, {off:.1e}")
    return worst


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hysteron", default=str(ROOT / "target/release/hysteron"))
    args = parser.parse_args()
    a, b = spectra(args.hysteron), fits(args.hysteron)
    print(f"largest difference: spectra {a:.1e}, fits {b:.1e}")
    sys.exit(bool(a > 5e-4 or b > 1e-6))


if __name__ == "__main__":
    main()
