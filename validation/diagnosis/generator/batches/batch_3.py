"""Batch 3: models of further kinds and the effect concealed in each. Units: kN, m, s, t."""

import math

from generator import signals
from generator.model import Channel, number
from generator.scripts import RIG, WEIGHT, events, place, run, swapped, transient

GRAVITY = """constraints {handler}
numberer RCM
system {system}
test NormDispIncr 1e-10 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis
"""

SHAKEN = """timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
"""

# ------------------------------------------------------------------ three storeys, two bays, in the plane

BAYS = """wipe
model BasicBuilder -ndm 2 -ndf 3
pset rE @rE@
pset xi @xi@
for {set f 0} {$f <= 3} {incr f} {
    for {set c 1} {$c <= 3} {incr c} {
        node [expr 10*$f+$c] [expr 5.0*($c-1)] [expr 3.2*$f]
        if {$f > 0} {mass [expr 10*$f+$c] 18.0 18.0 1.0e-6}
    }
}
foreach n {1 2 3} {fix $n 1 1 1}
set E [expr $rE*2.8e7]
geomTransf PDelta 1
geomTransf Linear 2
for {set f 1} {$f <= 3} {incr f} {
    for {set c 1} {$c <= 3} {incr c} {
        element elasticBeamColumn [expr 100*$f+$c] [expr 10*($f-1)+$c] [expr 10*$f+$c] 0.20 $E 0.0030 1
    }
    foreach b {1 2} {
        element elasticBeamColumn [expr 200*$f+1000+$b] [expr 10*$f+$b] [expr 10*$f+$b+1] 0.24 $E 0.0040 2
    }
}
pattern Plain 1 Linear {
    for {set f 1} {$f <= 3} {incr f} {
        foreach c {1 2 3} {load [expr 10*$f+$c] 0.0 -176.6 0.0}
    }
}
""" + GRAVITY.format(handler="Plain", system="ProfileSPD") + """set lambda [eigen -fullGenLapack 2]
set w1 [expr sqrt([lindex $lambda 0])]
set w2 [expr sqrt([lindex $lambda 1])]
rayleigh [expr 2.0*$xi*$w1*$w2/($w1+$w2)] 0.0 [expr 2.0*$xi/($w1+$w2)] 0.0
""" + SHAKEN + """recorder Node -file acc.out -timeSeries 2 -time -node 12 22 32 -dof 1 accel
recorder Node -file disp.out -time -node 32 -dof 1 disp
""" + transient()

BAYS_CHANNELS = [Channel("a1", "m/s2", "acc.out", 1, "floor 1"), Channel("a2", "m/s2", "acc.out", 2, "floor 2"), Channel("a3", "m/s2", "acc.out", 3, "roof"), Channel("roof", "m", "disp.out", 1, "roof")]
BAYS_ALL = [c.name for c in BAYS_CHANNELS]


def bays(rng, pga):
    return "three storeys, two bays", BAYS, {"rE": rng.uniform(0.85, 1.15), "xi": rng.uniform(0.025, 0.05)}, events(rng, pga, ("march", "june")), BAYS_CHANNELS


def bays_with_yielding_beams(rng):
    def conceal(m):
        hinges = """uniaxialMaterial Steel02 77 95.0 9.0e5 0.01 16.0 0.92 0.15
set n 5000
for {set f 1} {$f <= 2} {incr f} {
    foreach b {1 2} {
        foreach c [list $b [expr $b+1]] {
            incr n
            node $n [nodeCoord [expr 10*$f+$c] 1] [nodeCoord [expr 10*$f+$c] 2]
            equalDOF [expr 10*$f+$c] $n 1 2
            element zeroLength $n [expr 10*$f+$c] $n -mat 77 -dir 6
        }
        remove element [expr 200*$f+1000+$b]
        element elasticBeamColumn [expr 200*$f+1000+$b] [expr $n-1] $n 0.24 $E 0.0040 2
    }
}
"""
        text = swapped(m.filled(), "pattern Plain 1 Linear {", hinges + "pattern Plain 1 Linear {")
        text = text.replace("constraints Plain", "constraints Transformation").replace("system ProfileSPD", "system BandGeneral")
        return {"cause": "superstructure_yielding", "script": text, "where": place(m, "roof", BAYS_ALL, "beams of the first two floors")}
    return (*bays(rng, (4.5, 6.0)), conceal)


