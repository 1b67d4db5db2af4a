#!/usr/bin/env python3
"""The diagnosis of the thesis' tests, repeated with other noise and other temperatures.

    repeated.py [--hysteron FILE] [--out DIR] [--seeds N] [--small] [--threads N]

makes the recordings of `tcl-like-inputs/hdr_heating_study/study.toml` with `integrator.py` for each seed and each set of temperatures,
diagnoses them, and prints a row for each: the effects that were named, and what remains of the recordings. Both effects are named
where the verdict has self_heating and mullins_softening. What has a result in the folder is not run again. With `--small` a test has
three cycles. Each of the 3 N diagnoses takes minutes of a core. Needs numpy and scipy.
"""

import argparse
import json
import pathlib
import re
import subprocess

import integrator

# Chamber of the fitted runs and of those held out, degC.
TEMPERATURES = [(-30.0, -10.0, -20.0, 23.0), (-20.0, 10.0, -30.0, 23.0), (-25.0, 5.0, 15.0, -10.0)]
TRUTH = {"self_heating", "mullins_softening"}
SMALL_CYCLES = 3


def shortened(pieces, times, cycles):
    """A test of fewer cycles of the same motion."""
    end = times[integrator.SAMPLES * cycles]
    return [(min(e, end), motion) for e, motion in pieces if e < end] + [(end, next(m for e, m in pieces if e >= end))], times[times <= end]


def make(folder, temperatures, seed, small):
    """The study of a seed: recordings, script, and its file with the temperatures."""
    recordings = integrator.recordings
    if small:
        integrator.recordings = lambda t: {n: (a, shortened(*test, SMALL_CYCLES)) for n, (a, test) in recordings(t).items()}
    try:
        integrator.write(folder, temperatures, seed)
    finally:
        integrator.recordings = recordings
    (folder / "rubber.tcl").write_text((integrator.STUDY / "rubber.tcl").read_text())
    chambers = iter(temperatures)
    text = re.sub(r"chamber = -?\d+", lambda _: f"chamber = {next(chambers):g}", (integrator.STUDY / "study.toml").read_text())
    (folder / "study.toml").write_text(text)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--out", type=pathlib.Path, default=pathlib.Path("results/thesis-repeated"))
    p.add_argument("--hysteron", default="hysteron")
    p.add_argument("--seeds", type=int, default=10)
    p.add_argument("--small", action="store_true")
    p.add_argument("--threads", default="1")
    a = p.parse_args()
    print(f"{'seed':>4} {'temperatures':20} {'effects':40} {'%':>3} {'fitted':>8} {'held out':>8}")
    both = total = 0
    for seed in range(1, a.seeds + 1):
        for n, temperatures in enumerate(TEMPERATURES, 1):
            folder = a.out / f"{seed}-{n}"
            result = folder / "out/diagnosis.json"
            if not result.exists():
                make(folder, temperatures, seed, a.small)
                words = [a.hysteron, "diagnose", folder / "study.toml", "--threads", a.threads, "--out", folder / "out"]
                subprocess.run(words, check=True, capture_output=True)
            d = json.loads(result.read_text())
            v, left = d["verdict"], d["corrected"] or d["baseline"]
            effects = [v["cause"], *v["also"]]
            total, both = total + 1, both + (set(effects) == TRUTH)
            print(f"{seed:4} {' '.join(f'{t:g}' for t in temperatures):20} {' + '.join(effects):40} {100 * v['confidence']:3.0f} "
                  f"{left['fit_nmse']:8.2g} {left['holdout_nmse']:8.2g}", flush=True)  # fmt: skip
    print(f"both effects named in {both} of {total}")


if __name__ == "__main__":
    main()
