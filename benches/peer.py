#!/usr/bin/env python3
"""hysteron beside OpenSees, on the same scripts, in the same run.

    benches/peer.py time [--repeats N] [SCRIPT ...]   time both, print the ratios (default: the scripts in SCRIPTS)
    benches/peer.py run SCRIPT                        run one script in OpenSees alone

The first use installs openseespy into a virtual environment in the user's cache folder (HYSTERON_PEER names another place);
on Debian it needs libblas3 liblapack3 libgfortran5 libgomp1. hysteron is built with `cargo build --release`.
Start-up (an empty script) is taken out of both times.
"""
import argparse
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCRIPTS = [
    "validation/opensees/building_boucwen/model.tcl",
    "validation/opensees/timing_frame_5k_dof/model.tcl",
    "benches/bearing.tcl",
]


def peer_python():
    """Python of the environment that has openseespy."""
    default = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "hysteron-peer"
    place = Path(os.environ.get("HYSTERON_PEER", default))
    python = place / "bin" / "python"
    if not python.exists():
        print(f"installing openseespy into {place}", file=sys.stderr)
        venv.create(place, with_pip=True)
    if subprocess.run([python, "-c", "import openseespy"], capture_output=True).returncode != 0:
        subprocess.run([python, "-m", "pip", "install", "--quiet", "openseespy"], check=True)
    return python


def seconds(command, script):
    """Wall time of a script in a copy of its folder, so that neither finds the files of the other."""
    with tempfile.TemporaryDirectory() as work:
        shutil.copytree(script.parent, work, dirs_exist_ok=True)
        start = time.perf_counter()
        done = subprocess.run([*map(str, command), script.name], cwd=work, capture_output=True, text=True)
        taken = time.perf_counter() - start
    if done.returncode != 0:
        sys.exit(f"{command[0]} {script}: status {done.returncode}\n{done.stderr[-2000:]}")
    return taken


def time_both(scripts, repeats):
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=ROOT, check=True)
    ours = [ROOT / "target/release/hysteron", "run", "--compat", "opensees"]
    theirs = [peer_python(), ROOT / "benches/peer_tcl.py"]
    with tempfile.TemporaryDirectory() as folder:
        empty = Path(folder) / "empty.tcl"
        empty.write_text("")
        start = [statistics.median(seconds(c, empty) for _ in range(5)) for c in (ours, theirs)]
    print(f"start-up taken out: hysteron {start[0]:.3f} s, OpenSees {start[1]:.3f} s\n")
    print(f"{'script':52} {'hysteron':>10} {'OpenSees':>10} {'ratio':>8}")
    for script in scripts:
        path = Path(script).resolve()
        a, b = ([], [])
        # In turns, so that whatever else the machine does strikes both.
        for _ in range(repeats):
            a.append(seconds(ours, path) - start[0])
            b.append(seconds(theirs, path) - start[1])
        a, b = (max(statistics.median(x), 1e-4) for x in (a, b))
        print(f"{os.path.relpath(path, ROOT):52} {a:8.3f} s {b:8.3f} s {b / a:8.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    timing = commands.add_parser("time")
    timing.add_argument("--repeats", type=int, default=3)
    timing.add_argument("scripts", nargs="*", metavar="SCRIPT")
    run = commands.add_parser("run")
    run.add_argument("script")
    a = parser.parse_args()
    if a.command == "run":
        sys.exit(subprocess.run([peer_python(), ROOT / "benches/peer_tcl.py", a.script]).returncode)
    time_both(a.scripts or [ROOT / s for s in SCRIPTS], a.repeats)


if __name__ == "__main__":
    main()
