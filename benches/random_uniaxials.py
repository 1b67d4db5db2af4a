#!/usr/bin/env python3
"""Uniaxial laws with random parameters under random strains, in hysteron and in OpenSees: do they have the same stresses?

    benches/random_uniaxials.py [--count N] [--from SEED] [--engine BINARY] [--python PYTHON] [--compat] [KIND ...]

PYTHON has openseespy. A history grows, turns at random places, has inner loops and rests. Printed are, for each kind, the histories that differ by more
than 1e-8 of their peak, the largest difference, and the first step of the worst history. Exit status 1 if a kind has more such histories than
it is known to have, from slips of OpenSees that its note names.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

TOLERANCE = 1e-8
KINDS = {}


def kind(scale, note="", known=0.0):
    """Registers a maker of the words of a law after its tag. `scale` is the strain of the law's events, `known` the share of histories that differ."""

    def register(make):
        KINDS[make.__name__] = make, scale, note, known
        return make

    return register


@kind(0.002)
def ConcreteCM(r):
    fc, ec0 = r.uniform(20, 60), r.uniform(0.0018, 0.003)
    ec, ft = fc / ec0 * r.uniform(1.3, 2.5), fc * r.uniform(0.05, 0.12)
    tail = r.choice(["", "-GapClose 0", "-GapClose 1", "-GapClose 1", "0"])
    return f"{-fc} {-ec0} {ec} {r.uniform(2, 12)} {r.choice([1.02, 1.035, 1.3, 1.9])} {ft} {ft / ec * r.uniform(1.2, 2.5)} {r.uniform(1.1, 4)} {r.choice([2, 30, 1e4])} {tail}"


@kind(0.002)
def Concrete02IS(r):
    fc, ec0 = r.uniform(20, 60), r.uniform(0.0018, 0.003)
    tail = r.choice(["", f"{r.uniform(0.05, 0.6)} {r.uniform(1, 5)} {r.uniform(500, 5000)}"])
    return f"{fc / ec0 * r.uniform(0.9, 2.5)} {-fc} {-ec0} {-fc * r.uniform(0, 0.6)} {-ec0 * r.uniform(1.5, 5)} {tail}"


@kind(0.002)
def Concrete06(r):
    fc, ec0 = r.uniform(20, 60), r.uniform(0.0018, 0.003)
    fcr = fc * r.uniform(0.05, 0.12)
    return f"{-fc} {-ec0} {r.uniform(1.5, 4)} {r.uniform(0.7, 2)} {r.uniform(0.1, 0.6)} {fcr} {fcr / fc * ec0 * r.uniform(0.4, 1)} {r.uniform(0.2, 4)} {r.uniform(0.02, 0.4)}"


@kind(0.002)
def ConcreteD(r):
    fc, ec0 = r.uniform(20, 60), r.uniform(0.0018, 0.003)
    ec, ft = fc / ec0 * r.uniform(1.3, 2.5), fc * r.uniform(0.05, 0.12)
    tail = r.choice(["", f"{r.uniform(0.1, 0.4)} {r.uniform(0.8, 1.3)}"])
    return f"{-fc} {-ec0} {ft} {ft / ec * r.uniform(1.1, 2)} {ec} {r.uniform(0.3, 3)} {r.uniform(0.3, 4)} {tail}"


@kind(0.002)
def ConcretewBeta(r):
    fc, ec0, ft = r.uniform(20, 60), r.uniform(0.0018, 0.003), r.uniform(1, 4)
    middle, last, t0 = ec0 * r.uniform(2.2, 3), ec0 * r.uniform(3, 6), ft / (fc / ec0) * 1.1
    options = [f"-lambda {r.uniform(0, 1)}", f"-alpha {r.uniform(0.2, 1.5)}", f"-beta {r.uniform(0.3, 0.9)} 0.01 0.1 0.02", f"-M {r.uniform(0.02, 0.5)}"]
    options += [f"-E {fc / ec0 * r.uniform(1.01, 2)}", f"-conf {-fc * r.uniform(1.05, 1.5)} {-ec0 * r.uniform(1.2, 2)}"]
    words = " ".join(r.sample(options, r.randint(0, len(options))))
    return f"{-fc} {-ec0} {-fc * r.uniform(0.4, 0.9)} {-middle} {-fc * r.uniform(0, 0.4)} {-last} {ft} {ft * 0.5} {t0 * 2} {ft * r.uniform(0, 0.3)} {t0 * 6} {words}"


