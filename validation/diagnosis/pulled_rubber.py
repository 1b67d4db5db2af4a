#!/usr/bin/env python3
"""Writes the forces of a lead rubber bearing that is pulled and pressed, with and without cavitation, as openseespy has them.

    python3 validation/diagnosis/pulled_rubber.py tests/verdicts/pulled_rubber.csv

The bearing has 25 layers of 8 mm with a diameter of 0.65 m, a lead core of 0.16 m and a shear modulus of 0.45 MPa. Needs openseespy
(3.7.1 wrote the file of the tests).
"""

import math
import sys

import openseespy.opensees as ops

DT, STEPS, SECONDS = 0.02, 4, 6.0


def path(phase, periods):
    """Extensions, m: waves that begin and end at rest, and less in compression, where the bearing is stiff."""
    at = []
    for i in range(306):
        t = DT * i
        shape = math.sin(math.pi * min(t, SECONDS) / SECONDS) ** 0.7 if t < SECONDS else 0.0
        waves = sum(math.sin(2 * math.pi * t / p + phase * (k + 1.3) ** 2) for k, p in enumerate(periods))
        x = 0.003 * shape * waves / math.sqrt(len(periods))
        at.append(x if x > 0 else 0.2 * x)
    return at


def forces(at, cavitates):
    """Axial forces, N."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, 0.3)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 1, 0, 1, 1, 1)
    rubber = [0.16, 0.65, 0.003, 0.008, 25]
    heat = [0.0, 0.005, 11200.0, 130.0, 50.0, 1.41e-5]
    ops.element("LeadRubberX", 1, 1, 2, 2e5, 0.1, 0.45e6, 2e9, *rubber, 0, 0, 1, 1, 0, 0, 10.0, 0.75, 1.0, 0.5, 0.0, *heat, int(cavitates), 0, 0, 0, 0)
    ops.timeSeries("Path", 1, "-dt", DT, "-values", *at)
    ops.pattern("Plain", 1, 1)
    ops.sp(2, 3, 1.0)
    ops.constraints("Transformation")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", 1e-9, 100)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", DT / STEPS)
    ops.analysis("Static")
    out = [0.0]
    for _ in at[1:]:
        if ops.analyze(STEPS):
            raise SystemExit("no convergence")
        out.append(ops.eleForce(1)[8])
    return out


def main():
    with open(sys.argv[1], "w") as f:
        f.write("run,extension[mm],holds[kN],cavitates[kN]\n")
        for run, phase, periods in (("strong", 1.0, [1.6, 1.1]), ("others", 2.2, [1.4, 0.7])):
            at = path(phase, periods)
            for x, a, b in zip(at, forces(at, False), forces(at, True)):
                f.write(f"{run},{1e3 * x + 0.0:.5g},{a / 1e3 + 0.0:.5g},{b / 1e3 + 0.0:.5g}\n")


if __name__ == "__main__":
    main()
