#!/usr/bin/env python3
"""Random isolated structures in hysteron and in OpenSees: do they find the same?

    benches/random_structures.py [--from SEED] [--count N] [--keep DIR] [--engine BINARY]

A seed makes a mass and a storey on an isolator of a kind that OpenSees has, with random parameters, dampers, Rayleigh damping, ground
motion, constraint handler, algorithm and integrator. Both programs run it with tolerances near round-off; displacements, forces, reactions,
accelerations and eigenvalues (`eigen -fullGenLapack`) are compared, hysteron with `--compat opensees`. A line a case; `differs` where
something is more than 1e-5 apart, `ends` where one of them stops at another step, `nothing` where neither makes a step. Some laws of OpenSees depend on the
iterations (docs/reference/compat.md): KrylovNewton and line searches lead them elsewhere, and a case that differs is a question, not yet an error.
The first use installs openseespy (see peer.py). Status 1 if a case differs.
"""
import argparse
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from peer import ROOT, peer_python

STEPS, APART, MODES_APART = 400, 1e-5, 1e-6
UP = "-orient 0 0 1 1 0 0"


def motion(r):
    """Coloured noise under a bell, in samples of 0.02 s."""
    state, samples = 0.0, []
    for i in range(300):
        state = 0.75 * state + r.gauss(0, 0.12)
        samples.append(state * math.exp(-(((i - 110) / 70) ** 2)))
    return "".join(f"{x:.8g}\n" for x in samples)


def laws(r, k, q, rubber=lambda: []):
    """Commands of uniaxial materials for isolators of stiffness k and strength q; `rubber` adds more in their midst."""
    points = [(q, q / k), (1.4 * q, 8 * q / k), (1.5 * q, 20 * q / k)]
    envelope = " ".join(f"{s * f} {s * d}" for s in (1, -1) for f, d in points)
    return [
        "uniaxialMaterial Elastic 1 2.0e6; uniaxialMaterial Elastic 2 1.0e5; uniaxialMaterial ENT 3 2.0e6",
        f"uniaxialMaterial Steel02 5 {q} {k} 0.1 18 0.925 0.15; uniaxialMaterial Steel01 6 {q} {k} 0.1",
        f"uniaxialMaterial Viscous 7 {r.uniform(10, 200)} {r.choice([1.0, 0.8, 0.5])}",
        f"uniaxialMaterial ElasticPPGap 8 {5 * k} {10 * q} 0.05 0.01",
        *rubber(),
        f"uniaxialMaterial SelfCentering 11 {k} {0.02 * k} {q} 0.6 0 0 0",
        f"uniaxialMaterial Hysteretic 12 {envelope} {r.uniform(0.3, 1)} {r.uniform(0.3, 1)} 0.0 0.0 0.1",
        f"uniaxialMaterial BoucWen 13 0.1 {k} 1.0 {0.5 * k / q} {0.5 * k / q} 1.0 0 0 0",
        f"uniaxialMaterial ViscousDamper 14 {k} {r.uniform(20, 200)} {r.choice([1.0, 0.5])}",
        f"uniaxialMaterial Elastic 20 {0.1 * k}",
    ]


def frictions(r):
    """Commands of the friction models that bearings in space and in the plane have."""
    return [
        f"frictionModel Coulomb 1 {r.uniform(0.03, 0.1)}",
        f"frictionModel VelDependent 2 {r.uniform(0.02, 0.05)} {r.uniform(0.06, 0.12)} {r.uniform(10, 50)}",
        "frictionModel VelPressureDep 3 0.03 0.1 0.2 0.02 0.001 20.",
    ]


