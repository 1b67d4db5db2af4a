"""Batch 2: engineers' models and the effect concealed in each. Units: kN, m, s, t."""

from generator import signals
from generator.model import Channel, number
from generator.scripts import RIG, WEIGHT, cycling, events, line, place, run, swapped, transient

# ------------------------------------------------------------------ frames on a fixed base

FRAME = """wipe
model basic -ndm 2 -ndf 3
pset rE @rE@
pset aM @aM@
node 1 0.0 0.0
node 2 6.0 0.0
node 3 0.0 3.5 -mass 30.0 30.0 0.0
node 4 6.0 3.5 -mass 30.0 30.0 0.0
node 5 0.0 7.0 -mass 24.0 24.0 0.0
node 6 6.0 7.0 -mass 24.0 24.0 0.0
fix 1 1 1 1
fix 2 1 1 1
geomTransf PDelta 1
set E [expr $rE*2.5e7]
# columns
element elasticBeamColumn 1 1 3 0.16 $E 0.00213 1
element elasticBeamColumn 2 2 4 0.16 $E 0.00213 1
element elasticBeamColumn 3 3 5 0.16 $E 0.00213 1
element elasticBeamColumn 4 4 6 0.16 $E 0.00213 1
# beams
element elasticBeamColumn 5 3 4 0.18 $E 0.0054 1
element elasticBeamColumn 6 5 6 0.18 $E 0.0054 1
rayleigh $aM 0.0 0.0 0.0008
# weight
timeSeries Linear 1
pattern Plain 1 1 {
    load 3 0.0 -294.0 0.0
    load 4 0.0 -294.0 0.0
    load 5 0.0 -235.0 0.0
    load 6 0.0 -235.0 0.0
}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 20
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis

timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
recorder Node -file acc.out -timeSeries 2 -time -node 3 5 -dof 1 accel
recorder Node -file disp.out -time -node 3 5 -dof 1 disp
""" + transient()

FRAME_CHANNELS = [Channel("floor1_acc", "m/s2", "acc.out", 1, "floor 1"), Channel("roof_acc", "m/s2", "acc.out", 2, "roof"), Channel("roof_disp", "m", "disp.out", 2, "roof")]
FRAME_ALL = ["floor1_acc", "roof_acc", "roof_disp"]


def frame(rng, pga):
    parameters = {"rE": rng.uniform(0.85, 1.2), "aM": rng.uniform(0.4, 0.8)}
    return "two-storey portal frame", FRAME, parameters, events(rng, pga), FRAME_CHANNELS


def frame_with_fibers(rng):
    def conceal(m):
        text = m.filled()
        section = "uniaxialMaterial Steel02 7 40000.0 $E 0.02 15.0 0.925 0.15\nsection Fiber 1 {\n    patch rect 7 12 1 -0.2 -0.2 0.2 0.2\n}\n"
        text = swapped(text, "# columns\n", section + "# columns\n")
        for tag, i, j in ((1, 1, 3), (2, 2, 4)):
            text = swapped(text, f"element elasticBeamColumn {tag} {i} {j} 0.16 $E 0.00213 1", f"element forceBeamColumn {tag} {i} {j} 5 1 1")
        return {"cause": "superstructure_yielding", "script": text, "where": place(m, "roof_disp", FRAME_ALL, "columns of the first storey")}
    return (*frame(rng, (5.0, 6.5)), conceal)


def frame_with_dampers(rng):
    def conceal(m):
        text = swapped(m.filled(), "# weight\n", "uniaxialMaterial ViscousDamper 9 60000.0 30.0 0.45\nelement twoNodeLink 9 1 4 -mat 9 -dir 1\n"
                       "element twoNodeLink 10 3 6 -mat 9 -dir 1\n# weight\n")
        return {"cause": "damping", "script": text, "where": place(m, "roof_acc", FRAME_ALL, "structure")}
    return (*frame(rng, (3.0, 4.0)), conceal)


def frame_with_lag(rng):
    def late(r, channels):
        x = channels["roof_disp"]
        times = [i * r.every for i in range(len(x))]
        channels["roof_disp"] = [signals.interpolate(times, x, t - 0.035) for t in times]

    def conceal(m):
        return {"cause": "sensor_lag", "script": m.filled(), "fault": late, "where": place(m, "roof_disp", ["roof_disp"], "roof")}
    return (*frame(rng, (3.0, 4.0)), conceal)


# ------------------------------------------------------------------ an isolated building in space