def bays_on_footings(rng):
    def conceal(m):
        text = swapped(m.filled(), "foreach n {1 2 3} {fix $n 1 1 1}", """uniaxialMaterial Elastic 70 6.0e4 150.0
uniaxialMaterial Elastic 71 2.0e6
foreach n {1 2 3} {
    node 90$n [nodeCoord $n 1] [nodeCoord $n 2]
    fix 90$n 1 1 1
    fix $n 1 0 0
    element zeroLength 90$n 90$n $n -mat 71 70 -dir 2 6
}""")
        return {"cause": "foundation_flexibility", "script": text, "where": place(m, "a1", BAYS_ALL, "supports")}
    return (*bays(rng, (2.5, 3.5)), conceal)


def bays_with_absorber(rng):
    """A tuned mass on the roof: none of the library."""
    def conceal(m):
        absorber = """node 99 5.0 9.6 -mass 9.0 9.0 1.0e-6
fix 99 0 1 1
uniaxialMaterial Elastic 98 520.0 3.5
element zeroLength 99 32 99 -mat 98 -dir 1
"""
        return {"cause": "unknown", "script": swapped(m.filled(), "pattern Plain 1 Linear {", absorber + "pattern Plain 1 Linear {"), "where": place(m, "roof", BAYS_ALL, "roof")}
    return (*bays(rng, (2.5, 3.5)), conceal)


# ------------------------------------------------------------------ one storey in space

HALL = """wipe
model basic -ndm 3 -ndf 6
pset rE @rE@
pset aM @aM@
set E [expr $rE*2.0e8]
foreach {i x y} {1 0.0 0.0 2 8.0 0.0 3 8.0 6.0 4 0.0 6.0} {
    node $i $x $y 0.0
    node 1$i $x $y 4.0
    fix $i 1 1 1 1 1 1
}
node 20 4.0 3.0 4.0
mass 20 60.0 60.0 60.0 1.0 1.0 500.0
geomTransf Linear 1 0.0 1.0 0.0
geomTransf Linear 2 0.0 0.0 1.0
foreach i {1 2 3 4} {
    element elasticBeamColumn $i $i 1$i 0.0078 $E 7.7e7 8.0e-7 5.7e-5 8.0e-5 1
}
foreach {e i j} {11 11 12 12 12 13 13 13 14 14 14 11} {
    element elasticBeamColumn $e $i $j 0.010 $E 7.7e7 1.0e-6 2.0e-4 2.0e-5 2
}
rigidDiaphragm 3 20 11 12 13 14
fix 20 0 0 1 1 1 0
rayleigh $aM 0.0 0.0 0.001
timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 11 13 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 11 13 -dof 2 accel
recorder Node -file disp.out -time -node 11 -dof 1 2 disp
""" + transient("Transformation", "UmfPack", 2)

HALL_CHANNELS = [Channel("south_x", "m/s2", "x.out", 1, "south west corner"), Channel("north_x", "m/s2", "x.out", 2, "north east corner"),
                 Channel("west_y", "m/s2", "y.out", 1, "south west corner"), Channel("east_y", "m/s2", "y.out", 2, "north east corner"),
                 Channel("drift", "m", "disp.out", 1, "south west corner")]
HALL_ALL = [c.name for c in HALL_CHANNELS]


