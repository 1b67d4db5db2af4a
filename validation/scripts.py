#!/usr/bin/env python3
"""Share of a folder of OpenSees scripts that hysteron runs with OpenSees' numbers.

    validation/scripts.py FOLDER --opensees "python -m opensees" [--opensees "python other.py"] [--csv TABLE]

FOLDER has one folder a repository. A script is taken if it builds a model, analyses it, and no other script of its repository
sources it; of each repository at most --each scripts, chosen by a hash of their paths. Each script runs in OpenSees and then in
`hysteron run --compat opensees`, both in a copy of its folder and for at most --limit seconds. It counts if it is within scope
and OpenSees runs it to its end and writes numbers. It is equal if every column of every file that either program writes differs
by at most --tolerance of the column's peak; without files, the numbers that it prints are compared. The texts of the command
`print` are not compared: each OpenSees has its own. With several OpenSees, one that agrees is enough. --cache keeps what
OpenSees wrote, for later runs of the same scripts.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import pickle
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Words of scripts outside hysteron's scope: soil plasticity, fluids, fire, reliability, parallel runs, hybrid tests, contact;
# materials whose source is not public; packages with compiled code, and commands of programs other than OpenSees.
OUT_OF_SCOPE = re.compile("|".join([
    "PressureDepend|PressureIndepend|MultiYield|ManzariDafalias|PM4Sand|PM4Silt|CamClay|DruckerPrager|TruncatedDP",
    "[qQ]uadUP|[bB]rickUP|updateMaterialStage|DomainReduction|AbsorbingBoundary|Lysmer|\\bPML",
    "PFEM|FluidSolid|AcousticMedium|A[VC]3D|[tT]hermal|randomVariable|reliability|performanceFunction|sensitivity",
    "\\bgetPID\\b|\\bgetNP\\b|OpenFresco|expElement|expControl|database\\s",
    "BeamContact|SimpleContact|Contact3D|ZeroLengthContact|WheelRail|Penalty2D",
    "PlaneStressUserMaterial|loadPackage|SumElementForcesRecorder|ElementSumRecorder",
    "^\\s*(pragma|export)\\s",
]), re.M)
BUILDS = re.compile(r"^\s*(model\s+\w|element\s+\w)", re.M)
ANALYSES = re.compile(r"\banalyze\b|\beigen\b")
SOURCES = re.compile(r"\bsource\s+(?:-encoding\s+\S+\s+)?[\"{]?([^\s\"};\]]+)")
# Outcomes of the scripts that count.
OUTCOMES = ("equal", "differs", "refused", "timeout")
# Share of the peak of a file below which a column is round-off.
NOISE_OF_FILE = 1e-5
# Files that are no results.
NO_RESULTS = (".log", ".tcl", ".html", ".svg", ".json")
TIMES = re.compile(r"warning|failure|error|second|elapsed|duration|time|clock|date|\bms\b|\bmin\b", re.I)


# Lines of the command `print`, with -JSON too, which OpenSees writes to its error stream.
OF_PRINT = re.compile(r"\s*(Node:|Element:|Coordinates|Disps|Velocities|commitAccels|unbalanced|Mass|Eigenvectors|ID\s*:|Rayleigh"
                      r"|strain:|NODE DATA|ELEMENT DATA|Current Time|Committed Time|SP_Constraint|MP_Constraint|Pressure_Constraint"
                      r"|End \d Forces|Number of Sections|Connected |Gauss point|thickness:|surface pressure|mass density|body forces"
                      r"|\w+, element id|Nodal Load|LOAD PATTERNS|Load Pattern|Linear Series|PARAMETERS|\"\w+\"\s*:|\{\"|[{}\[\]]+,?\s*$)")
# Results beside a time of the analysis, which is no time of the clock.
OF_RESULTS = re.compile(r"disp|force|reaction|drift", re.I)
# Names of files of mode shapes and participation factors.
OF_MODES = re.compile(r"eig|mode|modal|phi", re.I)


def text_of(path):
    return path.read_bytes().decode("utf-8", "replace")


def closure(path, seen=None):
    """Text of a script and of what it sources, as far as the names are written out."""
    seen = set() if seen is None else seen
    seen.add(path)
    text = text_of(path)
    parts = [text]
    for name in SOURCES.findall(text):
        found = path.parent / name.replace("\\", "/")
        if "$" not in name and found.is_file() and found not in seen:
            parts.append(closure(found, seen))
    return "\n".join(parts)


def entries(repository, each):
    """Scripts of a repository that stand alone, no two with the same text."""
    scripts = sorted(p for p in repository.rglob("*") if p.suffix.lower() == ".tcl" and p.is_file())
    sourced = {(p.parent / n.replace("\\", "/")).resolve() for p in scripts for n in SOURCES.findall(text_of(p))}
    texts, found = set(), []
    for script in sorted(scripts, key=lambda p: hashlib.sha1(str(p.relative_to(repository)).encode()).hexdigest()):
        text = closure(script)
        if script.resolve() in sourced or text in texts or not BUILDS.search(text) or not ANALYSES.search(text):
            continue
        texts.add(text)
        found.append((script, text))
    inside = [(s, t) for s, t in found if not OUT_OF_SCOPE.search(t)]
    return [s for s, _ in inside[:each]], len(found) - len(inside)


def run(command, script, text, limit):
    """Status, printed text, messages and new files of a script in a copy of its folder."""
    base = script.parent.parent if "../" in text or "..\\" in text else script.parent
    with tempfile.TemporaryDirectory() as work:
        copy = Path(work) / "copy"
        shutil.copytree(base, copy, symlinks=True)
        cwd = copy / script.parent.relative_to(base)
        before = {p: p.stat().st_mtime_ns for p in copy.rglob("*") if p.is_file()}
        try:
            done = subprocess.run([*command, script.name], cwd=cwd, capture_output=True, timeout=limit, stdin=subprocess.DEVNULL)
            status, out, err = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            status, out, err = "timeout", b"", b""
        files = {}
        for path in copy.rglob("*"):
            if path.is_file() and before.get(path) != path.stat().st_mtime_ns and path.stat().st_size < 60_000_000:
                files[str(path.relative_to(copy))] = path.read_bytes()
    return status, out.decode("utf-8", "replace"), err.decode("utf-8", "replace"), files


def number(word):
    try:
        value = float(word)
    except ValueError:
        return None
    return value


def table(data):
    """Rows of numbers of a file, without rows of words alone."""
    rows = []
    for line in data.splitlines():
        row = [v for v in map(number, re.split(r"[\s,;]+", line.strip())) if v is not None]
        if row:
            rows.append(row)
    return rows


def apart(want, got, modes=False):
    """Greatest difference of two tables as a share of the column's peak, and its column; None if their shapes differ.

    The sign of a mode is arbitrary: with `modes` that of each number is free.
    """
    if len(want) != len(got) or any(len(a) != len(b) for a, b in zip(want, got)):
        return None
    width = max(map(len, want), default=0)
    peaks = [max((abs(r[c]) for r in want if c < len(r) and abs(r[c]) < 1e300), default=0.0) for c in range(width)]
    floor = NOISE_OF_FILE * max(peaks, default=0.0)
    worst = (0.0, 0)
    for a, b in zip(want, got):
        for c, (x, y) in enumerate(zip(a, b)):
            if x == y or (x != x and y != y):
                continue
            distance = min(abs(x - y), abs(x + y)) if modes else abs(x - y)
            share = distance / max(peaks[c], floor, 1e-30)
            if not share < worst[0]:
                worst = (share if share == share else float("inf"), c)
    return worst


def printed(text):
    """Numbers that a script prints, without times, messages and what `print` shows of nodes and elements."""
    lines, of_mass = [], False
    for line in text.splitlines():
        # The rows of a matrix of masses follow its heading.
        of_mass = bool(re.match(r"\s*Mass\s*:", line)) or (of_mass and bool(table(line)) and not re.search("[A-Za-z]{2}", line))
        if not of_mass and not OF_PRINT.match(line) and (OF_RESULTS.search(line) or not TIMES.search(line)):
            lines.append(line)
    return table("\n".join(lines))


def compare(want, got, tolerance, modes=False):
    """Empty if the outputs agree, else the first difference."""
    names = sorted(set(want[3]) | set(got[3]))
    numbers = 0
    for name in names:
        if name.lower().endswith(NO_RESULTS) or "elapsed" in name.lower() or any(b"NODE DATA" in side[3].get(name, b"") for side in (want, got)):
            continue
        if name not in got[3]:
            if table(want[3][name].decode("utf-8", "replace")):
                return f"{name}: not written"
            continue
        if name not in want[3]:
            if got[3][name]:
                return f"{name}: written by hysteron alone"
            continue
        a, b = (table(side[3][name].decode("utf-8", "replace")) for side in (want, got))
        numbers += len(a)
        worst = apart(a, b, modes and bool(OF_MODES.search(name)))
        if worst is None:
            return f"{name}: {len(a)} rows of {len(a[0]) if a else 0}, not {len(b)} of {len(b[0]) if b else 0}"
        if worst[0] > tolerance:
            return f"{name}: column {worst[1] + 1} by {worst[0]:.2g} of its peak"
    if numbers == 0:
        worst = apart(printed(want[1]), printed(got[1]), modes)
        if worst is None:
            return "printed numbers: not as many"
        if worst[0] > tolerance:
            return f"printed numbers by {worst[0]:.2g}"
    return ""


def has_numbers(result):
    files = (data for name, data in result[3].items() if not name.lower().endswith(NO_RESULTS))
    return any(table(d.decode("utf-8", "replace")) for d in files) or bool(printed(result[1]))


def reference(options, index, script, text):
    command = options.opensees[index]
    if options.cache is None:
        return run(command, script, text, options.limit)
    key = hashlib.sha1(f"{' '.join(command)}\n{script}\n{text}".encode()).hexdigest()
    kept = options.cache / key
    if kept.exists():
        return pickle.loads(kept.read_bytes())
    result = run(command, script, text, options.limit)
    kept.write_bytes(pickle.dumps(result))
    return result


def judge(options, repository, script):
    """Row of the table of one script: repository, script, outcome, detail."""
    text = closure(script)
    head = (repository, str(script.relative_to(options.folder / repository)))
    wants = []
    for index in range(len(options.opensees)):
        result = reference(options, index, script, text)
        if result[0] == 0 and has_numbers(result):
            wants.append(result)
            continue
        detail = "timeout" if result[0] == "timeout" else (result[2].strip().splitlines() or ["no numbers"])[0][:160]
    if not wants:
        return (*head, "OpenSees fails", detail)
    got = run(options.hysteron, script, text, 2 * options.limit)
    if got[0] == "timeout":
        return (*head, "timeout", "")
    if got[0] == 2:
        first = next((line for line in got[2].splitlines() if line.startswith("error")), got[2].strip()[:160])
        return (*head, "refused", first)
    if got[0] != 0:
        return (*head, "refused", f"status {got[0]}: {got[2].strip()[:160]}")
    modes = bool(re.search(r"\beigen\b", text))
    differences = [compare(want, got, options.tolerance, modes) for want in wants]
    return (*head, "equal", "") if "" in differences else (*head, "differs", min(differences, key=len))


def report(options, work, judge, outside, peer):
    """Judge scripts, print each outcome and the counts, and write the table by repository."""
    rows, fails = [], "OpenSees fails"
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(lambda w: judge(options, *w), work):
            rows.append(row)
            print(*row, sep="\t", flush=True)
    if options.csv:
        with options.csv.open("w", newline="") as out:
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(["repository", *OUTCOMES, fails])
            for name in sorted({row[0] for row in rows}):
                of = Counter(row[2] for row in rows if row[0] == name)
                writer.writerow([name, *(of[outcome] for outcome in (*OUTCOMES, fails))])
    counts = Counter(row[2] for row in rows)
    counted = [row for row in rows if row[2] != fails]
    print(f"{len(counted)} scripts of {len({row[0] for row in counted})} repositories count; "
          f"{peer} fails in {counts[fails]}; {outside} are out of scope")
    for outcome in OUTCOMES:
        print(f"{outcome}: {counts[outcome]} ({100 * counts[outcome] / max(1, len(counted)):.0f} %)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--hysteron", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--opensees", action="append", type=shlex.split, required=True)
    parser.add_argument("--each", type=int, default=10)
    parser.add_argument("--limit", type=float, default=60.0)
    parser.add_argument("--tolerance", type=float, default=1e-4)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="a regular expression for REPOSITORY/SCRIPT")
    parser.add_argument("--cache", type=Path)
    parser.add_argument("--csv", type=Path, help="table of the outcomes by repository")
    options = parser.parse_args()
    options.hysteron = [*shlex.split(options.hysteron), "run", "--compat", "opensees"]
    options.folder = options.folder.resolve()
    if options.cache:
        options.cache.mkdir(parents=True, exist_ok=True)
    work, outside = [], 0
    for repository in sorted(p for p in options.folder.iterdir() if p.is_dir()):
        found, out = entries(repository, options.each)
        outside += out
        work += [(repository.name, s) for s in found]
    work = [(r, s) for r, s in work if re.search(options.only, f"{r}/{s.relative_to(options.folder / r)}")]
    report(options, work, judge, outside, "OpenSees")


if __name__ == "__main__":
    sys.exit(main())