@kind(0.02)
def ASD_SMA_3K(r):
    k1 = r.uniform(100, 300)
    k2 = k1 * r.uniform(0.01, 0.1)
    return f"{k1} {k2} {r.uniform(k2 * 1.5, k1 * 0.99)} {k1 * r.uniform(0.005, 0.02)} {r.uniform(0.2, 0.9)}"


@kind(0.02)
def GNG(r):
    return f"{r.uniform(100, 300)} {r.uniform(1, 3)} {r.uniform(0.002, 0.02)} {r.choice(['', r.uniform(0, 0.1)])}"


@kind(0.02)
def ElasticPowerFunc(r):
    terms = [(r.uniform(-10, 100), r.choice([0, 0.5, 1, 2.2, 3])) for _ in range(r.randint(1, 4))]
    return f"-coeff {' '.join(str(c) for c, _ in terms)} -exp {' '.join(str(e) for _, e in terms)}"


@kind(0.02)
def Multiplier(r):
    tag = r.randint(10**5, 10**8)
    return [f"Steel01 {tag} {r.uniform(1, 3)} 200. {r.uniform(0, 0.1)}"], f"{tag} {r.uniform(-2, 3)}"


@kind(0.02)
def HystereticSM(r):
    def envelope(sign):
        at, force, out = 0.0, 0.0, []
        for i in range(r.randint(2, 7)):
            step = r.uniform(0.003, 0.01)
            rise = r.uniform(100, 300) if i == 0 else r.uniform(5, 60) if i == 1 or r.random() < 0.3 else r.uniform(-60, 5)
            at, force = at + step, max(force + rise * step, 0.02 * (i + 1))
            out += [sign * force, sign * at]
        return " ".join(map(str, out))

    options = [f"-negEnv {envelope(-1)}", f"-pinch {r.uniform(0.2, 1)} {r.uniform(0.2, 1)}", f"-damage {r.uniform(0, 0.05)} {r.uniform(0, 0.05)}"]
    options += [f"-beta {r.uniform(0, 0.5)}", f"-degEnv {r.uniform(-0.3, 0.1)} {r.uniform(-0.3, 0.1)}"]
    return f"-posEnv {envelope(1)} {' '.join(r.sample(options, r.randint(0, 5)))}"


@kind(0.002)
def ECC01(r):
    ft, et0 = r.uniform(2, 5), r.uniform(0.0001, 0.0003)
    et1, fc, ec0 = r.uniform(0.002, 0.01), r.uniform(30, 60), r.uniform(0.002, 0.004)
    return f"{ft} {et0} {ft * r.uniform(1.01, 1.5)} {et1} {et1 * r.uniform(1.3, 4)} {-fc} {-ec0} {-ec0 * r.uniform(1.5, 4)} {r.uniform(1, 6)} {r.uniform(1, 5)} {r.uniform(1, 3)} {r.uniform(1, 3)} {r.uniform(0.1, 0.6)} {r.uniform(0.1, 0.6)}"


@kind(0.002, "a jump beyond the plastic strain that it makes ends where OpenSees' second trial does", 0.1)
def FRPConfinedConcrete02(r):
    units = r.choice([0, 1])
    mpa = 1 if units else 1 / 6.895
    fc, ec0 = r.uniform(20, 60) * mpa, r.uniform(0.0018, 0.003)
    first = f"{-fc} {fc / ec0 * r.uniform(1.3, 2)} {-ec0}"
    last = f"{r.uniform(1, 4) * mpa} {r.uniform(500, 5000) * mpa} {units}"
    form = r.choice(["", f"-Ultimate {-fc * r.uniform(1.1, 2)} {-r.uniform(0.006, 0.02)}"])
    form = r.choice([form, f"-JacketC {r.uniform(0.2, 1)} {r.uniform(5e4, 2e5) * mpa} {r.uniform(0.008, 0.016)} {r.uniform(70, 300)}"])
    return f"{first} {form} {last}"