def hall(rng):
    runs = [run(name, role, 0.01, signals.quake(rng, size, 14.0, 0.01), signals.quake(rng, 0.8 * size, 14.0, 0.01)) for name, role, size in (("north", "fit", 3.0), ("south", "holdout", 3.6))]
    return "steel hall with a stiff roof", HALL, {"rE": rng.uniform(0.9, 1.1), "aM": rng.uniform(0.3, 0.6)}, runs, HALL_CHANNELS


def hall_with_a_crane(rng):
    def conceal(m):
        text = m.filled()
        text = swapped(text, "node 20 4.0 3.0 4.0", "node 20 4.55 3.0 4.0")
        return {"cause": "torsion", "script": text, "where": place(m, "east_y", ["west_y", "east_y"], "plan")}
    return (*hall(rng), conceal)


def hall_with_a_wrong_gain(rng):
    def scaled(r, channels):
        channels["north_x"] = [1.13 * v for v in channels["north_x"]]
    return (*hall(rng), lambda m: {"cause": "sensor_gain", "script": m.filled(), "fault": scaled, "where": place(m, "north_x", ["north_x"], "north east corner")})


# ------------------------------------------------------------------ a slab on pendulums

SLAB = """wipe
model basic -ndm 3 -ndf 6
pset mu @mu@
pset R @R@
foreach {i x y} {1 0.0 0.0 2 6.0 0.0 3 6.0 6.0 4 0.0 6.0} {
    node $i $x $y 0.0
    node 1$i $x $y 0.0
    fix $i 1 1 1 1 1 1
    fix 1$i 0 0 0 1 1 0
}
frictionModel Coulomb 1 $mu
uniaxialMaterial Elastic 1 1.0e6
uniaxialMaterial Elastic 2 1.0e3
foreach i {1 2 3 4} {
    element singleFPBearing $i $i 1$i 1 $R 2.5e4 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
}
node 20 3.0 3.0 0.0
mass 20 160.0 160.0 0.0 1.0 1.0 1900.0
fix 20 0 0 1 1 1 0
rigidDiaphragm 3 20 11 12 13 14
foreach i {11 12 13 14} {mass $i 0.0 0.0 40.0 0.0 0.0 0.0}
timeSeries Linear 1
pattern Plain 1 1 {
    foreach i {11 12 13 14} {load $i 0.0 0.0 -392.4 0.0 0.0 0.0}
}
""" + GRAVITY.format(handler="Transformation", system="UmfPack") + """timeSeries Path 2 -dt $dt -filePath $motion
timeSeries Path 3 -dt $dt -filePath $second
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
recorder Node -file acc.out -timeSeries 2 -time -node 20 -dof 1 accel
recorder Node -file disp.out -time -node 20 -dof 1 2 disp
recorder Element -file force.out -time -ele 1 force
""" + transient("Transformation", "UmfPack", 4)

SLAB_CHANNELS = [Channel("acc", "m/s2", "acc.out", 1, "slab"), Channel("x", "m", "disp.out", 1, "slab"), Channel("y", "m", "disp.out", 2, "slab"), Channel("shear", "kN", "force.out", 7, "element 1")]
SLAB_ALL = [c.name for c in SLAB_CHANNELS]


def slab(rng, size=3.6):
    runs = [run(name, role, 0.01, signals.quake(rng, s, 16.0, 0.01), signals.quake(rng, 0.8 * s, 16.0, 0.01)) for name, role, s in (("lake", "fit", size), ("ridge", "holdout", 1.25 * size))]
    return "slab on four pendulums", SLAB, {"mu": rng.uniform(0.05, 0.07), "R": rng.uniform(1.4, 1.8)}, runs, SLAB_CHANNELS


def slab_with_speed(rng):
    def conceal(m):
        mu = m.parameters["mu"]
        return {"cause": "rate_dependence", "also": ["friction"], "script": swapped(m.filled(), "frictionModel Coulomb 1 $mu", f"frictionModel VelDependent 1 {number(0.45 * mu)} {number(1.15 * mu)} 12.0"),
                "where": place(m, "x", SLAB_ALL, "pendulums")}
    return (*slab(rng), conceal)


