#!/usr/bin/env python3
"""Evaluations of a calibration, side by side and one candidate after the other.

    benches/side_by_side.py [--generations N] [--repeats N] [BEARING ...]

The studies are those of `calibrate.py` (plane, boucwen, hdr, storeys), with a recording by hysteron itself. One study of each pair reads a
result after its last analysis, which keeps its candidates from going side by side. Both must find the same objectives. Times are of
the processor, in ms an evaluation on one thread, the best of some repeats in turns. HYSTERON names another binary.
"""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import calibrate
from calibrate import BEARINGS, ROOT, motion, ours, write_study

READS = "set end [getTime]\n"


def recorded_force(folder, bearing):
    """The force of the script with its own values."""
    binary = os.environ.get("HYSTERON", ROOT / "target/release/hysteron")
    subprocess.run([binary, "run", "model.tcl"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return np.loadtxt(folder / "force.out")[:, BEARINGS[bearing][2] + 1]


def write_pair(folder, bearing):
    path = motion(BEARINGS[bearing][1]).tolist()
    recorded = np.zeros(calibrate.STEPS)
    for name, ending in [("beside", ""), ("alone", READS)]:
        place = folder / name
        place.mkdir()
        write_study(place, bearing, path, recorded)
        recorded = recorded_force(place, bearing)
        write_study(place, bearing, path, recorded)
        with open(place / "model.tcl", "a") as script:
            script.write(ending)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--generations", type=int, default=calibrate.GENERATIONS)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("bearings", nargs="*", default=["plane", "boucwen", "hdr", "storeys"], metavar="BEARING")
    args = parser.parse_args()
    calibrate.GENERATIONS = args.generations
    print("| bearing | one by one | side by side | ratio |\n| --- | --- | --- | --- |")
    for bearing in args.bearings:
        with tempfile.TemporaryDirectory() as place:
            write_pair(Path(place), bearing)
            times = {"alone": [], "beside": []}
            objectives = set()
            for _ in range(args.repeats):
                for name, own in times.items():
                    result, cpu = ours(Path(place) / name, 1)
                    own.append(1000 * cpu)
                    objectives.add(result["objective"])
        if len(objectives) != 1:
            return f"{bearing}: different objectives {objectives}"
        alone, beside = min(times["alone"]), min(times["beside"])
        print(f"| {bearing} | {alone:.3f} | {beside:.3f} | {alone / beside:.1f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
