#!/usr/bin/env python3
"""Random isolated structures in the plane, in hysteron and in OpenSees: do they find the same?

    benches/random_plane.py [--from SEED] [--count N] [--keep DIR] [--engine BINARY]

As random_structures.py with the bearings that OpenSees has in the plane, nodes that may turn, a column of each geometric transformation above
them, and more integrators. Pendulums stand without `-shearDist`, of which openseespy 3.7.1 takes no notice in the plane.
"""
import math
import random

from random_structures import frictions, laws, main, motion, shaken, weighed

STEPS = 400
UPRIGHT = "-orient 0 1 0 -1 0 0"


def isolator(r, k, q):
    """Kind and element commands between nodes 1 and 2."""
    orient, place = r.choice([UPRIGHT, UPRIGHT, ""]), f"-shearDist {r.choice([0.5, 0, 0.3])}"
    option = r.choice(["", "-doRayleigh", f"-mass {r.uniform(1, 5)}"])
    springs, rest = f"-P {r.choice([1, 3])} -Mz 2 {orient}", f"{place} {option}"
    law, friction = f"{k} {q} 0.1 {r.choice([0, 0.01])} 2.0", r.choice([1, 2, 3, 4])
    kinds = {
        "plasticity": f"elastomericBearingPlasticity 1 1 2 {law} {springs} {rest}",
        "boucwen": f"elastomericBearingBoucWen 1 1 2 {law} {r.choice([1.0, 2.0])} 0.5 0.5 {springs} {rest}",
        "pendulum": f"singleFPBearing 1 1 2 {friction} {r.uniform(1, 4)} {k * 3} {springs} {option}",
        "slider": f"flatSliderBearing 1 1 2 {friction} {k * 3} {springs} {rest}\nelement twoNodeLink 5 1 2 -mat 20 -dir 2 {UPRIGHT}",
        "rjwatson": f"RJWatsonEqsBearing 1 1 2 1 {k * 3} -P 1 -Vy {r.choice([5, 6, 20])} -Mz 2 {orient} {rest}",
        "link": f"twoNodeLink 1 1 2 -mat 1 {r.choice([5, 6, 11, 12, 13])} 2 -dir 1 2 3 {orient} {r.choice(['', '-pDelta 0.5 0.5', '-shearDist 0.3'])} {option}",
    }
    kind = r.choice(sorted(kinds))
    return kind, f"element {kinds[kind]}"


def case(seed):
    """Kind of the isolator, script and ground motion. kN, m, s."""
    r = random.Random(seed)
    weight = r.uniform(500, 2000)
    m = weight / 9.81
    k, q = 10 * m * (2 * math.pi / r.uniform(1.5, 3)) ** 2, r.uniform(0.03, 0.08) * weight
    kind, element = isolator(r, k, q)
    damper = r.choice(["", "", "7", "14", "8"])
    held = r.choice([0, 1]), r.choice([0, 0, 1])
    lines = [
        "model BasicBuilder -ndm 2 -ndf 3",
        "node 1 0 0; fix 1 1 1 1",
        *(f"node {n} 0 {z} -mass {x} {x} {r.choice([1, 0.1])}; fix {n} 0 0 {h}" for n, z, x, h in ((2, 0.3, 0.3 * m, held[0]), (3, 3.3, 0.7 * m, held[1]))),
        *laws(r, k, q),
        *frictions(r),
        "frictionModel VelNormalFrcDep 4 0.08 0.9 0.16 0.85 20. 0.0 0.0 2.0",
        element,
        *([f"element twoNodeLink 6 1 2 -mat {damper} -dir 2 {UPRIGHT}"] if damper else []),
        f"geomTransf {r.choice(['Linear', 'PDelta', 'Corotational'])} 1",
        f"element elasticBeamColumn 2 2 3 0.2 2.5e7 {r.uniform(0.002, 0.01)} 1 {r.choice(['', '-mass 0.5'])}",
        *weighed(r, f"0 {-0.3 * weight} 0", f"0 {-0.7 * weight} 0"),
        'puts "modes at rest [eigen -fullGenLapack 2]"',
        *shaken(r),
        *(["pattern UniformExcitation 3 2 -accel 2 -fact 0.6"] if r.random() < 0.5 else []),
        "recorder Node -file disp.out -time -node 2 3 -dof 1 2 3 disp",
        "recorder Element -file force.out -time -ele 1 force",
        "recorder Node -file reaction.out -time -node 1 -dof 1 2 3 reaction",
        "recorder Node -file accel.out -time -timeSeries 2 -node 3 -dof 1 accel",
        f"recorder Element -file local.out -time -ele 1 {r.choice(['localForce', 'basicForce', 'basicDisplacement', 'localDisplacement'])}",
        f"constraints {r.choice(['Transformation', 'Plain'])}; numberer RCM; system UmfPack; test NormDispIncr 1e-11 100 0",
        f"algorithm {r.choice(['Newton', 'Newton', 'ModifiedNewton -initial', 'ModifiedNewton', 'NewtonLineSearch'])}",
        f"integrator {r.choice(['Newmark 0.5 0.25', 'HHT 0.9', 'TRBDF2', 'Newmark 0.6 0.3025', 'GeneralizedAlpha 1.0 0.9', 'HHTGeneralized 0.8', 'Collocation 1.4', 'WilsonTheta 1.4'])}; analysis Transient",
        f'puts "shaking [analyze {STEPS} 0.01]"',
        'puts "modes after shaking [eigen -fullGenLapack 2]"',
    ]
    return kind, "\n".join(lines) + "\n", motion(r)


if __name__ == "__main__":
    main(case, STEPS, ("disp", "force", "reaction", "accel", "local"), __doc__)
