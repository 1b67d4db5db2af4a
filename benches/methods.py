#!/usr/bin/env python3
"""The methods of `hysteron calibrate` on the project's own problems, over many seeds.

    benches/methods.py [--seeds 30] [--study study.toml ...] [--methods NAME ...]

For each method and study: how often the search ended within 1e-6 (relative) of the best objective that any found, the median
of the evaluations that it took to come within 1 % of it, and the median of all its evaluations. HYSTERON names the binary.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BINARY = os.environ.get("HYSTERON", ROOT / "target/release/hysteron")
METHODS = ["de/rand/1/bin", "de/rand/1/bin/printed", "l-shade", "jso", "cma-es", "least-squares", "step-search"]


def repeats(study, method, seeds):
    with tempfile.TemporaryDirectory() as out:
        command = [BINARY, "calibrate", study, "--method", method, "--repeats", str(seeds), "--out", out]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return json.loads((Path(out) / "calibration.json").read_text())["repeats"]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=30)
    studies = [ROOT / "tcl-like-inputs/pad_study/study.toml", ROOT / "benches/multimodal/study.toml"]
    parser.add_argument("--study", type=Path, nargs="*", default=studies)
    parser.add_argument("--methods", nargs="*", default=METHODS)
    args = parser.parse_args()
    print("| study | method | found | evaluations to 1 % | all evaluations | worst |\n| --- | --- | --- | --- | --- | --- |")
    for study in args.study:
        all_repeats = {m: repeats(study, m, args.seeds) for m in args.methods}
        best = min(r["objective"] for rs in all_repeats.values() for r in rs)
        for method, rs in all_repeats.items():
            found = sum(r["objective"] <= best * (1 + 1e-6) for r in rs)
            near = [next((n for n, s in r["history"] if s <= 1.01 * best), None) for r in rs]
            reached = [n for n in near if n is not None]
            to = f"{statistics.median(reached):.0f}" if reached else "-"
            if len(reached) < len(rs):
                to += f" ({len(reached)} of {len(rs)})"
            total = statistics.median(r["evaluations"] for r in rs)
            worst = max(r["objective"] for r in rs) / best
            print(f"| {study.resolve().parent.name} | `{method}` | {found} of {len(rs)} | {to} | {total:.0f} | {worst:.4g} |")


if __name__ == "__main__":
    main()
