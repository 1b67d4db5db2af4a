#!/usr/bin/env python3
"""Walks the path of a newcomer in an empty folder and prints the time of each step as CSV.

    scripts/first_minutes.py [--program HYSTERON]

Without --program the repository is cloned and built by the first command of README.md, as a newcomer does it: minutes.
Then an example is written, checked, run and viewed, and a script of one's own has a mistake that the check points at.
Wall seconds and seconds of the processor; exit status 1 where a step does not end as it must.
"""
import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
OWN = "model basic -ndm 2 -ndf 3\nnode 1 0 0\nuniaxialMaterial Steel1 1 250 2e5 0.01\n"


def step(name, command, folder, status=0, says=""):
    """Run a command; its row. It must end with a status and print a text."""
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    wall, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"{name},{wall:.1f},{processor:.1f}", flush=True)
    if done.returncode != status or says not in done.stdout + done.stderr:
        sys.exit(f"{name}: status {done.returncode}\n{done.stdout}{done.stderr}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path)
    args = parser.parse_args()
    print("step,wall s,processor s")
    with tempfile.TemporaryDirectory() as temporary:
        folder, program = Path(temporary), args.program
        if program is None:
            step("clone", ["git", "clone", "-q", ROOT, "hysteron"], folder)
            first = re.search(r"^## Start.*?^```sh\n(.*?)\n", (ROOT / "README.md").read_text(), re.M | re.S)[1]
            step("first command of README", first.split(), folder / "hysteron", says="peak displacement")
            program = folder / "hysteron/target/release/hysteron"
        program = program.resolve()
        work = folder / "work"
        work.mkdir()
        step("example written", [program, "init", "--new", "building"], work)
        step("checked", [program, "check", "isolated_building.tcl"], work)
        step("run", [program, "run", "isolated_building.tcl"], work, says="peak base shear")
        step("viewed", [program, "view", "isolated_building.tcl"], work)
        (work / "own.tcl").write_text(OWN)
        step("own script checked", [program, "check", "own.tcl"], work, status=2, says='did you mean "Steel01"?')
        (work / "own.tcl").write_text(OWN.replace("Steel1 ", "Steel01 "))
        step("own script mended", [program, "check", "own.tcl"], work)
        if not os.path.getsize(work / "isolated_building.html"):
            sys.exit("viewed: an empty page")


if __name__ == "__main__":
    main()