def slab_with_a_moat(rng):
    def conceal(m):
        wall = "uniaxialMaterial ImpactMaterial 9 3.0e4 1.2e4 -0.004 -0.032\nnode 50 3.0 3.0 0.0\nfix 50 1 1 1 1 1 1\nelement zeroLength 50 50 20 -mat 9 -dir 1\n"
        return {"cause": "gap_impact", "script": swapped(m.filled(), "timeSeries Linear 1\n", wall + "timeSeries Linear 1\n"), "where": place(m, "acc", SLAB_ALL, "slab")}
    return (*slab(rng, 4.4), conceal)


# ------------------------------------------------------------------ a house on springs in two directions

HOUSE = """wipe
model basic -ndm 3 -ndf 6
pset Q @Q@
pset k @k@
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.0 -mass 300.0 300.0 300.0 0.0 0.0 0.0
node 3 0.0 0.0 0.0 -mass 200.0 200.0 200.0 0.0 0.0 0.0
fix 1 1 1 1 1 1 1
fix 2 0 0 1 1 1 1
fix 3 0 0 1 1 1 1
uniaxialMaterial Steel01 1 $Q [expr 12.0*$k] 0.0833333
uniaxialMaterial Elastic 2 2.5e5 700.0
element zeroLength 1 1 2 -mat 1 1 -dir 1 2
element zeroLength 2 2 3 -mat 2 2 -dir 1 2
timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 2 3 -dof 1 accel
recorder Node -file disp.out -time -node 2 -dof 1 2 disp
""" + transient("Plain", "BandGeneral", 2)

HOUSE_CHANNELS = [Channel("base", "m/s2", "x.out", 1, "slab"), Channel("roof", "m/s2", "x.out", 2, "roof"), Channel("x", "m", "disp.out", 1, "slab"), Channel("y", "m", "disp.out", 2, "slab")]
HOUSE_ALL = [c.name for c in HOUSE_CHANNELS]


def house(rng, size=3.6):
    runs = [run(name, role, 0.01, signals.quake(rng, s, 18.0, 0.01), signals.quake(rng, 0.9 * s, 18.0, 0.01)) for name, role, s in (("first", "fit", size), ("second", "holdout", 1.2 * size))]
    return "house on an isolation layer", HOUSE, {"Q": 0.05 * 500 * 9.81, "k": 500.0 * (6.2832 / 2.3) ** 2}, runs, HOUSE_CHANNELS


def house_coupled(rng):
    def conceal(m):
        bearing = ("uniaxialMaterial Elastic 5 1.0e6\nuniaxialMaterial Elastic 6 1.0e3\n"
                   "element elastomericBearingPlasticity 1 1 2 [expr 12.0*$k] [expr $Q*(1.0-0.0833333)] 0.0833333 0.0 2.0 -P 5 -T 6 -My 6 -Mz 6 -orient 0 0 1 1 0 0")
        return {"cause": "bidirectional_coupling", "script": swapped(m.filled(), "element zeroLength 1 1 2 -mat 1 1 -dir 1 2", bearing), "where": place(m, "x", HOUSE_ALL, "element 1")}
    return (*house(rng), conceal)


def house_with_dampers(rng):
    def conceal(m):
        arms = "uniaxialMaterial Viscous 8 420.0 0.5\nelement zeroLength 8 1 2 -mat 8 8 -dir 1 2\n"
        return {"cause": "damping", "also": ["rate_dependence", "friction"], "script": swapped(m.filled(), "timeSeries Path 1", arms + "timeSeries Path 1"), "where": place(m, "x", HOUSE_ALL, "isolation layer")}
    return (*house(rng), conceal)


def house_as_it_is(rng):
    return (*house(rng), lambda m: {"cause": "none", "script": m.filled()})


# ------------------------------------------------------------------ on a rig