@kind(0.01)
def Steel03(r):
    radius = r.choice(["20 0 0", f"{r.uniform(10, 25)} {r.uniform(0.8, 0.95)} {r.uniform(0.1, 0.3)}"])
    hardening = f"{r.uniform(0, 0.3)} {r.uniform(1, 55)} {r.uniform(0, 0.3)} {r.uniform(1, 55)}"
    return f"{r.uniform(250, 600)} 2e5 {r.uniform(0, 0.1)} {radius} {r.choice(['', hardening])}"


@kind(0.01)
def Steel4(r):
    asym = r.random() < 0.5
    def kin():
        return f"{r.uniform(0.001, 0.03)} {r.uniform(15, 50)} {r.uniform(0.85, 0.93)} {r.uniform(0.1, 0.2)}"

    def iso():
        return f"{r.uniform(0.001, 0.02)} {r.uniform(0.3, 2)} {r.uniform(0.0001, 0.002)} {r.uniform(10, 50)}"

    def both(one):
        return " ".join(str(one()) for _ in range(1 + asym))

    fy = r.uniform(250, 500)
    options = [f"-kin {both(kin)}", f"-ult {both(lambda: f'{fy * r.uniform(1.1, 1.6)} {r.uniform(2, 10)}')}"]
    options += [f"-iso {iso()} {r.choice([0, r.uniform(1, 10)])} {iso() if asym else ''}", f"-mem {r.choice([0, 50])}", f"-init {r.uniform(-0.6, 0.6) * fy}"]
    return f"{fy} {r.uniform(1.9e5, 2.1e5)} {'-asym' if asym else ''} {' '.join(r.sample(options, r.randint(0, 5)))}"


@kind(0.002)
def Concrete01WithSITC(r):
    fc, ec0 = r.uniform(20, 60), r.uniform(0.0018, 0.003)
    return f"{-fc} {-ec0} {-fc * r.uniform(0, 0.6)} {-ec0 * r.uniform(1.5, 5)} {r.choice(['', -0.0003, 0.0005, 0.002])}"


@kind(0.5)
def CastFuse(r):
    fingers = f"{r.randint(4, 12)} {r.uniform(3, 8)} {r.uniform(1, 2)} {r.uniform(40, 60)} {r.uniform(28000, 30000)} {r.uniform(8, 15)}"
    hardening = [x for _ in range(2) for x in (r.choice([0, r.uniform(0, 0.1)]), r.uniform(0.8, 2))]
    return f"{fingers} {r.uniform(0.005, 0.1)} {r.uniform(15, 30)} {r.uniform(0.9, 0.93)} {r.uniform(0.1, 0.2)} {' '.join(map(str, hardening))}"


@kind(1.0, "OpenSees gives a level part of the path a slope; the trials of pinching", 0.02)
def BarSlip(r):
    units = r.choice(["MPa", "ksi"])
    stress, length = (1, 1) if units == "MPa" else (1 / 6.895, 1 / 25.4)
    steel = f"{r.uniform(400, 500) * stress} {2e5 * stress} {r.uniform(550, 700) * stress} {r.uniform(2000, 6000) * stress} {r.choice([16, 20, 25]) * length}"
    joint = f"{r.uniform(300, 600) * length} {r.randint(2, 6)} {r.uniform(300, 500) * length} {r.uniform(300, 500) * length}"
    words = f"{r.choice(['strong', 'weak'])} {r.choice(['beamtop', 'beambot', 'column'])} {r.choice(['Damage1', 'Damage2', 'NoDamage'])}"
    return f"{r.uniform(25, 45) * stress} {steel} {joint} {words} {units}"


def strains(r, scale):
    """A history with turns at random places, of steps of random lengths."""
    out, at = [], 0.0
    size = scale * r.choice([0.3, 1, 2, 4])
    for _ in range(r.randint(5, 40)):
        way = r.random()
        if way < 0.15:
            goal = at
        elif way < 0.4:
            goal = at + 0.2 * size * r.uniform(-1, 1)
        else:
            goal = size * r.uniform(-1, 1)
        steps = r.choice([1, 3, 10, 25])
        out += [at + (goal - at) * (i + 1) / steps for i in range(steps)]
        at = goal
        size *= r.choice([1, 1, 1.1, 1.3])
    return out


