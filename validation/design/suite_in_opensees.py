#!/usr/bin/env python3
"""The shipped isolation studies in the real OpenSees, peak by peak.

    validation/design/suite_in_opensees.py [--hysteron PROGRAM] [--opensees COMMAND] [--jobs N] [--study NAME] [--bound NAME] [--work DIR] [--write]

`hysteron isolate --scripts` writes a script for each analysis. Each runs in OpenSees with recorders of bearings and floors, and in
`hysteron run --compat opensees`. Peaks of both are compared with OpenSees': bearings, shear of all bearings, storey drifts, floor
accelerations. Where OpenSees' Newton iteration fails, all three run once more with steps of 1/2, then of 1/4. With --work the
results of `isolate` are kept in DIR, and those that are current are used again. --write renews
suite_in_opensees.csv (bearings) and suite_in_opensees.md (largest differences of each analysis). COMMAND runs a Tcl script; the
default is `benches/peer.py run`, which installs openseespy.
"""
import argparse
import csv
import json
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ["isolation_study", "eight_storey_study", "bridge_study"]
BOUNDS = ["lower", "nominal", "upper"]
NAMES = ["D", "V", "P max", "P min", "V base", "drift", "acceleration"]
# Recorders before the first step of a transient analysis, whose steps are divided.
RECORD = """
rename analyze plain_analyze
proc analyze {args} {
    if {[llength $args] < 2} { return [uplevel 1 [linsert $args 0 plain_analyze]] }
    if {![info exists ::recorded]} {
        set ::recorded 1
        foreach {tag lower upper} {%(bearings)s} {
            set dofs [expr {[llength [nodeCoord $upper]] == 3 ? {1 2 3} : {1 2}}]
            recorder Node -file %(work)s/$tag.lower -node $lower -dof {*}$dofs disp
            recorder Node -file %(work)s/$tag.upper -node $upper -dof {*}$dofs disp
            recorder Element -file %(work)s/$tag.force -ele $tag globalForce
        }
        set start [open %(work)s/start w]
        foreach node {%(floors)s} {
            puts $start [nodeDisp $node]
            set dofs [expr {[llength [nodeCoord $node]] == 3 ? {1 2} : {1}}]
            recorder Node -file %(work)s/$node.disp -time -node $node -dof {*}$dofs disp
            recorder Node -file %(work)s/$node.accel -time -node $node -dof {*}$dofs accel
        }
    }
    if {[info exists start]} { close $start }
    lassign $args n dt
    return [plain_analyze [expr {$n*%(parts)d}] [expr {double($dt)/%(parts)d}]]
}
"""


def rows(path):
    return [[float(x) for x in line.split()] for line in open(path) if line.strip()]


def length(v):
    return sum(x * x for x in v) ** 0.5


def bearing_peaks(folder, tag):
    """Displacement and shear as vector sums, largest and least compression of a bearing; its shears over time."""
    lower, upper, force = (rows(f"{folder}/{tag}.{what}") for what in ("lower", "upper", "force"))
    n = len(upper[0])
    half = len(force[0]) // 2
    displacement = max(length([u[i] - l[i] for i in range(n - 1)]) for u, l in zip(upper, lower))
    shears = [f[half : half + n - 1] for f in force]
    compression = [-f[half + n - 1] for f in force]
    return (displacement, max(map(length, shears)), max(compression), min(compression)), shears


def ground(script):
    """Step and components of the motion in a script of an analysis, in the script's unit."""
    value = lambda name: re.search(r"set {isolate\(%s\)} {([^}]*)}" % name, script).group(1)
    return float(value("dt")), [[float(x) for x in value(name).split()] for name in ("ax", "ay")]


def floor_peaks(folder, script, floors, gravity):
    """Largest storey drift ratios from the state under gravity and absolute floor accelerations in g, in either direction."""
    start = rows(f"{folder}/start")
    disp, accel = ([rows(f"{folder}/{node}.{what}") for node, _ in floors] for what in ("disp", "accel"))
    dt, motion = ground(script)
    at = lambda a, x: a[int(x)] + (a[int(x) + 1] - a[int(x)]) * (x - int(x)) if int(x) + 1 < len(a) else 0.0
    drifts, tops = [], []
    for k, (_, height) in enumerate(floors):
        width = len(disp[k][0]) - 1
        absolute = (abs(row[1 + d] + at(motion[d], row[0] / dt)) for row in accel[k] for d in range(width))
        tops.append(max(absolute) / gravity)
        if k:
            pairs = zip(disp[k], disp[k - 1])
            before = [start[k][d] - start[k - 1][d] for d in range(width)]
            drifts.append(max(abs(a[1 + d] - b[1 + d] - before[d]) for a, b in pairs for d in range(width)) / height)
    return drifts, tops


