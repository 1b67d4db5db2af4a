#!/usr/bin/env python3
"""Ground motions fitted to the level 2 spectra of the Japanese road bridge code.

    motions.py [--out DIR] [--check]

writes `tcl-like-inputs/ground_motions/jra_level2_type1_g.txt` and `jra_level2_type2_g.txt`: the motions of plate boundary and inland
earthquakes on ground type II, which the thesis takes in section 5.4. The code's own motions are records whose Fourier amplitudes were
adjusted to these spectra; they are not public. Here the phases are those of records in the same folder. `--check` only compares the
files with the spectra. Needs numpy.

Standard acceleration response spectra at 5 % damping (Japan Road Association, Specifications for highway bridges, part V, 2002,
level 2, ground type II; in English in Unjoh et al., 2002 seismic design specifications of highway bridges, 2002).
"""

import argparse
import pathlib

import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "tcl-like-inputs/ground_motions"
DAMPING = 0.05
STEP = 0.02
# Type: record of the phases with its step and the seconds that are taken, m/s2 of the spectrum.
RECORDS = {1: ("riodell_1992_360_g.txt", 0.02, 60.0), 2: ("meloland_1979_270_g.txt", 0.01, 30.0)}
PERIODS = np.geomspace(0.1, 4.0, 60)
G = 9.80665


def target(kind, period):
    """Acceleration of the level 2 spectrum on ground type II, m/s2."""
    t = np.asarray(period)
    if kind == 1:
        gal = np.where(t < 0.18, np.maximum(1505.0 * t ** (1 / 3), 700.0), np.where(t <= 1.6, 850.0, 1360.0 / t))
    else:
        gal = np.where(t < 0.4, np.maximum(3224.0 * t ** (2 / 3), 700.0), np.where(t <= 1.2, 1750.0, 2371.0 / t ** (5 / 3)))
    return gal / 100.0


def spectrum(accel, step, periods=PERIODS):
    """Peak absolute accelerations of oscillators, exact for accelerations that are linear between samples."""
    w = 2.0 * np.pi / periods
    z, wd = DAMPING, w * np.sqrt(1.0 - DAMPING**2)
    e, s, c = np.exp(-z * w * step), np.sin(wd * step), np.cos(wd * step)
    a11, a12 = e * (c + z * w / wd * s), e * s / wd
    a21, a22 = -(w**2) * a12, e * (c - z * w / wd * s)
    # Particular solution of u'' + 2 z w u' + w2 u = -(p + q t): u = b + d t with d = -q/w2, b = (-p - 2 z w d)/w2.
    u, v, peak = np.zeros_like(w), np.zeros_like(w), np.zeros_like(w)
    for p, after in zip(accel[:-1], accel[1:]):
        d = -(after - p) / step / w**2
        b = (-p - 2.0 * z * w * d) / w**2
        du, dv = u - b, v - d
        u, v = a11 * du + a12 * dv + b + d * step, a21 * du + a22 * dv + d
        peak = np.maximum(peak, np.abs(2.0 * z * w * v + w**2 * u))
    return peak


def fitted(kind, rounds=30):
    """A motion of the spectrum, m/s2: Fourier amplitudes are scaled by the ratio of the spectra, phases stay."""
    name, step, seconds = RECORDS[kind]
    record = np.array((FOLDER / name).read_text().split(), float) * G
    times = np.arange(0.0, seconds, STEP)
    accel = np.interp(times, step * np.arange(len(record)), record)
    ramp = np.clip(np.minimum(times, seconds - times) / 2.0, 0.0, 1.0)
    frequencies = np.fft.rfftfreq(len(accel), STEP)
    best, miss = accel, np.inf
    for _ in range(rounds):
        ratio = target(kind, PERIODS) / spectrum(accel, STEP)
        wrong = np.sqrt(np.mean((1.0 / ratio - 1.0) ** 2))
        if wrong < miss:
            best, miss = accel, wrong
        # Frequencies increase as periods fall. No displacement grows below the longest period.
        factor = np.interp(frequencies, 1.0 / PERIODS[::-1], ratio[::-1])
        factor[frequencies < 0.1] = 0.0
        accel = np.fft.irfft(np.fft.rfft(accel) * factor, len(accel)) * ramp
    return best


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--out", type=pathlib.Path, default=FOLDER)
    p.add_argument("--check", action="store_true", help="compare the files with the spectra")
    a = p.parse_args()
    for kind in RECORDS:
        path = a.out / f"jra_level2_type{kind}_g.txt"
        if not a.check:
            path.write_text("".join(f"{x / G:.5f}\n" for x in fitted(kind)))
        accel = np.loadtxt(path) * G
        ratio = spectrum(accel, STEP) / target(kind, PERIODS)
        print(f"type {kind}: {len(accel)} points, peak {np.abs(accel).max():.2f} m/s2, spectrum over target "
              f"{ratio.min():.2f} to {ratio.max():.2f}, rms {100 * np.sqrt(np.mean((ratio - 1) ** 2)):.1f} %")  # fmt: skip
        if a.check and not (0.8 < ratio.min() and ratio.max() < 1.2):
            raise SystemExit("a motion is not that of its spectrum")


if __name__ == "__main__":
    main()
