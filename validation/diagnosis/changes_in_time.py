#!/usr/bin/env python3
"""Cases of a condition that changes within a run, and cases that look like it.

    python3 validation/diagnosis/changes_in_time.py --out results/changes
    python3 validation/diagnosis/folders.py --engine target/release/hysteron --out results/answers results/changes

Recordings follow formulas of their own: Bouc-Wen's equation in its rate form by small steps of Runge and Kutta, and a frame by the same. Each
case is a folder with its script, its study and its truth.
"""

import argparse
import json
import math
import os
import random

DAMPER = """wipe
model basic -ndm 1 -ndf 1
pset Q {Q}
pset K {K}
pset uy {uy}
node 1 0.0
node 2 0.0
fix 1 1
uniaxialMaterial Elastic 1 $K
uniaxialMaterial BoucWen 2 0.0 [expr {{$Q/$uy}}] 1.0 [expr {{0.5/$uy}}] [expr {{0.5/$uy}}] 1.0 0.0 0.0 0.0
uniaxialMaterial Parallel 3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {{ sp 2 1 1.0 }}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
test NormDispIncr 1e-10 50
algorithm Newton
integrator LoadControl $dt
analysis Static
if {{[analyze [expr {{$npts-1}}]] != 0}} {{ error "no convergence" }}
"""

FRAME = """wipe
model basic -ndm 1 -ndf 1
pset k1 {k1}
pset k2 {k2}
node 1 0.0
node 2 0.0 -mass 1.0
node 3 0.0 -mass 0.8
fix 1 1
uniaxialMaterial Elastic 1 $k1
uniaxialMaterial Elastic 2 $k2
uniaxialMaterial Viscous 3 0.8 1.0
uniaxialMaterial Parallel 4 1 3
uniaxialMaterial Parallel 5 2 3
element zeroLength 1 1 2 -mat 4 -dir 1
element zeroLength 2 2 3 -mat 5 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 -dof 1 disp
constraints Plain
system FullGeneral
test NormDispIncr 1e-10 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {{[analyze [expr {{$npts-1}}] $dt] != 0}} {{ error "no convergence" }}
"""

PARTS = 20


def damper(motion, dt, strength, stiffness=0.9, yields=1.5):
    """Force of K u + Q z with dz/du = (1 - |z| (0.5 sign(z du) + 0.5)) / uy; `strength` is a function of time, work and force so far."""
    z, force, work, out = 0.0, 0.0, 0.0, []
    for i, u in enumerate(motion):
        q = strength(i * dt, work)
        du = (u - motion[i - 1]) / PARTS if i else 0.0
        for _ in range(PARTS if i else 0):
            def slope(z):
                return du / yields * (1.0 - abs(z) * (0.5 * math.copysign(1.0, z * du) + 0.5))
            a = slope(z)
            b = slope(z + 0.5 * a)
            c = slope(z + 0.5 * b)
            z += (a + 2.0 * b + 2.0 * c + slope(z + c)) / 6.0
            work += abs(q * z * du)
        force = stiffness * u + q * z
        out.append(force)
    return out


def frame(motion, dt, stiffness):
    """Displacements of two storeys on the ground acceleration; `stiffness` gives both stiffnesses at a time."""
    masses, c = (1.0, 0.8), 0.8
    def rate(t, y):
        i = min(int(t / dt), len(motion) - 2)
        ground = motion[i] + (motion[i + 1] - motion[i]) * (t / dt - i)
        k1, k2 = stiffness(t)
        first = k1 * y[0] + c * y[2]
        second = k2 * (y[1] - y[0]) + c * (y[3] - y[2])
        return (y[2], y[3], (second - first) / masses[0] - ground, -second / masses[1] - ground)
    y, out = (0.0,) * 4, []
    for i in range(len(motion)):
        out.append((y[0], y[1]))
        h = dt / 4
        for part in range(4):
            t = i * dt + part * h
            def at(k, s):
                return tuple(a + s * h * b for a, b in zip(y, k))
            k1 = rate(t, y)
            k2 = rate(t + h / 2, at(k1, 0.5))
            k3 = rate(t + h / 2, at(k2, 0.5))
            k4 = rate(t + h, at(k3, 1.0))
            y = tuple(a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4))
    return out


def sweep(n, dt, size, low, high):
    return [size * math.sin(2 * math.pi * (low + (high - low) * i / n / 2) * i * dt) for i in range(n)]


def growing(n, dt, size, frequency):
    return [size * (0.3 + 0.7 * i / n) * math.sin(2 * math.pi * frequency * i * dt) for i in range(n)]


def shaking(n, dt, size, seed):
    """Sum of sines of random phases under an envelope."""
    r = random.Random(seed)
    waves = [(r.uniform(0.5, 6.0), r.uniform(0, 2 * math.pi)) for _ in range(24)]
    length = n * dt
    def at(t):
        envelope = min(1.0, t / 2.0) * min(1.0, (length - t) / 4.0)
        return size * envelope * sum(math.sin(2 * math.pi * f * t + p) for f, p in waves) / 5.0
    return [at(i * dt) for i in range(n)]


