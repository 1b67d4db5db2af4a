#!/usr/bin/env python3
"""The shipped isolation studies in the real OpenSees, peak by peak.

    validation/design/suite_in_opensees.py [--hysteron PROGRAM] [--opensees COMMAND] [--jobs N] [--write]

`hysteron isolate --scripts` writes a script for each analysis. Each runs in OpenSees with recorders of the bearings, and in
`hysteron run --compat opensees`. Peaks of both are compared with OpenSees' where it came to the end; it does not always converge
where hysteron does. --write renews suite_in_opensees.csv. COMMAND runs a Tcl script; the default is
`benches/peer.py run`, which installs openseespy.
"""
import argparse
import csv
import json
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STUDIES = ["isolation_study", "eight_storey_study", "bridge_study"]
# Recorders before the first step of a transient analysis.
RECORD = """
rename analyze plain_analyze
proc analyze {args} {
    if {[llength $args] >= 2 && ![info exists ::recorded]} {
        set ::recorded 1
        foreach {tag lower upper} {%s} {
            set dofs [expr {[llength [nodeCoord $upper]] == 3 ? {1 2 3} : {1 2}}]
            recorder Node -file %s/$tag.lower -node $lower -dof {*}$dofs disp
            recorder Node -file %s/$tag.upper -node $upper -dof {*}$dofs disp
            recorder Element -file %s/$tag.force -ele $tag globalForce
        }
    }
    uplevel 1 [linsert $args 0 plain_analyze]
}
"""


def rows(path):
    return [[float(x) for x in line.split()] for line in open(path) if line.strip()]


def peaks(folder, tag):
    """Displacement and shear as vector sums, largest and least compression of a bearing."""
    lower, upper, force = (rows(f"{folder}/{tag}.{what}") for what in ("lower", "upper", "force"))
    n = len(upper[0])
    half = len(force[0]) // 2
    length = lambda v: sum(x * x for x in v) ** 0.5
    displacement = max(length([u[i] - l[i] for i in range(n - 1)]) for u, l in zip(upper, lower))
    shear = max(length(f[half : half + n - 1]) for f in force)
    compression = [-f[half + n - 1] for f in force]
    return displacement, shear, max(compression), min(compression)


def run(command, script, outcome, nodes):
    """Peaks of the bearings by a program, and True if it came to the end of the script."""
    with tempfile.TemporaryDirectory() as work:
        listed = " ".join(f"{b['tag']} {nodes[b['tag']][0]} {nodes[b['tag']][1]}" for b in outcome["bearings"])
        path = Path(work) / "model.tcl"
        end = "\nwipe\nputs came-to-its-end\n"
        path.write_text(RECORD % (listed, work, work, work) + script.read_text() + end)
        done = subprocess.run([*command, str(path)], cwd=work, capture_output=True, text=True)
        if not (Path(work) / f"{outcome['bearings'][0]['tag']}.force").exists():
            sys.exit(f"{script.stem}: {done.stdout[-500:]}{done.stderr[-1500:]}")
        return [peaks(work, b["tag"]) for b in outcome["bearings"]], "came-to-its-end" in done.stdout


def analysis(args, study, script, outcome, nodes):
    theirs, complete = run(shlex.split(args.opensees), script, outcome, nodes)
    compat, _ = run([args.hysteron, "run", "--compat", "opensees"], script, outcome, nodes)
    ours = [(b["displacement"], b["shear"], b["compression"], b["least"]) for b in outcome["bearings"]]
    tags = [b["tag"] for b in outcome["bearings"]]
    return [(study, script.stem, outcome["motion"], *row, complete) for row in zip(tags, ours, compat, theirs)]


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
    with tempfile.TemporaryDirectory() as work:
        toml = ROOT / "tcl-like-inputs" / name / "study.toml"
        command = [args.hysteron, "isolate", str(toml), "--out", f"{work}/out", "--scripts", f"{work}/scripts"]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(done.stderr)
        scripts = sorted(Path(f"{work}/scripts").glob("*.tcl"))
        outcomes = [json.loads(Path(f"{work}/out/analyses/{s.stem}.json").read_text()) for s in scripts]
        nodes = ends_of_bearings(args, scripts[0], [b["tag"] for b in outcomes[0]["bearings"]], work)
        with ThreadPoolExecutor(args.jobs) as pool:
            tasks = [pool.submit(analysis, args, name, s, o, nodes) for s, o in zip(scripts, outcomes)]
            return [row for t in tasks for row in t.result()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hysteron", default=str(ROOT / "target/release/hysteron"))
    parser.add_argument("--opensees", default=f"{sys.executable} {ROOT}/benches/peer.py run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--write", action="store_true")
    args = parser.parse_args()
    all_rows = [row for name in STUDIES for row in study(args, name)]
    names = ["D", "V", "P max", "P min"]
    who = ("hysteron", "compat", "OpenSees")
    head = ["study", "analysis", "motion", "bearing", "OpenSees ended"] + [f"{n} {w}" for n in names for w in who]
    number = "{:.6g}".format
    table = [[s, a, m, t, "yes" if c else "no"] + [number(x) for k in range(4) for x in (o[k], q[k], p[k])] for s, a, m, t, o, q, p, c in all_rows]
    if args.write:
        with open(Path(__file__).with_suffix(".csv"), "w", newline="") as f:
            csv.writer(f, lineterminator="\n").writerows([head, *table])
    print("largest difference from OpenSees, as a share of the largest value of the quantity in its analysis (P min: of P max)")
    worst = 0.0
    for name in STUDIES:
        of_study = [r for r in all_rows if r[0] == name]
        mine = [r for r in of_study if r[-1]]
        scale = {(r[1], k): max(abs(q[4][min(k, 2)]) for q in mine if q[1] == r[1]) for r in mine for k in range(4)}
        ended, all_of = len({r[1] for r in mine}), len({r[1] for r in of_study})
        for k, quantity in enumerate(names):
            default, compat = (max(abs(r[w][k] - r[6][k]) / scale[r[1], k] for r in mine) for w in (4, 5))
            worst = max(worst, compat)
            print(f"{name:20s} {quantity:6s} {default:.1e}  compat {compat:.1e}  ({ended} of {all_of} analyses ended in OpenSees)")
    sys.exit(worst > 1e-3)


if __name__ == "__main__":
    main()
