#!/usr/bin/env python3
"""Random frames in hysteron and in OpenSees: do they find the same?

    benches/random_frames.py [--from SEED] [--count N] [--keep DIR] [--engine BINARY]

As random_structures.py, for fixed-base and isolated frames in the plane and in space: a seed makes storeys and bays of beams and columns
of a random kind (elastic, hinged, fibers by displacements or forces), transformations, braces, hinges, masses, constraints, loads on
nodes and elements; weight, then a pushover with cycles or a ground motion.
"""
import math
import random

from random_structures import main, motion

STEPS = 240


def materials(r):
    """kN, m: steel and concrete for fibers, springs for hinges and braces."""
    e, fy = 2.0e8, r.uniform(3e5, 4.5e5)
    hinge = [(120, 0.003), (150, 0.02), (90, 0.05)]
    backbone = " ".join(f"{s * f} {s * d}" for s in (1, -1) for f, d in hinge)
    steel = r.choice([
        f"Steel01 1 {fy} {e} 0.01", f"Steel01 1 {fy} {e} 0.02 0.02 10 0.02 10", f"Steel02 1 {fy} {e} 0.01 18 0.925 0.15",
        f"Steel02 1 {fy} {e} 0.01 15 0.925 0.15 0.05 1.0 0.05 1.0", f"Hardening 1 {e} {fy} 1e6 2e6", f"ElasticPP 1 {e} {fy / e}",
    ])
    core, cover = r.choice([
        ("Concrete01 2 -3.5e4 -0.004 -2.5e4 -0.014", "Concrete01 3 -2.8e4 -0.002 0.0 -0.006"),
        ("Concrete02 2 -3.5e4 -0.004 -2.5e4 -0.014 0.1 2000 1e6", "Concrete02 3 -2.8e4 -0.002 -5e3 -0.006 0.1 2000 1e6"),
        ("Concrete02 2 -3.5e4 -0.004 -2.5e4 -0.014 0.5 3000 5e5", "Concrete01 3 -2.8e4 -0.002 0.0 -0.006"),
    ])
    spring = r.choice([
        "Steel01 4 120 4e4 0.02", "Steel02 4 120 4e4 0.02 18 0.925 0.15", "BoucWen 4 0.05 4e4 1 150 150 1 0 0 0",
        f"Hysteretic 4 {backbone} {r.uniform(0.3, 1)} {r.uniform(0.3, 1)} 0.0 0.0 {r.choice([0, 0.3])}", "Hardening 4 4e4 120 0 800", "MultiLinear 4 0.003 120 0.02 150 0.1 170",
    ])
    brace = r.choice([
        f"Steel02 5 {fy} {e} 0.01 18 0.925 0.15", f"ElasticPP 5 {e} 0.0015", f"ElasticPPGap 5 {e} {fy} 0.0004 0.02", f"ENT 5 {e}",
        f"Steel01 15 {fy} {e} 0.01\nuniaxialMaterial MinMax 5 15 -min -0.01 -max 0.01", "ViscousDamper 5 2e7 4e5 0.5", "Maxwell 5 2e7 4e5 0.5 4.0",
        f"Steel02 15 {fy} {e} 0.01 18 0.925 0.15\nuniaxialMaterial Fatigue 5 15 -E0 0.191 -m -0.458", f"SelfCentering 5 {e} 2e6 {fy / 2} 0.6 0 0 0",
        f"Steel01 15 {fy} {e} 0.01\nuniaxialMaterial InitStrainMaterial 5 15 0.0004",
    ])
    return "\n".join(f"uniaxialMaterial {m}" for m in (steel, core, cover, spring, brace, "Elastic 6 1e9", "Elastic 7 8e5"))


def fibers(tag, r, space, depth, width):
    torsion = " -GJ 1e5" if space else ""
    y, z, n = depth / 2 - 0.05, width / 2 - 0.05, r.choice([4, 6, 10])
    across = r.choice([1, 2]) if not space else 4
    lines = [
        f"section Fiber {tag}{torsion} {{", f"  patch rect 2 {n} {across} -{y} -{z} {y} {z}", f"  patch rect 3 1 {across} {y} -{z} {depth / 2} {z}",
        f"  patch rect 3 1 {across} {-depth / 2} -{z} {-y} {z}", f"  layer straight 1 3 0.0005 {y} {z} {y} -{z}", f"  layer straight 1 3 0.0005 -{y} {z} -{y} -{z}", "}",
    ]
    return "\n".join(lines)