def isolator(r, weight, k, q):
    """Name, element commands between nodes 1 and 2, and whether the nodes are at one place."""
    springs = f"-P {r.choice([1, 1, 3])} -T 2 -My 2 -Mz 2 {UP}"
    place = f"-shearDist {r.choice([0.5, 0, 0.3])}"
    rubber = "700. 2e6 0. 0.6 0.003 0.008 20"
    axes = "0 0 1 1 0 0 10. 0.7 1. 0.4"
    switches = " ".join(str(r.choice([0, 1])) for _ in range(5))
    radius = r.uniform(1, 4)
    a, b = r.choice([5, 6, 10, 11, 12, 13]), r.choice([5, 6, 11, 12, 13])
    size = math.sqrt(weight / 6000 * 4 / math.pi)
    kinds = {
        "plasticity": f"elastomericBearingPlasticity 1 1 2 {k} {q} 0.1 {r.choice([0, 0.01])} 2.0 {springs} {place}",
        "boucwen": f"elastomericBearingBoucWen 1 1 2 {k} {q} 0.1 {r.choice([0, 0.01])} 2.0 {r.choice([1.0, 2.0])} 0.5 0.5 {springs} {place}",
        "hdr": f"HDR 1 1 2 {rubber} {k * 0.12} {-k * 0.1} {k * 0.4} {q * 0.5} {q * 5} 30. 0.5 0.5 0.4 3. {axes} {r.choice([0.5, 0.3])} {r.choice([0, 0.5])} 0",
        "elastomericx": f"ElastomericX 1 1 2 {q} 0.12 {rubber} {axes} 0. 0. 0. {switches[:7]}",
        "leadrubberx": f"LeadRubberX 1 1 2 {q} 0.12 {rubber.replace(' 0. ', ' 0.1 ', 1)} {axes} 0. 0. 0. 11.2 130. 0.05 1.41e-5 {switches}",
        "pendulum": f"singleFPBearing 1 1 2 {r.choice([1, 2, 3])} {radius} {k * 3} {springs} {place}",
        "slider": f"flatSliderBearing 1 1 2 {r.choice([1, 2, 3])} {k * 3} {springs} {place}\nelement twoNodeLink 5 1 2 -mat 20 20 -dir 2 3 {UP}",
        "link": f"twoNodeLink 1 1 2 -mat 1 {a} {b} -dir 1 2 3 {UP} {r.choice(['', '-pDelta 0 0 0.5 0.5', '-shearDist 0.3 0.3'])}",
        "zerolength": f"zeroLength 1 1 2 -mat {b} {a} 1 -dir 1 2 3",
        "kikuchi": f"KikuchiBearing 1 1 2 -shape round -size {size:.4f} 0.15 -totalHeight 0.3 -nMSS 8 -matMSS 10 -limDisp 0.01 -nMNS 8 -matMNS 21 {UP}",
        "shearsprings": f"multipleShearSpring 1 1 2 8 -mat 10 {UP}\nelement twoNodeLink 5 1 2 -mat 1 -dir 1 {UP}",
        "triple": f"TripleFrictionPendulum 1 1 2 1 2 2 1 2 2 2 0.3 1. 1. 0.1 0.3 0.3 {weight:.2f} 0.002 2.0e6 0.1 1e-8",
        "rjwatson": f"RJWatsonEqsBearing 1 1 2 1 {k * 3} -P 1 -Vy {r.choice([5, 6])} -Vz {r.choice([5, 6])} -T 2 -My 2 -Mz 2 {UP}",
    }
    kind = r.choice(sorted(kinds))
    return kind, f"element {kinds[kind]}", kind in ("zerolength", "triple")


def weighed(r, lower, upper):
    """Lines that put loads on nodes 2 and 3 in ten steps."""
    return [
        "timeSeries Linear 1",
        f"pattern Plain 1 1 {{ load 2 {lower}; load 3 {upper} }}",
        f"constraints {r.choice(['Transformation', 'Plain'])}; numberer RCM; system {r.choice(['BandGeneral', 'UmfPack', 'FullGeneral'])}",
        "test NormDispIncr 1e-12 100 0; algorithm Newton; integrator LoadControl 0.1; analysis Static",
        'puts "weight [analyze 10]"',
        "loadConst -time 0.0",
    ]


def shaken(r):
    """Lines that begin the shaking along x."""
    return [
        "wipeAnalysis",
        r.choice(["", "rayleigh 0.1 0.0 0.002 0.0", "rayleigh 0.1 0.0 0.0 0.002", "rayleigh 0.1 0.001 0.0 0.0"]),
        f"timeSeries Path 2 -dt 0.02 -filePath motion.txt -factor {r.choice([1.0, 3.0, 6.0])}",
        "pattern UniformExcitation 2 1 -accel 2",
    ]