def run(command, script, outcome, nodes, floors, parts):
    """Peaks by a program, and True if it came to the end of the script."""
    with tempfile.TemporaryDirectory() as work:
        listed = " ".join(f"{b['tag']} {nodes[b['tag']][0]} {nodes[b['tag']][1]}" for b in outcome["bearings"])
        path = Path(work) / "model.tcl"
        end = "\nwipe\nputs came-to-its-end\n"
        values = {"bearings": listed, "work": work, "floors": " ".join(str(n) for n, _ in floors["nodes"]), "parts": parts}
        path.write_text(RECORD % values + script.read_text() + end)
        done = subprocess.run([*command, str(path)], cwd=work, capture_output=True, text=True)
        if not (Path(work) / f"{outcome['bearings'][0]['tag']}.force").exists():
            sys.exit(f"{script.stem}: {done.stdout[-500:]}{done.stderr[-1500:]}")
        found = [bearing_peaks(work, b["tag"]) for b in outcome["bearings"]]
        base = max(length([sum(s[d] for s in step) for d in range(len(step[0]))]) for step in zip(*(shears for _, shears in found)))
        drifts, tops = floor_peaks(work, script.read_text(), floors["nodes"], floors["gravity"]) if floors["nodes"] else ([], [])
        return {"bearings": [p for p, _ in found], "base": base, "drifts": drifts, "tops": tops}, "came-to-its-end" in done.stdout


def difference(a, b):
    """Largest differences of two results, as shares of the largest value of a quantity."""
    out = []
    for k in range(4):
        scale = max(abs(row[min(k, 2)]) for row in b["bearings"])
        out.append(max(abs(x[k] - y[k]) for x, y in zip(a["bearings"], b["bearings"])) / scale)
    out.append(abs(a["base"] - b["base"]) / b["base"])
    for key in ("drifts", "tops"):
        out.append(max((abs(x - y) for x, y in zip(a[key], b[key])), default=0.0) / max(b[key], default=1.0))
    return out


def analysis(args, study, script, outcome, nodes, floors):
    compat = [args.hysteron, "run", "--compat", "opensees"]
    own = {
        "bearings": [(b["displacement"], b["shear"], b["compression"], b["least"]) for b in outcome["bearings"]],
        "base": outcome["base_shear"],
        "drifts": outcome["drifts"],
        "tops": outcome["accelerations"],
    }
    for parts in (1, 2, 4):
        theirs, complete = run(shlex.split(args.opensees), script, outcome, nodes, floors, parts)
        if complete:
            break
    ours = own if parts == 1 else run([args.hysteron, "run"], script, outcome, nodes, floors, parts)[0]
    followed, _ = run(compat, script, outcome, nodes, floors, parts)
    steps = ("1" if parts == 1 else f"1/{parts}") if complete else "fails"
    tags = [b["tag"] for b in outcome["bearings"]]
    bearings = [(study, script.stem, outcome["motion"], t, steps, *rows) for t, *rows in zip(tags, ours["bearings"], followed["bearings"], theirs["bearings"])]
    return bearings, (study, script.stem, outcome["motion"], steps, difference(ours, theirs), difference(followed, theirs))


def ends_of_bearings(args, script, tags, work):
    """Nodes of the bearings, from the model itself."""
    path = Path(work) / "ends.tcl"
    path.write_text(
        "rename analyze plain_analyze\nproc analyze {args} {\n if {[llength $args] >= 2} {\n  foreach tag {%s} {puts \"ends $tag "
        "[eleNodes $tag]\"}\n  exit\n }\n uplevel 1 [linsert $args 0 plain_analyze]\n}\n%s" % (" ".join(map(str, tags)), script.read_text())
    )
    done = subprocess.run([args.hysteron, "run", str(path)], cwd=work, capture_output=True, text=True)
    lines = [line.split() for line in done.stdout.splitlines() if line.startswith("ends ")]
    return {int(w[1]): (w[2], w[3]) for w in lines}