OPENSEES = """
import json, sys
import openseespy.opensees as ops
def word(x):
    for kind in (int, float):
        try: return kind(x)
        except ValueError: pass
    return x
ops.model('basic', '-ndm', 1, '-ndf', 1)
out = []
for tag, (before, words, path) in enumerate(json.load(open(sys.argv[1])), 1):
    for line in before: ops.uniaxialMaterial(*map(word, line.split()))
    name, *rest = words.split()
    ops.uniaxialMaterial(name, tag, *map(word, rest))
    ops.testUniaxialMaterial(tag)
    stresses = []
    for e in path:
        ops.setStrain(e)
        stresses.append(ops.getStress())
    out.append(stresses)
json.dump(out, open(sys.argv[2], 'w'))
"""


def cases(name, seeds):
    make, scale, *_ = KINDS[name]
    out = []
    for seed in seeds:
        r = random.Random(f"{name} {seed}")
        words = make(r)
        before, words = words if isinstance(words, tuple) else ([], words)
        out.append((before, f"{name} {words}", strains(r, scale)))
    return out


def hysteron(engine, folder, todo, compat):
    lines = ["model basic -ndm 1 -ndf 1"]
    for tag, (before, words, path) in enumerate(todo, 1):
        lines += [f"uniaxialMaterial {line}" for line in before]
        name, *rest = words.split()
        lines += [f"uniaxialMaterial {name} {tag} {' '.join(rest)}", f"testUniaxialMaterial {tag}"]
        lines += [f"foreach e {{{' '.join(map(repr, path))}}} {{ setStrain $e; puts [getStress] }}"]
    script = folder / "script.tcl"
    script.write_text("\n".join(lines) + "\n")
    run = subprocess.run([engine, "run", *(["--compat", "opensees"] if compat else []), str(script)], capture_output=True, text=True, cwd=folder)
    if run.returncode:
        sys.exit(run.stderr)
    values = iter(float(x) for x in run.stdout.split())
    return [[next(values) for _ in path] for *_, path in todo]


def opensees(python, folder, todo):
    (folder / "cases.json").write_text(json.dumps(todo))
    run = subprocess.run([python, "-c", OPENSEES, "cases.json", "out.json"], capture_output=True, text=True, cwd=folder)
    if run.returncode or not (folder / "out.json").exists():
        sys.exit(run.stderr[-2000:])
    return json.loads((folder / "out.json").read_text())


def compare(name, options):
    seeds = range(options.first, options.first + options.count)
    todo = cases(name, seeds)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        theirs, ours = opensees(options.python, folder, todo), hysteron(options.engine, folder, todo, options.compat)
    worst, differ, undefined = (0.0, None), [], 0
    for seed, (_, words, path), a, b in zip(seeds, todo, theirs, ours):
        if not all(map(math.isfinite, a)):
            undefined += 1
            continue
        peak = max(max(map(abs, a)), 1e-300)
        apart = [abs(x - y) / peak for x, y in zip(a, b)]
        if max(apart) > TOLERANCE:
            first = next(i for i, x in enumerate(apart) if x > TOLERANCE)
            differ.append(seed)
            if max(apart) > worst[0]:
                worst = max(apart), f"seed {seed}: {words}\n    step {first} of {len(path)}, strains {path[max(0, first - 3) : first + 1]}: {a[first]} there, {b[first]} here"
        elif worst[1] is None:
            worst = max(worst[0], max(apart)), None
    known = KINDS[name][3]
    print(f"{name}: {len(differ)} of {len(todo)} differ{f', {undefined} have no number in OpenSees' if undefined else ''}; largest {worst[0]:.1e}" + (f"\n  {worst[1]}\n  seeds {differ[:12]}" if worst[1] else ""))
    return len(differ) > known * len(todo)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kinds", nargs="*", default=sorted(KINDS))
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--engine", default="target/release/hysteron")
    parser.add_argument("--python", default=sys.executable)
    parser.add_argument("--compat", action="store_true")
    options = parser.parse_args()
    options.engine = str(pathlib.Path(options.engine).resolve())
    sys.exit(any([compare(name, options) for name in options.kinds]))


if __name__ == "__main__":
    main()