COLUMN = """wipe
model basic -ndm 1 -ndf 1
pset a @a@
pset K @K@
node 1 0.0
node 2 0.0
fix 1 1
uniaxialMaterial BoucWen 1 $a $K 1.6 1150.0 1150.0 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
""" + RIG.replace("constraints Transformation", "constraints Penalty 1e10 1e10")


def column(rng):
    u = 0.008
    steps = [u * s for s in (1, 1, 2, 2, 2, 3.5, 3.5, 3.5, 5, 5, 5)]
    runs = [run("grown", "fit", 0.05, signals.cycles(steps, 0.08, 0.05)), run("again", "fit", 0.05, signals.cycles([u * s for s in (4, 4, 4, 4, 4)], 0.08, 0.05)),
            run("check", "holdout", 0.05, signals.cycles([u * s for s in (3, 3, 4.5, 4.5, 4.5, 4.5)], 0.08, 0.05))]
    return "column under cyclic drift", COLUMN, {"a": 0.04, "K": 120.0 / u}, runs, [Channel("force", "kN", "force.out", 2, "column")]


def column_that_degrades(rng):
    def conceal(m):
        return {"cause": "cyclic_degradation", "script": swapped(m.filled(), "1150.0 1150.0 1.0 0.0 0.0 0.0", "1150.0 1150.0 1.0 0.0 0.012 0.004"), "where": place(m, "force", ["force"], "column")}
    return (*column(rng), conceal)


PAD = """wipe
model basic -ndm 2 -ndf 3
pset Q @Q@
pset G @G@
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1 1
fix 2 0 0 1
uniaxialMaterial Elastic 1 4.0e5
uniaxialMaterial Elastic 2 1.0e4
element elastomericBearingBoucWen 1 1 2 [expr 12.0*$G] $Q 0.0833333 0.0 2.0 1.0 0.6 0.4 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
set axial 900.0
""" + WEIGHT.replace("load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0", "load 2 0.0 [expr -$axial] 0.0") + """timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Node -file force.out -time -node 2 -dof 1 reaction
""" + RIG


def pad(rng, runs):
    return "bearing in the plane", PAD, {"Q": 45.0, "G": 700.0}, runs, [Channel("force", "kN", "force.out", 1, "actuator")]


def pad_in_a_hurry(rng):
    runs = [run("slow", "fit", 0.05, signals.cycles([0.05, 0.1, 0.15], 0.05, 0.05)), run("fast", "fit", 0.01, signals.cycles([0.05, 0.1, 0.15], 0.5, 0.01)),
            run("check", "holdout", 0.01, signals.cycles([0.08, 0.13, 0.13], 0.2, 0.01))]

    def faster(r, channels):
        """Overstress by the logarithm of the speed, which no static analysis of OpenSees has."""
        u, out, lag = r.motions[0], [], 0.0
        for i, force in enumerate(channels["force"]):
            speed = (u[min(i + 1, len(u) - 1)] - u[max(i - 1, 0)]) / (2 * r.dt)
            lag += (1.0 - math.exp(-r.dt / 0.04)) * (9.0 * math.asinh(speed / 0.01) - lag)
            out.append(force + lag)
        channels["force"] = out

    def conceal(m):
        return {"cause": "rate_dependence", "also": ["damping"], "script": m.filled(), "fault": faster, "where": place(m, "force", ["force"], "element 1")}
    return (*pad(rng, runs), conceal)


SEED, STREAM = 11, "unfamiliar"
NAMES = ("alder", "birch", "cedar", "damson", "ebony", "fig", "ginkgo", "hornbeam", "ironwood", "juniper", "larch", "maple")
CASES = (bays_with_yielding_beams, hall_with_a_crane, slab_with_speed, house_with_dampers, bays_on_footings, column_that_degrades, house_coupled, bays_with_absorber,
         house_as_it_is, slab_with_a_moat, pad_in_a_hurry, hall_with_a_wrong_gain)