ISOLATED = """wipe
model basic -ndm 3 -ndf 6
pset Qd @Qd@
pset kd @kd@
pset rE @rE@
# isolators at the corners of the slab, on a rigid base
foreach {i x y} {1 0.0 0.0 2 12.0 0.0 3 12.0 8.0 4 0.0 8.0} {
    node $i $x $y 0.0
    fix $i 1 1 1 1 1 1
    node 1$i $x $y 0.3
}
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 1.0e3
foreach i {1 2 3 4} {
    element elastomericBearingBoucWen $i $i 1$i [expr 10.0*$kd] $Qd 0.1 0.0 2.0 1.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
}
node 20 6.0 4.0 0.3
node 30 6.0 4.0 3.8
node 40 6.0 4.0 7.3
mass 20 130.0 130.0 130.0 1.0 1.0 2300.0
mass 30 120.0 120.0 120.0 1.0 1.0 2100.0
mass 40 100.0 100.0 100.0 1.0 1.0 1750.0
rigidDiaphragm 3 20 11 12 13 14
fix 20 0 0 1 1 1 0
foreach i {11 12 13 14} {fix $i 0 0 1 1 1 0}
geomTransf Linear 1 1 0 0
set E [expr $rE*3.0e7]
element elasticBeamColumn 50 20 30 1.2 $E 1.25e7 0.3 0.045 0.06 1
element elasticBeamColumn 51 30 40 1.2 $E 1.25e7 0.3 0.045 0.06 1
rayleigh 0.12 0.0 0.0 0.0015

timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 11 40 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 11 12 40 -dof 2 accel
recorder Node -file disp.out -time -node 11 -dof 1 2 disp
""" + transient("Transformation", "BandGeneral", 2)

ISOLATED_CHANNELS = [
    Channel("slab_x", "m/s2", "x.out", 1, "corner of the slab"), Channel("roof_x", "m/s2", "x.out", 2, "roof"),
    Channel("west_y", "m/s2", "y.out", 1, "west corner of the slab"), Channel("east_y", "m/s2", "y.out", 2, "east corner of the slab"),
    Channel("slab_disp", "m", "disp.out", 1, "corner of the slab")]
ISOLATED_ALL = [c.name for c in ISOLATED_CHANNELS]


def isolated(rng):
    W = 350.0 * 9.81
    parameters = {"Qd": 0.05 * W / 4, "kd": 350.0 * (6.2832 / 2.4) ** 2 / 4, "rE": rng.uniform(0.9, 1.15)}
    runs = [run(name, role, 0.01, signals.quake(rng, size, 18.0, 0.01), signals.quake(rng, 0.85 * size, 18.0, 0.01))
            for name, role, size in (("valley", "fit", 3.5), ("coast", "holdout", 4.5))]
    return "two storeys on four isolators", ISOLATED, parameters, runs, ISOLATED_CHANNELS


def isolated_eccentric(rng):
    def conceal(m):
        text = m.filled()
        for z, n in (("0.3", 20), ("3.8", 30), ("7.3", 40)):
            text = swapped(text, f"node {n} 6.0 4.0 {z}", f"node {n} 6.7 4.0 {z}")
        return {"cause": "torsion", "script": text, "where": place(m, "west_y", ["west_y", "east_y"], "plan")}
    return (*isolated(rng), conceal)


def isolated_as_it_is(rng):
    return (*isolated(rng), lambda m: {"cause": "none", "script": m.filled()})


def isolated_with_rate(rng):
    def conceal(m):
        text = m.filled()
        k = m.parameters["kd"]
        arms = (f"uniaxialMaterial Maxwell 8 {number(0.9 * k)} {number(0.25 * k)} 1.0 1.0\nforeach i {{1 2 3 4}} {{\n"
                "    element twoNodeLink 10$i $i 1$i -mat 8 8 -dir 2 3 -orient 0 0 1 1 0 0\n}\n")
        text = swapped(text, "node 20 6.0 4.0 0.3", arms + "node 20 6.0 4.0 0.3")
        return {"cause": "rate_dependence", "also": ["damping"], "script": text, "where": place(m, "slab_x", ISOLATED_ALL, "isolation layer")}
    return (*isolated(rng), conceal)


# ------------------------------------------------------------------ a bridge

