#!/usr/bin/env python3
"""hysteron beside OpenSees, on the same scripts, in the same run.

    benches/peer.py time [--repeats N] [SCRIPT ...]   time both, print ratios and the largest difference of the files they write
                                                      (default: the scripts in SCRIPTS; --opensees COMMAND runs OpenSees otherwise)
    benches/peer.py bearings [--repeats N]            time a step of one bearing in both, and compare what they find
    benches/peer.py run SCRIPT [WORD ...]             run one script in OpenSees alone

The first use installs openseespy into a virtual environment in the user's cache folder (HYSTERON_PEER names another place);
on Debian it needs libblas3 liblapack3 libgfortran5 libgomp1. hysteron is built with `cargo build --release`.
Start-up is taken out of both times: that of an empty script, and for steps of bearings by running two lengths. Times are of the
processor, so that other work on the machine does not count.
"""
import argparse
import os
import resource
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCRIPTS = [
    "validation/opensees/building_boucwen/model.tcl",
    "validation/opensees/timing_frame_5k_dof/model.tcl",
    "benches/bridge.tcl",
    "benches/steel_frame.tcl",
    "benches/concrete_frame.tcl",
]
# Bearings of benches/bearings.tcl: cycles of the two runs, and how far their forces may be apart.
BEARINGS = {"boucwen": (20, 620, 1e-6), "hdr": (20, 320, 1e-4), "kikuchi": (2, 22, 1e-4)}
STEPS = 314


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


def numbers(folder, script):
    """Rows of numbers of each file that a run has written, by the name of the file."""
    found = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if not path.is_file() or (script.parent / name).exists():
            continue
        try:
            found[name] = [[float(word) for word in line.split()] for line in path.read_text().splitlines()]
        except ValueError:
            continue
    return found


def printed(text):
    """The last line that a script prints, as a row of numbers; none if it is something else."""
    try:
        return [[float(word) for word in text.strip().splitlines()[-1].split()]]
    except (IndexError, ValueError):
        return []


def seconds(command, script, words=(), written=None):
    """Processor time of a script in a copy of its folder, so that neither finds the files of the other, and its output.
    The numbers of the files that it writes go to `written`."""
    with tempfile.TemporaryDirectory() as work:
        shutil.copytree(script.parent, work, dirs_exist_ok=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        line = [*map(str, command), script.name, *map(str, words)]
        done = subprocess.run(line, cwd=work, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if written is not None:
            written.update(numbers(Path(work), script))
            written["printed"] = printed(done.stdout)
    if done.returncode != 0:
        sys.exit(f"{command[0]} {script}: status {done.returncode}\n{done.stderr[-2000:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def programs():
    """Commands that run a script: hysteron, built first, and OpenSees."""
    subprocess.run(["cargo", "build", "--release", "--quiet"], cwd=ROOT, check=True)
    ours = [ROOT / os.environ.get("CARGO_TARGET_DIR", "target") / "release/hysteron", "run", "--compat", "opensees"]
    return ours, [peer_python(), ROOT / "benches/peer_tcl.py"]


def apart(a, b):
    """Largest difference of two rows of numbers over the largest of them."""
    a, b = ([float(x) for x in line.split()] for line in (a, b))
    return max(abs(x - y) for x, y in zip(a, b, strict=True)) / max(map(abs, b))


def files_apart(ours, theirs):
    """Largest difference of two runs' files and last printed lines, of each column over its peak; none where the files are not alike."""
    worst = 0.0
    common = [name for name in theirs if name in ours and theirs[name]]
    for name in common:
        a, b = ours[name], theirs[name]
        if [len(row) for row in a] != [len(row) for row in b] or len({len(row) for row in b}) != 1:
            return None
        for x, y in zip(zip(*a), zip(*b)):
            peak = max(map(abs, y))
            # A column of round-off alone says nothing.
            if peak > 1e-9:
                worst = max(worst, max(abs(p - q) for p, q in zip(x, y)) / peak)
    return worst if common else None


def time_bearings(repeats):
    """Time of a step from two lengths of the same run."""
    both = programs()
    script = ROOT / "benches/bearings.tcl"
    print(f"{'bearing':10} {'hysteron':>12} {'OpenSees':>12} {'ratio':>8} {'forces apart':>14}")
    for kind, (few, many, tolerance) in BEARINGS.items():
        steps = ([], [])
        # In turns, so that whatever else the machine does strikes both.
        for _ in range(repeats):
            found = []
            for program, times in zip(both, steps):
                start, _ = seconds(program, script, (kind, few))
                end, out = seconds(program, script, (kind, many))
                times.append((end - start) / (STEPS * (many - few)) * 1e6)
                found.append(out.strip().splitlines()[-1])
            difference = apart(*found)
            if difference > tolerance:
                sys.exit(f"{kind}: the forces are {difference:.1e} apart:\n" + "\n".join(found))
        a, b = map(statistics.median, steps)
        print(f"{kind:10} {a:9.2f} us {b:9.2f} us {b / a:8.1f} {difference:14.1e}")


def time_both(scripts, repeats, opensees):
    ours, theirs = programs()
    theirs = shlex.split(opensees) if opensees else theirs
    with tempfile.TemporaryDirectory() as folder:
        empty = Path(folder) / "empty.tcl"
        empty.write_text("")
        start = [statistics.median(seconds(c, empty)[0] for _ in range(5)) for c in (ours, theirs)]
    print(f"start-up taken out: hysteron {start[0]:.3f} s, OpenSees {start[1]:.3f} s\n")
    print(f"{'script':52} {'hysteron':>10} {'OpenSees':>10} {'ratio':>8} {'apart':>8}")
    ratios = []
    for script in scripts:
        path = Path(script).resolve()
        a, b, files = ([], [], ({}, {}))
        # In turns, so that whatever else the machine does strikes both.
        for _ in range(repeats):
            a.append(seconds(ours, path, written=files[0])[0] - start[0])
            b.append(seconds(theirs, path, written=files[1])[0] - start[1])
        a, b = (max(statistics.median(x), 1e-4) for x in (a, b))
        apart = files_apart(*files)
        ratios.append(b / a)
        shown = "-" if apart is None else f"{apart:.0e}"
        print(f"{os.path.relpath(path, ROOT)[-52:]:52} {a:8.3f} s {b:8.3f} s {b / a:8.1f} {shown:>8}", flush=True)
    print(f"{'median':76} {statistics.median(ratios):8.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    timing = commands.add_parser("time")
    timing.add_argument("--repeats", type=int, default=3)
    timing.add_argument("--opensees", metavar="COMMAND", help="command that runs a script in OpenSees")
    timing.add_argument("scripts", nargs="*", metavar="SCRIPT")
    steps = commands.add_parser("bearings")
    steps.add_argument("--repeats", type=int, default=3)
    run = commands.add_parser("run")
    run.add_argument("script")
    run.add_argument("words", nargs="*")
    a = parser.parse_args()
    if a.command == "run":
        sys.exit(subprocess.run([peer_python(), ROOT / "benches/peer_tcl.py", a.script, *a.words]).returncode)
    if a.command == "bearings":
        return time_bearings(a.repeats)
    time_both(a.scripts or [ROOT / s for s in SCRIPTS], a.repeats, a.opensees)


if __name__ == "__main__":
    main()