class Case:
    def __init__(self, name, truth, script, parameters, dt, outputs):
        self.name, self.truth, self.script, self.parameters, self.dt, self.outputs = name, truth, script, parameters, dt, outputs
        self.runs = []

    def write(self, out):
        folder = os.path.join(out, self.name)
        os.makedirs(folder, exist_ok=True)
        def put(name, text):
            with open(os.path.join(folder, name), "w") as f:
                f.write(text)
        put("model.tcl", self.script)
        put("truth.json", json.dumps(self.truth, indent=1) + "\n")
        study = 'model = "model.tcl"\n'
        for name, low, high in self.parameters:
            study += f'[[parameter]]\nname = "{name}"\nlower = {low}\nupper = {high}\n'
        for name, role, motion, channels in self.runs:
            put(f"{name}.dat", "".join(f"{x:.9g}\n" for x in motion))
            rows = zip(*channels)
            head = "time[s]," + ",".join(n for n, *_ in self.outputs)
            put(f"{name}.csv", head + "\n" + "".join(f"{i * self.dt:.6g}," + ",".join(f"{x:.7g}" for x in row) + "\n" for i, row in enumerate(rows)))
            study += f'[[run]]\nname = "{name}"\nrole = "{role}"\nrecording = "{name}.csv"\n'
            study += f'set = {{ motion = "{name}.dat", dt = {self.dt}, npts = {len(motion)} }}\n'
            for channel, file, column in self.outputs:
                study += f'[[run.observe]]\nchannel = "{channel.split("[")[0]}"\noutput = "{file}"\ncolumn = {column}\nat = "{channel.split("[")[0]}"\n'
        put("study.toml", study)


def noisy(values, size, seed, loud=lambda t: 1.0, dt=0.02):
    r = random.Random(seed)
    scale = size * math.sqrt(sum(x * x for x in values) / len(values))
    return [x + scale * loud(i * dt) * r.gauss(0, 1) for i, x in enumerate(values)]


def damper_case(name, truth, strength, loud=lambda run, t: 1.0, gain=lambda run: 1.0, noise=0.02):
    """Three fitted runs and one held out; `strength` is a function of the run, the time and the work."""
    dt = 0.02
    c = Case(name, truth, DAMPER.format(Q=16.0, K=1.1, uy=1.3), [("Q", 4.0, 60.0), ("K", 0.2, 4.0), ("uy", 0.3, 6.0)], dt, [("force[kN]", "force.out", 2)])
    motions = [("sine", "fit", growing(700, dt, 22.0, 0.5)), ("sweep", "fit", sweep(700, dt, 18.0, 0.2, 1.2)), ("steps", "fit", growing(600, dt, 14.0, 0.9)),
               ("other", "holdout", sweep(600, dt, 20.0, 0.9, 0.3))]
    for k, (run, role, motion) in enumerate(motions):
        force = damper(motion, dt, lambda t, w: strength(run, t, w))
        force = [gain(run) * f for f in force]
        c.runs.append((run, role, motion, [noisy(force, noise, 17 * k + len(name), lambda t: loud(run, t), dt)]))
    return c


def frame_case(name, truth, stiffness):
    dt = 0.02
    c = Case(name, truth, FRAME.format(k1=240.0, k2=180.0), [("k1", 80.0, 600.0), ("k2", 60.0, 500.0)], dt,
             [("lower[m]", "disp.out", 1), ("upper[m]", "disp.out", 2)])
    for k, (run, role) in enumerate([("first", "fit"), ("second", "fit"), ("third", "holdout")]):
        motion = shaking(900, dt, 2.0, 40 + k)
        both = list(zip(*frame(motion, dt, lambda t: stiffness(run, t))))
        c.runs.append((run, role, motion, [noisy(x, 0.02, 5 * k + j) for j, x in enumerate(both)]))
    return c


def cases():
    changed = {"cause": "changed_condition"}
    def during(of, t1, t2, factor, value=20.0):
        return lambda run, t, _work=0.0: value * (factor if run == of and t1 <= t < t2 else 1.0)
    yield damper_case("tightened-for-a-time", changed, during("sweep", 4.1, 9.3, 1.35))
    yield damper_case("loosened-for-a-time", changed, during("sine", 6.3, 10.7, 0.7))
    yield damper_case("loosened-on-the-way", changed, during("sweep", 6.9, 1e9, 0.7))
    yield damper_case("tight-at-first", changed, during("sine", -1.0, 8.3, 1.4))
    yield damper_case("wear", {"cause": "cyclic_degradation"}, lambda run, t, w: 20.0 * (0.55 + 0.45 * math.exp(-w / 4000.0)))
    yield damper_case("as-modelled", {"cause": "none"}, lambda run, t, w: 20.0)
    yield damper_case("loud", {"cause": "none"}, lambda run, t, w: 20.0, loud=lambda run, t: 4.0 if run == "sweep" and 5 < t < 9 else 1.0)
    yield damper_case("scaled", {"cause": "sensor_gain", "accept_as_arguable": ["changed_condition"]}, lambda run, t, w: 20.0, gain=lambda run: 1.2 if run == "steps" else 1.0)
    yield damper_case("slow", {"cause": "unknown"}, lambda run, t, w: 20.0 * (1 + 0.3 * math.sin(0.45 * t)))
    def cracks(run, t):
        return (160.0 if run == "second" and t > 7.3 else 220.0), 200.0
    yield frame_case("brace-fails", changed, cracks)
    yield frame_case("frame-as-modelled", {"cause": "none"}, lambda run, t: (220.0, 200.0))


def main():
    p = argparse.ArgumentParser()
    p.add_argument("--out", required=True)
    for c in (args := p.parse_args()) and cases():
        c.write(args.out)


if __name__ == "__main__":
    main()
