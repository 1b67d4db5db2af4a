#!/usr/bin/env python3
"""How the cost of an analysis grows with steps, fibers, bearings, degrees of freedom and threads, beside OpenSees.

    benches/scaling.py [--opensees COMMAND] [--repeats N] [TABLE ...]

TABLE is one of steps, fibers, bearings, dofs, threads (all of them). COMMAND runs a Tcl script in OpenSees ("python -m opensees");
without it, openseespy of `peer.py` reads the script through Tcl of Python. Times are of the processor, the least of N runs (2), that of
an empty script taken off. What takes OpenSees more than a minute is left out.
"""
import argparse
import os
import resource
import shlex
import subprocess
import tempfile
from pathlib import Path

import calibrate
import peer

BINARY = os.environ.get("HYSTERON", peer.ROOT / "target/release/hysteron")
LIMIT = 60
BEARING = "elastomericBearingBoucWen {tag} {i} {j} 1800. 13. 0.2 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0"
EQUATIONS = "numberer Plain; system UmfPack; test NormDispIncr 1e-9 50; algorithm Newton\n"


def steps(n):
    """One bearing on a path of n steps."""
    return f"""model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 0.2; fix 1 1 1 1; fix 2 0 0 1
uniaxialMaterial Elastic 1 4e5; uniaxialMaterial Elastic 2 1e5
element {BEARING.format(tag=1, i=1, j=2)}
timeSeries Trig 1 0 1e9 1.5 -factor 0.1; pattern Plain 1 1 {{ sp 2 1 1.0 }}
constraints Transformation; {EQUATIONS}integrator LoadControl 0.01; analysis Static
puts [analyze {n}]; puts [eleResponse 1 force]"""


def fibers(n):
    """A cantilever of n fibers of Steel02 a section, five sections, pushed to and fro in 500 steps."""
    return f"""model basic -ndm 2 -ndf 3; node 1 0 0; node 2 0 3.; fix 1 1 1 1
uniaxialMaterial Steel02 1 350e3 2e8 0.01 18 0.925 0.15
section Fiber 1 {{ patch rect 1 {n} 1 -0.2 -0.1 0.2 0.1 }}
geomTransf PDelta 1; element forceBeamColumn 1 1 2 5 1 1
timeSeries Trig 1 0 1e9 2. -factor 0.06; pattern Plain 1 1 {{ sp 2 1 1.0 }}
constraints Transformation; {EQUATIONS}integrator LoadControl 0.01; analysis Static
puts [analyze 500]; puts [eleResponse 1 force]"""


def bearings(n):
    """n bearings side by side below an elastic beam of n - 1 spans, shaken in 500 steps."""
    spans = "\n".join(f"element elasticBeamColumn {1000 + i} {1000 + i} {1000 + i + 1} 0.2 3e7 4e-3 1" for i in range(1, n))
    nodes = "\n".join(f"node {i} {5 * i} 0; node {1000 + i} {5 * i} 0.2; fix {i} 1 1 1; mass {1000 + i} 100 100 1\n"
                      f"element {BEARING.format(tag=i, i=i, j=1000 + i)}" for i in range(1, n + 1))
    return f"""model basic -ndm 2 -ndf 3; uniaxialMaterial Elastic 1 4e5; uniaxialMaterial Elastic 2 1e5; geomTransf Linear 1
{nodes}
{spans}
timeSeries Trig 1 0 1e9 1.5 -factor 4.; pattern UniformExcitation 1 1 -accel 1
constraints Plain; {EQUATIONS}integrator Newmark 0.5 0.25; analysis Transient
puts [analyze 500 0.01]; puts [nodeDisp {1000 + 1}]"""


def run(command, text):
    """Processor time and the numbers that a script prints; None beyond the limit."""
    with tempfile.TemporaryDirectory() as place:
        script = Path(place) / "model.tcl"
        script.write_text(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run([*command, script], cwd=place, capture_output=True, text=True, timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return took, [float(word) for word in done.stdout.split() if word.strip("-0123456789.e+") == ""]


def table(title, texts, per, both, repeats):
    """A row for each size: its time in both, what each thing of `per` costs, the ratio and how far the results are apart."""
    start = [min(run(command, "puts 0\n")[0] for _ in range(3)) for command in both]
    print(f"\n{title}\n\n| size | hysteron | each | OpenSees | ratio | apart |\n| --- | --- | --- | --- | --- | --- |")
    too_long = False
    for size, text in texts:
        found = []
        for command, begun in zip(both, start):
            runs = [] if too_long and command is both[1] else [run(command, text) for _ in range(repeats)]
            runs = [r for r in runs if r]
            found.append((min(r[0] for r in runs) - begun, runs[0][1]) if runs else None)
        too_long = found[1] is None
        (took, ours), theirs = found[0], found[1]
        row = f"| {size:,} | {took:.3f} s | {1e9 * took / per(size):,.0f} ns |"
        if theirs:
            peak = max(map(abs, theirs[1]))
            row += f" {theirs[0]:.2f} s | {theirs[0] / took:.0f} | {max(abs(a - b) for a, b in zip(ours, theirs[1])) / peak:.0e} |"
        print(row if theirs else row + " | | |", flush=True)


def threads():
    """Evaluations of a study a second."""
    path = calibrate.np.array(calibrate.motion(calibrate.BEARINGS["plane"][1]))
    print("\nA study of 7550 evaluations of 1800 steps\n\n| threads | ms an evaluation | ms of the processor |\n| --- | --- | --- |")
    with tempfile.TemporaryDirectory() as place:
        calibrate.write_study(Path(place), "plane", path.tolist(), 10 * path / abs(path).max())
        for count in range(1, len(os.sched_getaffinity(0)) + 1):
            result, cpu = calibrate.ours(Path(place), count)
            print(f"| {count} | {1e3 * result['wall_s'] / result['evaluations']:.3f} | {1e3 * cpu:.3f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--opensees")
    parser.add_argument("--repeats", type=int, default=2)
    parser.add_argument("tables", nargs="*", default=["steps", "fibers", "bearings", "dofs", "threads"])
    args = parser.parse_args()
    theirs = shlex.split(args.opensees) if args.opensees else [peer.peer_python(), Path(__file__).with_name("peer_tcl.py")]
    both = [[BINARY, "run", "--quiet"], theirs]
    frame = (peer.ROOT / "benches/large_frame.tcl").read_text()
    # The times that the script prints are no results, and modes beside bearings are others in OpenSees.
    frame = frame.replace(" [lap]", "").replace('puts "periods', "set periods \"")
    sized = [(n, frame.replace("set bays 40; set storeys 4", f"set bays {n}; set storeys 4")) for n in (2, 4, 8, 16)]
    dofs = {n: 6 * (n + 1) ** 2 * 5 for n, _ in sized}
    tables = {
        "steps": ("Steps of one bearing", [(n, steps(n)) for n in (1000, 10000, 100000)], lambda n: n),
        "fibers": ("Fibers a section, for each of 2,500 sections and steps", [(n, fibers(n)) for n in (10, 40, 160, 640)], lambda n: 2500 * n),
        "bearings": ("Bearings, for each of 500 steps", [(n, bearings(n)) for n in (1, 4, 16, 64, 256)], lambda n: 500 * n),
        "dofs": ("Degrees of freedom: gravity, ten modes, twenty steps", [(dofs[n], text) for n, text in sized], lambda n: n),
    }
    for name in args.tables:
        if name == "threads":
            threads()
        else:
            table(*tables[name], both, args.repeats)


if __name__ == "__main__":
    main()