BRIDGE = """wipe
model basic -ndm 2 -ndf 3
pset Qd @Qd@
pset kd @kd@
pset rE @rE@
# two piers of 9 m, a deck of three spans on bearings at the abutments and on the piers
node 1 25.0 -9.0
node 2 55.0 -9.0
node 3 25.0 0.0 -mass 60.0 60.0 0.0
node 4 55.0 0.0 -mass 60.0 60.0 0.0
node 10 0.0 0.0
node 11 0.0 0.0 -mass 190.0 190.0 0.0
node 12 25.0 0.0 -mass 410.0 410.0 0.0
node 13 55.0 0.0 -mass 410.0 410.0 0.0
node 14 80.0 0.0 -mass 190.0 190.0 0.0
node 15 80.0 0.0
fix 1 1 1 1
fix 2 1 1 1
fix 10 1 1 1
fix 15 1 1 1
geomTransf Linear 1
set E [expr $rE*3.2e7]
element elasticBeamColumn 1 1 3 2.5 $E 0.30 1
element elasticBeamColumn 2 2 4 2.5 $E 0.30 1
element elasticBeamColumn 3 11 12 5.0 3.2e7 2.0 1
element elasticBeamColumn 4 12 13 5.0 3.2e7 2.0 1
element elasticBeamColumn 5 13 14 5.0 3.2e7 2.0 1
# bearings
uniaxialMaterial Steel01 1 [expr $Qd/0.9] [expr 10.0*$kd] 0.1
uniaxialMaterial Elastic 2 2.0e6
element zeroLength 10 10 11 -mat 1 2 -dir 1 2
element zeroLength 11 3 12 -mat 1 2 -dir 1 2
element zeroLength 12 4 13 -mat 1 2 -dir 1 2
element zeroLength 13 15 14 -mat 1 2 -dir 1 2
rayleigh 0.25 0.0 0.0006 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file acc.out -timeSeries 1 -time -node 3 12 -dof 1 accel
recorder Node -file disp.out -time -node 3 12 -dof 1 disp
""" + transient(sub=2)

BRIDGE_CHANNELS = [Channel("pier_acc", "m/s2", "acc.out", 1, "top of the pier"), Channel("deck_acc", "m/s2", "acc.out", 2, "deck"),
                   Channel("pier_disp", "m", "disp.out", 1, "top of the pier"), Channel("deck_disp", "m", "disp.out", 2, "deck")]
BRIDGE_ALL = [c.name for c in BRIDGE_CHANNELS]


def bridge(rng, pga=(3.5, 4.5)):
    W = 1200.0 * 9.81
    parameters = {"Qd": 0.06 * W / 4, "kd": 1200.0 * (6.2832 / 2.2) ** 2 / 4, "rE": rng.uniform(0.85, 1.1)}
    return "bridge of three spans on isolators", BRIDGE, parameters, events(rng, pga, ("east", "west"), 18.0), BRIDGE_CHANNELS


def bridge_that_pounds(rng):
    def conceal(m):
        wall = ("uniaxialMaterial HyperbolicGapMaterial 8 60000.0 60000.0 0.7 4000.0 -0.05\nelement zeroLength 20 15 14 -mat 8 -dir 1\n")
        return {"cause": "gap_impact", "script": swapped(m.filled(), "# bearings\n", wall + "# bearings\n"), "where": place(m, "deck_acc", BRIDGE_ALL, "abutment")}
    return (*bridge(rng, (4.5, 5.5)), conceal)


def bridge_on_soil(rng):
    def conceal(m):
        text = swapped(m.filled(), "fix 1 1 1 1\nfix 2 1 1 1\n", "node 21 25.0 -9.0\nnode 22 55.0 -9.0\nfix 21 1 1 1\nfix 22 1 1 1\nmass 1 80.0 80.0 150.0\nmass 2 80.0 80.0 150.0\n")
        soil = ("uniaxialMaterial PySimple1 31 2 9000.0 0.006 0.0 300.0\nuniaxialMaterial Elastic 32 4.0e6\nuniaxialMaterial Elastic 33 1.2e7 6.0e4\n"
                "element zeroLength 31 21 1 -mat 31 32 33 -dir 1 2 3\nelement zeroLength 32 22 2 -mat 31 32 33 -dir 1 2 3\n")
        return {"cause": "foundation_flexibility", "script": swapped(text, "# bearings\n", soil + "# bearings\n"), "where": place(m, "pier_disp", BRIDGE_ALL, "support")}
    return (*bridge(rng), conceal)


