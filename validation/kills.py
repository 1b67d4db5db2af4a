#!/usr/bin/env python3
"""Kill runs at random moments, let them go on from their checkpoints, and compare what they write with a run that was left alone.

    validation/kills.py [--engine target/release/hysteron] [--kills 1000] [--seed 1] [--csv validation/kills.csv]

Every script of validation/opensees and tcl-like-inputs is run with checkpoints as often as they can be. One without a transient
analysis is given one: masses at all nodes, and a harmonic excitation after what the script does.
Each round kills the run (SIGKILL) at random moments of the time that it takes, up to three times, and lets it go on each time.
A round is equal if all files and the standard output have the same bytes as those of the run that was left alone.
"""
import argparse
import csv
import random
import re
import shutil
import subprocess
import tempfile
import time
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIMIT = 60.0
# Excitation of a model that its script does not shake.
TAIL = """
wipeAnalysis
loadConst -time 0.0
foreach node [getNodeTags] { mass $node {*}[lrepeat [llength [nodeDisp $node]] 0.1] }
timeSeries Trig 990001 0.0 100.0 0.37 -factor 0.3
pattern UniformExcitation 990001 1 -accel 990001
recorder Node -file shaken.out -time -node {*}[getNodeTags] -dof 1 disp
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-8 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 0} {$i < 3} {incr i} { puts "[analyze 40 0.01] [catch {eigen 1} w] $w"; puts "[analyze 30 0.01] [getTime]" }
"""
KINDS = re.compile(r"^\s*element\s+(\w+)", re.M)


def is_transient(script):
    return re.search(r"^\s*analysis\s+Transient", script.read_text(errors="replace"), re.M) is not None


def scripts():
    """Scripts that build a model."""
    for folder in ["validation/opensees", "tcl-like-inputs"]:
        for script in sorted((ROOT / folder).rglob("*.tcl")):
            if KINDS.search(script.read_text(errors="replace")):
                yield script


def run(engine, script, place, resume, limit, interval="0.000001s"):
    """Status, standard output, and the seconds taken; the status is None if the run was killed."""
    words = [engine, "run", "--checkpoint", interval, *(["--resume"] if resume else []), script]
    begun = time.monotonic()
    with subprocess.Popen(words, cwd=place, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            out, err = process.communicate(timeout=limit)
            return process.returncode, out, err, time.monotonic() - begun
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return None, b"", b"", time.monotonic() - begun


def copy_of(script, folder, name):
    """A copy of the script's folder without what OpenSees wrote; the path of the script in it."""
    place = folder / name
    shutil.rmtree(place, ignore_errors=True)
    shutil.copytree(script.parent, place, ignore=shutil.ignore_patterns("*.tar.gz", "expected"))
    if not is_transient(script):
        text = script.read_text(errors="replace").rstrip()
        (place / script.name).write_text(text.removesuffix("wipe") + TAIL)
    return place


def content(place):
    return {str(p.relative_to(place)): p.read_bytes() for p in sorted(place.rglob("*")) if p.is_file()}


def round_of_kills(engine, script, folder, alone, rng):
    """Number of kills, and what differs, if anything."""
    status, out, files, seconds = alone
    place, kills, resume = copy_of(script, folder, "killed"), 0, False
    for _ in range(3):
        ended = run(engine, script.name, place, resume, rng.uniform(0.0, seconds))
        resume = True
        if ended[0] is not None:
            break
        kills += 1
    if ended[0] is None:
        ended = run(engine, script.name, place, True, LIMIT)
    if ended[0] != status:
        return kills, f"status {ended[0]}: {ended[2].decode(errors='replace')[:300]}"
    if ended[1] != out:
        return kills, "standard output"
    found = content(place)
    different = [n for n in sorted(files.keys() | found.keys()) if files.get(n) != found.get(n)]
    return kills, ", ".join(different)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--engine", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--kills", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--csv", type=Path)
    parser.add_argument("--slowest", type=float, default=5.0, help="scripts that take longer are left out, in seconds")
    arguments = parser.parse_args()
    engine, rng = str(Path(arguments.engine).resolve()), random.Random(arguments.seed)
    table, left_out = {}, []
    with tempfile.TemporaryDirectory() as temporary:
        folder, alone = Path(temporary), {}
        # Scripts find these beside their folder.
        for name in ["models", "tcl-like-inputs/ground_motions"]:
            (folder / Path(name).name).symlink_to(ROOT / name)
        for script in scripts():
            place = copy_of(script, folder, "alone")
            status, out, _, seconds = run(engine, script.name, place, False, arguments.slowest, "1h")
            if status != 0:
                left_out.append(f"{script.relative_to(ROOT)} (status {status})")
                continue
            alone[script] = (status, out, content(place), seconds)
            table[script] = [sorted(set(KINDS.findall(script.read_text(errors="replace")))), 0, 0, ""]
        while sum(row[1] for row in table.values()) < arguments.kills:
            for script, left_alone in alone.items():
                kills, different = round_of_kills(engine, script, folder, left_alone, rng)
                row = table[script]
                row[1] += kills
                if different:
                    row[2] += 1
                    row[3] = different
                    print(f"{script.relative_to(ROOT)}: {different}", flush=True)
    kinds = Counter(kind for row in table.values() for kind in row[0])
    killed, differ = (sum(row[i] for row in table.values()) for i in (1, 2))
    print(f"{len(table)} scripts with {len(kinds)} kinds of elements, {killed} kills, {differ} rounds differ")
    print("left out:", ", ".join(left_out) or "none")
    if arguments.csv:
        with arguments.csv.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["script", "elements", "kills", "rounds_that_differ", "what"])
            for script, row in table.items():
                writer.writerow([script.relative_to(ROOT), " ".join(row[0]), *row[1:]])
    return 1 if differ else 0


if __name__ == "__main__":
    raise SystemExit(main())