def member(r, space, tag, i, j, transf, kind, section):
    """An element command of a kind."""
    beam = section == 2
    a, inertia, e = (0.18, 3e-3, 2.5e7) if beam else (0.16, 2.1e-3, 2.5e7)
    elastic = f"{a} {e} {e / 2.4} 4e-3 {inertia * 0.8} {inertia} {transf}" if space else f"{a} {e} {inertia} {transf}"
    hinges = f"{e} {a} {inertia}" + (f" {inertia * 0.8} {e / 2.4} 4e-3" if space else "")
    n = r.choice([3, 4, 5])
    mass = r.choice(["", "", f"-mass {0.4 if beam else 0.2}"])
    rule = r.choice([f"Lobatto {section} {n}", f"Lobatto {section} {n}", f"Legendre {section} {n}", f"Radau {section} {n}", f"HingeRadau {section} 0.3 {section} 0.3 {section}"])
    points = f"beamIntegration {rule.split()[0]} {tag} {' '.join(rule.split()[1:])}\n"
    return {
        "elastic": f"element elasticBeamColumn {tag} {i} {j} {elastic} {mass}",
        "disp": f"{points}element dispBeamColumn {tag} {i} {j} {transf} {tag} {mass}",
        "force": f"{points}element forceBeamColumn {tag} {i} {j} {transf} {tag} {mass}",
        "nonlinear": f"element nonlinearBeamColumn {tag} {i} {j} {n} {section} {transf} {mass}",
        "hinges": f"element beamWithHinges {tag} {i} {j} {section} 0.3 {section} 0.3 {hinges} {transf} {mass}",
    }[kind]