def bridge_shaken_apart(rng):
    """Ground motion that comes to the second pier and the far abutment later: none of the library."""
    def conceal(m):
        text = m.filled()
        d, a = 0.16, line(text, "pattern UniformExcitation")
        late = ("timeSeries Path 2 -dt $dt -filePath $motion -startTime %g\n" % d)
        sides = ("pattern MultipleSupport 1 {\n    groundMotion 1 Plain -accel 1\n    groundMotion 2 Plain -accel 2\n"
                 "    imposedMotion 1 1 1\n    imposedMotion 10 1 1\n    imposedMotion 2 1 2\n    imposedMotion 15 1 2\n}")
        text = swapped(text, a, late + sides)
        text = swapped(text, "recorder Node -file acc.out -timeSeries 1 -time -node 3 12 -dof 1 accel", "recorder Node -file acc.out -time -node 3 12 -dof 1 accel")
        text = swapped(text, "recorder Node -file disp.out -time -node 3 12 -dof 1 disp", "recorder Node -file total.out -time -node 1 3 12 -dof 1 disp")
        text = swapped(text, "constraints Plain", "constraints Transformation")
        text += """
remove recorders
set in [open total.out r]
set out [open disp.out w]
foreach {t g p d} [read $in] {puts $out "$t [expr $p-$g] [expr $d-$g]"}
close $in
close $out
"""
        return {"cause": "unknown", "script": text, "where": place(m, "pier_acc", BRIDGE_ALL, "support")}
    return (*bridge(rng), conceal)


# ------------------------------------------------------------------ bearings on a rig

BEARING = """wipe
model basic -ndm 3 -ndf 6
pset {first} @{first}@
pset G @G@
node 1 0.0 0.0 0.0
node 2 0.0 0.0 {height}
fix 1 1 1 1 1 1 1
fix 2 0 1 {vertical} 1 1 1
{element}
{weight}timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {{
    sp 2 {dof} 1.0
}}
recorder Element -file force.out -time -ele 1 force
""" + RIG.replace("{", "{{").replace("}", "}}")

TANK = """wipe
model basic -ndm 3 -ndf 6
pset Fy @Fy@
pset G @G@
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 200.0 200.0 200.0 0.0 0.0 0.0
element LeadRubberX 1 1 2 $Fy 0.08 $G 2.0e6 0.12 0.70 0.003 0.008 25 0 0 1 1 0 0 10.0 0.75 1.0 0.5 0.0 5.0 0.005 11.2 130. 0.05 1.41e-5 0 0 0 0 0
set axial 1962.0
""" + WEIGHT + """timeSeries Path 2 -dt $dt -filePath $motion
timeSeries Path 3 -dt $dt -filePath $second
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
recorder Node -file disp.out -time -node 2 -dof 1 2 disp
recorder Element -file force.out -time -ele 1 force
""" + transient("Plain", "FullGeneral", 2)


def lead_that_heats(rng):
    runs = [run(name, role, 0.01, signals.quake(rng, size, 25.0, 0.01), signals.quake(rng, 0.8 * size, 25.0, 0.01))
            for name, role, size in (("long", "fit", 5.0), ("check", "holdout", 6.0))]
    channels = [Channel("disp_x", "m", "disp.out", 1, "tank"), Channel("disp_y", "m", "disp.out", 2, "tank"),
                Channel("force_x", "kN", "force.out", 7, "element 1"), Channel("force_y", "kN", "force.out", 8, "element 1")]

    def conceal(m):
        return {"cause": "self_heating", "script": swapped(m.filled(), "1.41e-5 0 0 0 0 0", "1.41e-5 0 0 0 0 1"),
                "where": place(m, "disp_x", [c.name for c in channels], "element 1", ["long"])}
    return "tank on a lead rubber bearing", TANK, {"Fy": 110.0, "G": 450.0}, runs, channels, conceal


ELASTOMERIC = "element ElastomericX 1 1 2 $Fy 0.10 $G 2.0e6 0.10 0.55 0.003 0.007 22 0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0 0.0 0 0 0 0"


def rubber_that_cavitates(rng):
    script = BEARING.format(first="Fy", height=0.25, vertical=0, element=ELASTOMERIC.replace("$Fy", "60.0"), weight="", dof=3).replace("pset Fy @Fy@\n", "")
    runs = [cycling("pulls", "fit", [0.0012, 0.002, 0.003, 0.004, 0.003, 0.004], 0.1), cycling("check", "holdout", [0.002, 0.0035, 0.0035, 0.005], 0.1)]

    def conceal(m):
        return {"cause": "cavitation", "script": swapped(m.filled(), "0.0 0.0 0.0 0 0 0 0", "0.0 0.0 0.0 1 0 0 0"), "where": place(m, "force", ["force"], "element 1")}
    return "low damping rubber bearing, pulled", script, {"G": 500.0}, runs, [Channel("force", "kN", "force.out", 9, "element 1")], conceal