def case(seed):
    """Kind of the isolator, script and ground motion. kN, m, s."""
    r = random.Random(seed)
    weight = r.uniform(500, 2000)
    m = weight / 9.81
    k, q = 10 * m * (2 * math.pi / r.uniform(1.5, 3)) ** 2, r.uniform(0.03, 0.08) * weight
    kind, element, together = isolator(r, weight, k, q)
    damper = r.choice(["", "", "", "7", "14", "8"])
    link = "zeroLength" if together else "twoNodeLink"
    rest = ("-dir 1", "") if together else ("-dir 2", UP)
    rubber = lambda: [f"uniaxialMaterial KikuchiAikenHDR 10 {r.choice(['X0.6', 'X0.6-0MPa', 'X0.4', 'X0.3'])} {weight / 6000:.4f} 0.15"]
    lines = [
        "model BasicBuilder -ndm 3 -ndf 6",
        "node 1 0 0 0; fix 1 1 1 1 1 1 1",
        *(f"node {n} 0 0 {z} -mass {x} {x} {x} 1 1 1; fix {n} 0 0 0 1 1 1" for n, z, x in ((2, 0.0 if together else 0.3, 0.3 * m), (3, 3.3, 0.7 * m))),
        *laws(r, k, q, rubber),
        "uniaxialMaterial AxialSp 21 6e5 1e3 -1e5 0.1 0.01 0.5",
        f"uniaxialMaterial Elastic 30 {k * r.uniform(5, 30)}",
        *frictions(r),
        element,
        *([f"element {link} 6 1 2 -mat {damper} {rest[0]} {rest[1]}"] if damper else []),
        f"element twoNodeLink 2 2 3 -mat 1 30 30 -dir 1 2 3 {UP}",
        *weighed(r, f"0 0 {-0.3 * weight} 0 0 0", f"0 0 {-0.7 * weight} 0 0 0"),
        *(['puts "modes at rest [eigen -fullGenLapack 4]"'] if r.random() < 0.8 else []),
        *shaken(r),
        *(["pattern UniformExcitation 3 2 -accel 2 -fact 0.6"] if r.random() < 0.6 else []),
        *(["pattern UniformExcitation 4 3 -accel 2 -fact 0.4"] if r.random() < 0.3 else []),
        "recorder Node -file disp.out -time -node 2 3 -dof 1 2 3 disp",
        "recorder Element -file force.out -time -ele 1 force",
        "recorder Node -file reaction.out -time -node 1 -dof 1 2 3 4 5 reaction",
        "recorder Node -file accel.out -time -timeSeries 2 -node 3 -dof 1 accel",
        f"constraints {r.choice(['Transformation', 'Plain'])}; numberer RCM; system UmfPack; test NormDispIncr 1e-11 100 0",
        f"algorithm {r.choice(['Newton', 'Newton', 'KrylovNewton', 'ModifiedNewton -initial', 'NewtonLineSearch'])}",
        f"integrator {r.choice(['Newmark 0.5 0.25', 'HHT 0.9', 'TRBDF2', 'Newmark 0.6 0.3025'])}; analysis Transient",
        f'puts "shaking [analyze {STEPS} 0.01]"',
        *(['puts "modes after shaking [eigen -fullGenLapack 4]"'] if r.random() < 0.5 else []),
    ]
    return kind, "\n".join(lines) + "\n", motion(r)


def rows(file):
    return [[float(x) for x in line.split()] for line in file.read_text().splitlines()] if file.exists() else []


def apart(a, b):
    """Largest difference in the rows that both have, over the peak of the column or a thousandth of that of the file."""
    both = list(zip(a, b))
    if not both:
        return 0.0
    peaks = [max(abs(row[j]) for row, _ in both) for j in range(len(a[0]))]
    least = max(1e-3 * max(peaks[1:]), 1e-12)
    return max(abs(x - y) / max(p, least) for p, q in both for x, y, p in zip(p[1:], q[1:], peaks[1:]))


def modes(out):
    """Eigenvalues by when they were asked for."""
    found = re.findall(r"modes (at rest|after shaking) ([\d.e+\- ]+)", out)
    return {when: [float(x) for x in line.split()[:4]] for when, line in found}


def compare(case, seed, engine, folder, steps, files):
    kind, script, shaking = case(seed)
    said = []
    for name, command in (("opensees", [peer_python(), ROOT / "benches/peer_tcl.py"]), ("hysteron", [engine, "run", "--compat", "opensees"])):
        place = folder / str(seed) / name
        place.mkdir(parents=True, exist_ok=True)
        (place / "model.tcl").write_text(script)
        (place / "motion.txt").write_text(shaking)
        done = subprocess.run([*command, "model.tcl"], cwd=place, capture_output=True, text=True, timeout=300)
        said.append(done.stdout + "\n" + done.stderr)
    both = [{f: rows(folder / str(seed) / p / f"{f}.out") for f in files} for p in ("opensees", "hysteron")]
    differences = {f: apart(both[0][f], both[1][f]) for f in both[0]}
    a, b = map(modes, said)
    lambdas = {w: max((abs(x - y) / max(abs(x), 1e-9) for x, y in zip(a[w], b[w])), default=0.0) for w in a if w in b}
    ends = [len(b["disp"]) for b in both]
    # After a failed step the state is that of the last one; its modes need not agree.
    counted = [d for when, d in lambdas.items() if when == "at rest" or ends[0] == ends[1] == steps]
    wrong = any(d > APART for d in differences.values()) or any(d > MODES_APART for d in counted)
    verdict = "differs" if wrong else "ends" if ends[0] != ends[1] else "same" if ends[0] else "nothing"
    told = " ".join(f"{f} {d:.0e}" for f, d in differences.items())
    print(f"{seed:6} {kind:18} {verdict:8} steps {ends[0]}/{ends[1]} {told} modes {' '.join(f'{d:.0e}' for d in lambdas.values())}", flush=True)
    return verdict


def main(case, steps, files, doc):
    """Cases from a seed on, in both programs."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--engine", type=Path, default=ROOT / "target/release/hysteron")
    a = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = (a.keep or Path(scratch)).resolve()
        verdicts = [compare(case, seed, a.engine.resolve(), folder, steps, files) for seed in range(a.first, a.first + a.count)]
    counts = {v: verdicts.count(v) for v in ("same", "nothing", "ends", "differs")}
    print(", ".join(f"{n} {v}" for v, n in counts.items()))
    sys.exit(1 if counts["differs"] else 0)


if __name__ == "__main__":
    main(case, STEPS, ("disp", "force", "reaction", "accel"), __doc__)