def study(args, name):
    with tempfile.TemporaryDirectory() as scratch:
        work = args.work / name if args.work else Path(scratch)
        work.mkdir(parents=True, exist_ok=True)
        toml = ROOT / "tcl-like-inputs" / name / "study.toml"
        command = [args.hysteron, "isolate", str(toml), "--resume", "--out", f"{work}/out", "--scripts", f"{work}/scripts"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        print(name, *done.stderr.strip().splitlines()[-1:], flush=True)
        scripts = sorted(s for s in (work / "scripts").glob("*.tcl") if s.stem.split("_")[0] in args.bound)
        outcomes = [json.loads(Path(f"{work}/out/analyses/{s.stem}.json").read_text()) for s in scripts]
        nodes = ends_of_bearings(args, scripts[0], [b["tag"] for b in outcomes[0]["bearings"]], scratch)
        stated = tomllib.loads(toml.read_text())
        floors = {"nodes": [(f["node"], f.get("height", 0.0)) for f in stated.get("floor", [])], "gravity": stated["gravity"]}
        with ThreadPoolExecutor(args.jobs) as pool:
            tasks = [pool.submit(analysis, args, name, s, o, nodes, floors) for s, o in zip(scripts, outcomes)]
            return [t.result() for t in tasks]


def written(folder, results, bounds):
    number = "{:.6g}".format
    who = ("hysteron", "compat", "OpenSees")
    head = ["study", "analysis", "motion", "bearing", "steps"] + [f"{n} {w}" for n in NAMES[:4] for w in who]
    with open(folder.with_suffix(".csv"), "w", newline="") as f:
        table = csv.writer(f, lineterminator="\n")
        table.writerow(head)
        for bearings, _ in results:
            table.writerows([s, a, m, t, c] + [number(x) for k in range(4) for x in (o[k], q[k], p[k])] for s, a, m, t, c, o, q, p in bearings)
    out = "# Largest differences from OpenSees\n\n"
    out += f"`suite_in_opensees.py --write {' '.join('--bound ' + b for b in bounds)}` makes this page. Each number is the largest difference of a quantity in an analysis, over the "
    out += "largest value of the quantity in that analysis (`P min` over `P max`). Steps: those of the script, or a part of them where "
    out += "OpenSees' iteration fails. Base shear, drifts of storeys and accelerations of floors are those of `hysteron isolate`.\n"
    for title, which in (("The default", 4), ("`--compat opensees`", 5)):
        out += f"\n## {title}\n\n| study | analysis | motion | steps | {' | '.join(NAMES)} |\n" + "| --- " * (4 + len(NAMES)) + "|\n"
        for _, row in results:
            cells = [f"{x:.0e}" if x else "0" for x in row[which]] if row[3] != "fails" else ["-"] * len(NAMES)
            out += f"| {' | '.join([*row[:4], *cells])} |\n"
    folder.with_suffix(".md").write_text(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hysteron", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--opensees", default=f"{sys.executable} {ROOT}/benches/peer.py run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--study", action="append", choices=STUDIES)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--bound", action="append", choices=BOUNDS)
    parser.add_argument("--work", type=Path)
    args = parser.parse_args()
    args.bound = args.bound or BOUNDS
    results = [row for name in args.study or STUDIES for row in study(args, name)]
    if args.write:
        written(Path(__file__), results, args.bound)
    print("largest difference from OpenSees, as a share of the largest value of the quantity in its analysis (P min: of P max)")
    worst = 0.0
    for name in args.study or STUDIES:
        mine = [r for _, r in results if r[0] == name]
        ended = [r for r in mine if r[3] != "fails"]
        for k, quantity in enumerate(NAMES):
            default, compat = (max(r[w][k] for r in ended) for w in (4, 5))
            worst = max(worst, compat)
            print(f"{name:20s} {quantity:12s} {default:.1e}  compat {compat:.1e}  ({len(ended)} of {len(mine)} analyses ended in OpenSees)")
    sys.exit(worst > 1e-3)


if __name__ == "__main__":
    main()