def case(seed):
    """Kind of the columns, script and ground motion. kN, m, s."""
    r = random.Random(seed)
    space = r.random() < 0.35
    storeys, bays = r.choice([1, 2, 3]), r.choice([1, 2])
    frames = 2 if space else 1
    kinds = ["elastic", "disp", "force", "nonlinear", "hinges"]
    column, beam = r.choice(kinds), r.choice(kinds)
    ndf = 6 if space else 3
    lines = [f"model BasicBuilder -ndm {3 if space else 2} -ndf {ndf}"]
    tag = lambda f, k, b: 100 * f + 10 * k + b + 1
    across = lambda f: f" {4.0 * f}" if space else ""
    nodes = [(f, k, b) for f in range(frames) for k in range(storeys + 1) for b in range(bays + 1)]
    for f, k, b in nodes:
        lines.append(f"node {tag(f, k, b)} {5.0 * b} {3.2 * k}{across(f)}")
    lines += [f"fix {tag(f, 0, b)} {'1 ' * ndf}" for f in range(frames) for b in range(bays + 1)]
    floor = r.uniform(15, 40)
    masses = r.random() < 0.9
    for f, k, b in nodes:
        if k and masses:
            lines.append(f"mass {tag(f, k, b)} {floor} {floor} " + (f"{floor} 1 1 1" if space else "1e-3"))
    lines += [materials(r), fibers(1, r, space, 0.4, 0.4), fibers(2, r, space, 0.5, 0.35)]
    if r.random() < 0.3:
        lines.append("section Aggregator 3 7 Vy -section 1" if not space else "section Aggregator 3 7 Vy 7 Vz -section 1")
        column_section = 3 if column in ("disp", "force", "nonlinear") else 1
    else:
        column_section = 1
    kinds_of_transf = ["Linear", "PDelta", "Corotational"] if not space else ["Linear", "PDelta", "Corotational"]
    transf = r.choice(kinds_of_transf)
    offsets = "" if space or transf == "Corotational" or r.random() < 0.7 else " -jntOffset 0 0.2 0 -0.2"
    lines.append(f"geomTransf {transf} 1{' 0 0 1' if space else ''}{offsets}")
    lines.append(f"geomTransf Linear 2{' 0 0 1' if space else ''}")
    if space:
        lines.append("geomTransf Linear 3 1 0 0")
    at, columns, beams = 1, [], []
    hinged = r.random() < 0.3
    for f, k, b in nodes:
        if k < storeys:
            foot = tag(f, k, b)
            if hinged and k == 0:
                foot = 1000 + tag(f, k, b)
                lines.append(f"node {foot} {5.0 * b} 0{across(f)}")
                if space:
                    lines.append(f"equalDOF {tag(f, k, b)} {foot} 1 2 3 4 5\nelement zeroLength {at + 500} {tag(f, k, b)} {foot} -mat 4 -dir 6")
                else:
                    lines.append(f"equalDOF {tag(f, k, b)} {foot} 1 2\nelement zeroLength {at + 500} {tag(f, k, b)} {foot} -mat 4 -dir 6")
            lines.append(member(r, space, at, foot, tag(f, k + 1, b), 1, column, column_section))
            columns.append(at)
            at += 1
        if k and b < bays:
            lines.append(member(r, space, at, tag(f, k, b), tag(f, k, b + 1), 2, beam, 2))
            beams.append(at)
            at += 1
        if space and k and f == 0:
            lines.append(f"element elasticBeamColumn {at} {tag(0, k, b)} {tag(1, k, b)} 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3")
            at += 1
    braced = r.random() < 0.4
    if braced:
        what = r.choice(["truss", "corotTruss"])
        for f in range(frames):
            lines.append(f"element {what} {at} {tag(f, 0, 0)} {tag(f, 1, 1)} {r.choice([0.0005, 0.002])} 5")
            at += 1
    tied = r.random()
    if space and tied < 0.5:
        lines += [f"rigidDiaphragm 2 {tag(0, k, 0)} " + " ".join(str(tag(f, k, b)) for f in range(2) for b in range(bays + 1) if f or b) for k in range(1, storeys + 1)]
    elif not space and tied < 0.4:
        lines += [f"equalDOF {tag(0, k, 0)} {tag(0, k, b)} 1" for k in range(1, storeys + 1) for b in range(1, bays + 1)]
    lines.append("timeSeries Linear 1\npattern Plain 1 1 {")
    for f, k, b in nodes:
        if k:
            lines.append(f"  load {tag(f, k, b)} 0 {-8 * floor}" + (" 0 0 0 0" if space else " 0"))
    if r.random() < 0.6:
        lines += [f"  eleLoad -ele {e} -type -beamUniform -12.0" + (" 0.0" if space else "") for e in beams]
    if r.random() < 0.2:
        lines += [f"  eleLoad -ele {e} -type -beamPoint -20.0 {'' if not space else '0.0 '}0.4" for e in beams[:1]]
    lines.append("}")
    handler = "Transformation" if hinged or tied < 0.5 else r.choice(["Transformation", "Plain"])
    if not space and hinged or tied < 0.4:
        handler = r.choice(["Transformation", "Transformation", "Plain"]) if not space else "Transformation"
    solver = r.choice(["BandGeneral", "UmfPack", "FullGeneral", "ProfileSPD" if transf == "Linear" and not space else "UmfPack"])
    lines += [
        f"constraints {handler}; numberer RCM; system {solver}", "test NormDispIncr 1e-10 50 0; algorithm Newton; integrator LoadControl 0.1; analysis Static",
        'puts "weight [analyze 10]"', "loadConst -time 0.0",
    ]
    dynamic = masses and r.random() < 0.55
    if masses:
        lines.append('puts "modes at rest [eigen -fullGenLapack 2]"')
    top = tag(0, storeys, 0)
    lines += [
        "wipeAnalysis", f"recorder Node -file disp.out -time -node {tag(0, 1, 0)} {top} -dof {'1 2 3 6' if space else '1 2 3'} disp", f"recorder Element -file force.out -time -ele {columns[0]} {(beams or columns)[-1]} force",
        f"recorder Node -file reaction.out -time -node {tag(0, 0, 0)} {tag(0, 0, 1)} -dof {'1 2 3 6' if space else '1 2 3'} reaction",
    ]
    if column in ("disp", "force", "nonlinear"):
        lines.append(f"recorder Element -file section.out -time -ele {columns[0]} section 1 {r.choice(['force', 'deformation'])}")
    algorithm = r.choice(["Newton", "Newton", "ModifiedNewton", "NewtonLineSearch", "BFGS", "Broyden 8"])
    test = r.choice(["NormDispIncr 1e-9 100 0", "NormUnbalance 1e-6 100 0", "EnergyIncr 1e-14 100 0"])
    lines.append(f"constraints {handler}; numberer RCM; system UmfPack; test {test}")
    if dynamic:
        damping = r.choice(["rayleigh 0.2 0.0 0.0 0.001", "rayleigh 0.2 0.001 0.0 0.0", "rayleigh 0.2 0.0 0.001 0.0", ""])
        lines += [
            damping, f"timeSeries Path 2 -dt 0.02 -filePath motion.txt -factor {r.choice([3.0, 10.0])}", "pattern UniformExcitation 2 1 -accel 2",
            *(["pattern UniformExcitation 3 3 -accel 2 -fact 0.6"] if space else []), f"recorder Node -file accel.out -time -timeSeries 2 -node {top} -dof 1 accel",
            f"algorithm {algorithm}", f"integrator {r.choice(['Newmark 0.5 0.25', 'HHT 0.9', 'Newmark 0.6 0.3025', 'TRBDF2'])}; analysis Transient", f'puts "shaking [analyze {STEPS} 0.01]"',
        ]
    else:
        lines += [
            "pattern Plain 2 1 {", *(f"  load {tag(0, k, 0)} {k * 10.0} 0" + (" 0 0 0 0" if space else " 0") for k in range(1, storeys + 1)), "}", f"algorithm {algorithm}", "set done 0",
            f"foreach amplitude {{0.02 -0.02 0.05 -0.05 0.0}} {{", f"  set d [expr {{($amplitude * {storeys} - [nodeDisp {top} 1]) / {STEPS // 5}}}]", f"  integrator DisplacementControl {top} 1 $d; analysis Static",
            f"  set ok [analyze {STEPS // 5}]; if {{$ok != 0}} {{ break }}", "}", 'puts "pushed $ok"',
        ]
    if masses:
        lines.append('puts "modes after shaking [eigen -fullGenLapack 2]"')
    name = f"{'3' if space else '2'}d-{column}-{'dyn' if dynamic else 'push'}"
    return name, "\n".join(lines) + "\n", motion(r)


if __name__ == "__main__":
    main(case, STEPS, ("disp", "force", "reaction", "accel", "section"), __doc__)
