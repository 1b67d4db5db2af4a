#!/usr/bin/env python3
"""Loops and queries from Python, with openseespy and with hysteron in one run.

    benches/python_loops.py

Needs a Python with openseespy and hysteron. Each program runs in a process of its own, the two in turn, --repeats times; the table has
the medians of the processor time. A loop makes 1,000 steps with queries between them, as scripts do; the sums of the answers must agree.
"""
import argparse
import json
import statistics
import subprocess
import sys
import time


def column(ops, stories):
    """A column of elastic beams under a moving load: 3 equations a story."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    for i in range(stories + 1):
        ops.node(i + 1, 0.0, 3.0 * i)
        ops.mass(i + 1, 1.0, 1.0, 1e-6)
    ops.fix(1, 1, 1, 1)
    ops.geomTransf("Linear", 1)
    for i in range(stories):
        ops.element("elasticBeamColumn", i + 1, i + 1, i + 2, 0.01, 2e8, 1e-4, 1)
    ops.timeSeries("Trig", 1, 0.0, 100.0, 0.5)
    ops.pattern("Plain", 1, 1)
    ops.load(stories + 1, 10.0, 0.0, 0.0)
    ops.rayleigh(0.1, 0.0, 0.0, 0.001)
    return 3


def isolated(ops, stories):
    """Masses on springs with hysteresis: 1 equation a story."""
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    for i in range(stories + 1):
        ops.node(i + 1, 0.0)
        ops.mass(i + 1, 1.0)
    ops.fix(1, 1)
    for i in range(stories):
        ops.uniaxialMaterial("Steel01", i + 1, 5.0 + i, 400.0, 0.1)
        ops.element("zeroLength", i + 1, i + 1, i + 2, "-mat", i + 1, "-dir", 1)
    ops.timeSeries("Trig", 1, 0.0, 100.0, 0.8)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    return 1


def fibers(ops, stories):
    """A column whose sections have fibers that yield: 3 equations a story."""
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.uniaxialMaterial("Steel01", 1, 3e5, 2e8, 0.02)
    ops.section("Fiber", 1)
    ops.patch("rect", 1, 20, 1, -0.15, -0.1, 0.15, 0.1)
    ops.beamIntegration("Lobatto", 1, 1, 3)
    ops.geomTransf("Linear", 1)
    for i in range(stories + 1):
        ops.node(i + 1, 0.0, 3.0 * i)
        ops.mass(i + 1, 10.0, 10.0, 1e-3)
    ops.fix(1, 1, 1, 1)
    for i in range(stories):
        ops.element("forceBeamColumn", i + 1, i + 1, i + 2, 1, 1)
    ops.timeSeries("Trig", 1, 0.0, 100.0, 0.5)
    ops.pattern("Plain", 1, 1)
    ops.load(stories + 1, 400.0 / stories, 0.0, 0.0)
    return 3


def transient(ops):
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("BandGeneral")
    ops.test("NormUnbalance", 1e-8, 20)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def loop(ops, build, stories, steps):
    """Seconds of a loop with queries, and the sum of what they gave."""
    build(ops, stories)
    transient(ops)
    total, began = 0.0, time.process_time()
    for _ in range(steps):
        ops.analyze(1, 0.01)
        total += ops.nodeDisp(stories + 1, 1) + ops.nodeVel(stories + 1, 1) + ops.eleForce(1, 1)
    return time.process_time() - began, total


def measure(ops):
    out = {}
    for name, build, stories in [
        ("hysteretic, 1 equation", isolated, 1), ("hysteretic, 10 equations", isolated, 10), ("hysteretic, 40 equations", isolated, 40),
        ("elastic, 3 equations", column, 1), ("elastic, 15 equations", column, 5), ("elastic, 48 equations", column, 16), ("fibers, 3 equations", fibers, 1), ("fibers, 15 equations", fibers, 5),
    ]:  # fmt: skip
        out["loop: " + name] = loop(ops, build, stories, 1000)
    began = time.process_time()
    for _ in range(200):
        column(ops, 10)
    out["building, 10 elements"] = (time.process_time() - began) / 200, 0.0
    transient(ops)
    ops.analyze(3, 0.01)
    ops.reactions()
    queries = {
        "nodeDisp(n, d)": lambda: ops.nodeDisp(5, 1), "nodeDisp(n)": lambda: ops.nodeDisp(5), "nodeVel(n, d)": lambda: ops.nodeVel(5, 1),
        "nodeReaction(n, d)": lambda: ops.nodeReaction(1, 1), "eleForce(e, d)": lambda: ops.eleForce(3, 1),
        "eleResponse(e, 'force')": lambda: ops.eleResponse(3, "force"), "getTime()": ops.getTime, "getNodeTags()": ops.getNodeTags,
        "nodeCoord(n)": lambda: ops.nodeCoord(5), "eleNodes(e)": lambda: ops.eleNodes(3),
    }  # fmt: skip
    for name, query in queries.items():
        began = time.process_time()
        for _ in range(20_000):
            query()
        out["query: " + name] = (time.process_time() - began) / 20_000, 0.0
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=5)
    parser.add_argument("--of", choices=["openseespy", "hysteron"], help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.of:
        module = __import__(f"{options.of}.opensees", fromlist=["opensees"])
        print(json.dumps(measure(module)))
        return 0
    found = {"openseespy": [], "hysteron": []}
    for _ in range(options.repeats):
        for name, results in found.items():
            done = subprocess.run([sys.executable, __file__, "--of", name], capture_output=True, text=True, check=True)
            results.append(json.loads(done.stdout.splitlines()[0]))
    ratios = {"loop": [], "quer": []}
    print(f"{'':34}{'openseespy':>12}{'hysteron':>12}{'ratio':>8}")
    for name in found["openseespy"][0]:
        (theirs, ours), sums = zip(*[(statistics.median(r[name][0] for r in results), results[0][name][1]) for results in found.values()])
        assert abs(sums[0] - sums[1]) <= 1e-6 * max(1.0, abs(sums[0])), (name, sums)
        ratios.setdefault(name[:4], []).append(theirs / ours)
        print(f"{name:34}{1e6 * theirs:9.2f} µs{1e6 * ours:9.2f} µs{theirs / ours:8.1f}")
    print(f"median of the loops {statistics.median(ratios['loop']):.1f}, of the queries {statistics.median(ratios['quer']):.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
