#!/usr/bin/env python3
"""Processor time of the Python package beside the command line, on the same scripts.

    benches/python_ratio.py --hysteron BINARY [--repeats 5] [--limit 1.15] [SCRIPT ...]

Needs a Python with hysteron; BINARY is the command line of the same profile. Each script runs with the command line and with
`hysteron.run` in turn, each in a process of its own, of which the time of an empty script is taken off. The table has the smallest
times. The status is 1 if the package takes more than --limit of the command line's time.
"""
import argparse
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
RUN = "import sys, hysteron; sys.exit(hysteron.run(sys.argv[1]).status)"


def seconds(command):
    """Processor time of a process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(command, check=True, capture_output=True, cwd=folder, env=os.environ)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scripts", nargs="*", type=Path, default=[HERE / "concrete_frame.tcl", HERE / "steel_frame.tcl"])
    parser.add_argument("--hysteron", required=True)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--limit", type=float, default=1.15)
    options = parser.parse_args()
    programs = {"command line": [options.hysteron, "run"], "package": [sys.executable, "-c", RUN]}
    worst = 0.0
    print(f"{'':24}{'command line':>14}{'package':>10}{'ratio':>8}")
    with tempfile.NamedTemporaryFile("w", suffix=".tcl") as empty:
        scripts = [Path(empty.name), *(s.resolve() for s in options.scripts)]
        best = {}
        for _ in range(options.repeats):
            for script in scripts:
                for name, command in programs.items():
                    took = seconds([*command, str(script)])
                    best[script, name] = min(took, best.get((script, name), took))
        for script in scripts[1:]:
            theirs, ours = (best[script, name] - best[scripts[0], name] for name in programs)
            worst = max(worst, ours / theirs)
            print(f"{script.name:24}{theirs:12.2f} s{ours:8.2f} s{ours / theirs:8.2f}")
    return int(worst > options.limit)


if __name__ == "__main__":
    sys.exit(main())