def rubber_under_weight(rng):
    element = ELASTOMERIC.replace("0.003 0.007 22", "0.003 0.009 28")
    script = BEARING.format(first="Fy", height=0.35, vertical=0, element=element, weight=WEIGHT, dof=1)
    runs = [cycling("light", "fit", [0.08, 0.16, 0.16], 0.2, axial=500.0), cycling("heavy", "fit", [0.08, 0.16, 0.16], 0.2, axial=2600.0),
            cycling("check", "holdout", [0.12, 0.18], 0.2, axial=2000.0)]

    def conceal(m):
        return {"cause": "axial_shear_interaction", "script": swapped(m.filled(), "0.0 0.0 0.0 0 0 0 0", "0.0 0.0 0.0 0 0 1 0"), "where": place(m, "force", ["force"], "element 1")}
    return "rubber bearing under two weights", script, {"Fy": 55.0, "G": 480.0}, runs, [Channel("force", "kN", "force.out", 7, "element 1")], conceal


def bearing_that_stiffens(rng):
    element = ("uniaxialMaterial Elastic 1 1.5e6\nuniaxialMaterial Elastic 2 1.0e3\n"
               "element elastomericBearingPlasticity 1 1 2 [expr 12.0*$G] $Qd 0.0833333 0.0 2.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0")
    script = BEARING.format(first="Qd", height=0.3, vertical=0, element=element, weight=WEIGHT, dof=1)
    runs = [cycling("large", "fit", [0.06, 0.12, 0.2, 0.28, 0.28], 0.25, axial=1200.0), cycling("check", "holdout", [0.1, 0.24, 0.24], 0.25, axial=1200.0)]

    def conceal(m):
        return {"cause": "strain_stiffening", "script": swapped(m.filled(), "0.0833333 0.0 2.0", "0.0833333 0.25 3.0"), "where": place(m, "force", ["force"], "element 1")}
    return "high damping rubber bearing", script, {"Qd": 70.0, "G": 900.0}, runs, [Channel("force", "kN", "force.out", 7, "element 1")], conceal


# ------------------------------------------------------------------ walls and columns on a rig

WALL = """wipe
model basic -ndm 1 -ndf 1
pset Fy @Fy@
pset K @K@
pset r @r@
node 1 0.0
node 2 0.0
fix 1 1
set u [expr 1.0*$Fy/$K]
set F2 [expr $Fy*(1.0+7.0*$r)]
set F3 [expr $Fy*(1.0+20.0*$r)]
uniaxialMaterial Hysteretic 1 $Fy $u $F2 [expr 8.0*$u] $F3 [expr 21.0*$u] -$Fy -$u -$F2 [expr -8.0*$u] -$F3 [expr -21.0*$u] 1.0 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
""" + RIG.replace("constraints Transformation", "constraints Penalty 1e10 1e10")


def wall(rng):
    u = 0.006
    parameters = {"Fy": 300.0, "K": 300.0 / u, "r": 0.03}
    steps = [u * s for s in (1.5, 1.5, 3, 3, 3, 5, 5, 5, 7, 7, 7)]
    runs = [run("steps", "fit", 0.05, signals.cycles(steps, 0.1, 0.05)), run("check", "holdout", 0.05, signals.cycles([u * s for s in (2, 4, 4, 4, 6, 6)], 0.1, 0.05))]
    return "wall under cyclic shear", WALL, parameters, runs, [Channel("force", "kN", "force.out", 2, "wall")]


def wall_that_slips(rng):
    def conceal(m):
        return {"cause": "pinching", "script": swapped(m.filled(), "1.0 1.0 0.0 0.0 0.0", "0.75 0.25 0.0 0.0 0.0"), "where": place(m, "force", ["force"], "wall")}
    return (*wall(rng), conceal)


def wall_that_degrades(rng):
    def conceal(m):
        return {"cause": "cyclic_degradation", "script": swapped(m.filled(), "1.0 1.0 0.0 0.0 0.0", "1.0 1.0 0.0 0.25 0.0"), "where": place(m, "force", ["force"], "wall")}
    return (*wall(rng), conceal)


SEED, STREAM = 5, "structures"
NAMES = ("kyanite", "lazurite", "malachite", "nephrite", "onyx", "peridot", "quartz", "ruby", "sapphire", "topaz", "unakite", "variscite", "wulfenite", "xenotime", "zircon")
CASES = (frame_with_fibers, bridge_on_soil, isolated_as_it_is, lead_that_heats, wall_that_slips, isolated_eccentric, bridge_that_pounds, frame_with_dampers,
         rubber_that_cavitates, bridge_shaken_apart, bearing_that_stiffens, wall_that_degrades, isolated_with_rate, rubber_under_weight, frame_with_lag)
