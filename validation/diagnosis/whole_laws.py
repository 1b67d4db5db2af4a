#!/usr/bin/env python3
"""Writes the forces of a lead rubber bearing and of a friction pendulum, with and without their further effects, as openseespy has them.

    python3 validation/diagnosis/whole_laws.py tests/verdicts/whole_laws.csv

The motion has two bursts with a pause, in which a warm device cools. Needs openseespy (3.7.1 wrote the file of the tests).
"""

import math
import sys

import openseespy.opensees as ops

DT, PAUSE = 0.05, 20.0
WEIGHT = 5e5
RUNS = (("strong", 1.0, 6.0, [(0.12, 2.0), (0.05, 1.3)]), ("others", 2.2, 5.0, [(0.10, 1.7), (0.06, 1.1)]))


def path(phase, seconds, waves):
    """Displacements, m: a burst, a pause, and the burst again."""
    at = []
    for i in range(round((2 * seconds + PAUSE) / DT) + 8):
        t = DT * i
        if t > seconds:
            t = max(t - seconds - PAUSE, 0.0)
        shape = math.sin(math.pi * t / seconds) ** 0.7 if 0 < t < seconds else 0.0
        at.append(shape * sum(a * math.sin(2 * math.pi * t / p + phase * k) for k, (a, p) in enumerate(waves)))
    return at


def nodes(height):
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, height)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 1, 0, 1, 1, 1)


def analysis():
    ops.constraints("Transformation")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.test("NormDispIncr", 1e-9, 100)
    ops.algorithm("Newton")


def lead(heats):
    """25 layers of 8 mm, a diameter of 0.65 m, a lead core of 0.16 m, a shear modulus of 0.45 MPa."""
    nodes(0.3)
    rubber = [0.16, 0.65, 0.003, 0.008, 25]
    heat = [0.0, 0.005, 11200.0, 130.0, 50.0, 1.41e-5]
    ops.element("LeadRubberX", 1, 1, 2, 2e5, 0.1, 0.45e6, 2e9, *rubber, 0, 0, 1, 1, 0, 0, 10.0, 0.75, 1.0, 0.5, 0.0, *heat, 0, 0, 0, 0, int(heats))


def slider(further):
    """A radius of 2 m, a coefficient of 0.08; `further` are pressure, temperature and speed."""
    nodes(0.0)
    ops.uniaxialMaterial("Elastic", 1, 1e10)
    ops.uniaxialMaterial("Elastic", 2, 1e8)
    on = int(further)
    materials = [1, 2, 2, 2, 0, 0, 1, 1, 0, 0]
    ops.element("FPBearingPTV", 1, 1, 2, 0.08, on, 50e6, on, 0.444e-5, 18.0, on, 100.0, 2.0, 0.1, 5e7, *materials, 0.0, 0, 0.0, 25, 1e-8, 1)
    ops.timeSeries("Linear", 9)
    ops.pattern("Plain", 9, 9)
    ops.load(2, 0.0, 0.0, -WEIGHT, 0.0, 0.0, 0.0)
    analysis()
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    if ops.analyze(10):
        raise SystemExit("no convergence")
    ops.loadConst("-time", 0.0)
    ops.wipeAnalysis()


def forces(at, device, steps):
    """Shear forces, kN, of a device under a motion with its velocity."""
    device()
    last = len(at) - 1
    speed = [(at[min(i + 1, last)] - at[max(i - 1, 0)]) / (2 * DT) for i in range(len(at))]
    ops.timeSeries("Path", 1, "-dt", DT, "-values", *at)
    ops.timeSeries("Path", 2, "-dt", DT, "-values", *speed)
    ops.pattern("MultipleSupport", 1)
    ops.groundMotion(1, "Plain", "-disp", 1, "-vel", 2)
    ops.imposedMotion(2, 1, 1)
    analysis()
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    out = [0.0]
    for _ in at[1:]:
        if ops.analyze(steps, DT / steps):
            raise SystemExit("no convergence")
        out.append(ops.eleForce(1)[6] / 1e3)
    return out


def main():
    with open(sys.argv[1], "w") as f:
        f.write("run,displacement[mm],lead[kN],warm lead[kN],slider[kN],warm fast slider[kN]\n")
        for run, phase, seconds, waves in RUNS:
            at = path(phase, seconds, waves)
            leads = [forces(at, lambda on=on: lead(on), 20) for on in (False, True)]
            sliders = [forces(at, lambda on=on: slider(on), 8) for on in (False, True)]
            for row in zip([1e3 * x for x in at], *leads, *sliders):
                f.write(",".join([run, *(f"{x + 0.0:.5g}" for x in row)]) + "\n")


if __name__ == "__main__":
    main()
