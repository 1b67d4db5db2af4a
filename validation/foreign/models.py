"""Models of foreign kinds and what is concealed in each. Each has the units that its script says."""

import math

from generator import signals
from generator.model import Channel, number
from models import place, run, swapped


# ------------------------------------------------------------------ means

def context(self, run, times, rng):
    """Columns that no observation names: functions of time that a run carries, with a little scatter."""
    out = []
    for head, (of, scatter) in getattr(run, "aside", {}).items():
        out.append((head, [f"{of(t) + rng.gauss(0, scatter):.5g}" for t in times]))
    return out


UNTIMED = {"untimed.txt": None, "rows.txt": None}  # recorder files without -time; no channel is their column 0


def columns_of(plain):
    def columns(path):
        table = plain(path)
        name = path.rsplit("/", 1)[-1]
        if table and name in UNTIMED:
            table[0] = [(i + 1) * UNTIMED[name] for i in range(len(table[0]))]
        return table
    return columns


def quakes(rng, names, pga, seconds, dt, two=False, second=0.8):
    roles = ["fit"] * (len(names) - 1) + ["holdout"]
    out = []
    for name, role, size in zip(names, roles, pga):
        motions = [signals.quake(rng, size, seconds, dt)]
        if two:
            motions.append(signals.quake(rng, second * size, seconds, dt))
        out.append(run(name, role, dt, *motions))
    return out


# ------------------------------------------------------------------ 0: lead rubber bearing in a test frame with a loading beam [N, m, Pa]

LRB = """# prototype test, lead rubber bearing dia. 0.70 m  (N, m, Pa)
wipe
model basic -ndm 2 -ndf 3
pset Gr   @Gr@      ;# shear modulus of the rubber
pset tauL @tauL@    ;# yield stress of the lead

# ---- geometry
set Ar 0.385
set Hr 0.14
set Ap 0.0177
node 1 0.00 0.00
node 2 0.00 0.32
node 3 0.60 0.32
fix 1 1 1 1
fix 2 0 1 1
fix 3 0 1 1

# ---- bearing; loading beam between bearing and actuator
uniaxialMaterial KikuchiAikenLRB 10 1 $Ar $Hr $Gr $Ap $tauL 0.588e6 13.0
uniaxialMaterial Elastic 11 4.0e8
element zeroLength 99 2 2 -mat 11 -dir 2
element twoNodeLink 1 1 2 -mat 10 -dir 2
element truss 2 2 3 1.0 12

timeSeries Path 5 -dt $dt -filePath $motion
pattern MultipleSupport 5 {
    groundMotion 5 Plain -disp 5
    imposedMotion 3 1 5
}
recorder Node -file bearing.txt -time -node 2 -dof 1 disp
recorder Element -file shear.txt -time -ele 1 localForce

constraints Transformation
numberer Plain
system FullGeneral
test NormDispIncr 1.0e-9 100
algorithm Newton
integrator LoadControl $dt
analysis Static
set n [expr int($npts) - 1]
while {$n > 0} {
    if {[analyze 1] != 0} {error "step [getTime] s did not converge"}
    incr n -1
}
""".replace("element zeroLength 99 2 2 -mat 11 -dir 2\n", "").replace("uniaxialMaterial Elastic 11 4.0e8", "uniaxialMaterial Elastic 12 4.0e8")


def lrb_rig(rng):
    dt = 0.02
    hot = {}
    runs = []
    for name, role, T, sizes, f in (("summer", "fit", 38.0, [0.07, 0.14, 0.21, 0.14], 0.2), ("winter", "fit", -18.0, [0.07, 0.14, 0.21, 0.14], 0.2),
                                    ("autumn", "holdout", -8.0, [0.10, 0.18, 0.18], 0.2)):
        r = run(name, role, dt, signals.cycles(sizes, f, dt), T=T)
        r.aside = {"temperature[degC]": (lambda t, T=T: T, 0.15)}
        runs.append(r)
    channels = [Channel("shear", "N", "shear.txt", 5, "element 1")]
    return "lead rubber bearing with a loading beam", LRB, {"Gr": rng.uniform(3.6e5, 4.3e5), "tauL": rng.uniform(7.6e6, 8.8e6)}, runs, channels


def case_a(rng):
    def conceal(m):
        return {"cause": "ambient_temperature", "script": swapped(m.filled(), "0.588e6 13.0", "0.588e6 13.0 -T $T"), "where": place(m, "shear", ["shear"], "element 1")}
    return (*lrb_rig(rng), conceal)


# ------------------------------------------------------------------ 1: tank on a high damping bearing [kN, m, t]

TANK = """# elevated tank, full, on one high-damping rubber bearing          kN - m - t - s
model basic -ndm 3 -ndf 6
pset a1 @a1@
pset b1 @b1@

proc support {tag bottom top height} {
    global a1 b1
    node $bottom 0. 0. 0.
    node $top    0. 0. $height
    fix $bottom 1 1 1 1 1 1
    fix $top    0 0 1 1 1 1
    element HDR $tag $bottom $top 700. 2.0e6 0. 0.6 0.003 0.008 20 $a1 -700. 2500. $b1 300. 30. @cs@ 0 0 1 1 0 0 10. 0.7 1. 0.5 0.0 0.
}
support 7 1 2 0.25
mass 2 150. 150. 150. 0. 0. 0.

timeSeries Path 11 -dt $dt -filePath $motion
timeSeries Path 12 -dt $dt -filePath $second
pattern UniformExcitation 11 1 -accel 11
pattern UniformExcitation 12 2 -accel 12

recorder Node -file tank.out -time -node 2 -dof 1 2 disp
recorder Node -file acc.out -timeSeries 11 12 -time -node 2 -dof 1 2 accel

system FullGeneral
numberer Plain
constraints Plain
test EnergyIncr 1.0e-12 50
integrator Newmark 0.5 0.25
algorithm Newton
analysis Transient
if {[analyze [expr int($npts)-1] $dt] != 0} {error "stopped at [getTime]"}
"""


def tank(rng):
    runs = quakes(rng, ("record1", "record2", "record3"), (3.2, 4.2, 4.0), 15.0, 0.01, two=True, second=0.7)
    channels = [Channel("ux", "m", "tank.out", 1, "tank"), Channel("uy", "m", "tank.out", 2, "tank"), Channel("ax", "m/s2", "acc.out", 1, "tank"), Channel("ay", "m/s2", "acc.out", 2, "tank")]
    return "elevated tank on a rubber bearing", TANK.replace("@cs@", "0. 0. 0. 0."), {"a1": rng.uniform(800.0, 1000.0), "b1": rng.uniform(26.0, 34.0)}, runs, channels


def case_b(rng):
    def conceal(m):
        return {"cause": "mullins_softening", "also": [], "script": swapped(m.filled(), "0. 0. 0. 0. 0 0 1", "0.1 0.1 0.8 3. 0 0 1"),
                "where": place(m, "ux", ["ux", "uy", "ax", "ay"], "element 7")}
    return (*tank(rng), conceal)


# ------------------------------------------------------------------ 2: pendulum on a rig [kN, mm]

PENDULUM = """# curved slider, type test, quasi-static        units: kN, mm
wipe
model BasicBuilder -ndm 2 -ndf 3
pset mu @mu@
pset R  @R@
set W 1500.0
node 1 0 0
node 2 0 0
fix 1 1 1 1
fix 2 0 0 1
frictionModel Coulomb 1 $mu
uniaxialMaterial Elastic 1 8000.0
uniaxialMaterial Elastic 2 1.0e6
element singleFPBearing 1 1 2 1 $R 120.0 -P 1 -Mz 2 -orient 0 1 0 -1 0 0 -iter 50 1e-10
proc solver {step} {
    constraints Transformation
    numberer Plain
    system FullGeneral
    test NormDispIncr 1.0e-7 80
    algorithm Newton
    integrator LoadControl $step
    analysis Static
}
# 1) vertical load
pattern Plain 1 Linear {
    load 2 0.0 [expr -$W] 0.0
}
solver 0.25
if {[analyze 4] < 0} {error "vertical load"}
loadConst -time 0.0
# 2) path of the actuator
timeSeries Path 3 -dt $dt -filePath $motion
pattern Plain 3 3 {
    sp 2 1 1.0
}
recorder Node -file actuator.out -time -node 1 -dof 1 2 reaction
solver $dt
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] < 0} {error "at [getTime]"}
}
"""


def axial_of(t):
    return 1500.0 * (1.0 + AXIAL * math.sin(2 * math.pi * 0.11 * t))


AXIAL = 0.22


def pendulum(rng):
    runs = []
    for name, role, sizes, f in (("T1", "fit", [60.0, 120.0, 180.0, 180.0], 0.16), ("T2", "fit", [150.0] * 4, 0.2), ("T3", "holdout", [90.0, 160.0, 200.0], 0.125)):
        r = run(name, role, 0.025, signals.cycles(sizes, f, 0.025))
        r.aside = {"axial[kN]": (axial_of, 6.0)}
        runs.append(r)
    return "curved slider, type test", PENDULUM, {"mu": rng.uniform(0.055, 0.075), "R": rng.uniform(2100.0, 2500.0)}, runs, [Channel("force", "kN", "actuator.out", 1, "reaction frame")]


def case_c(rng):
    def conceal(m):
        jack = f"timeSeries Trig 4 0.0 1000.0 {number(1 / 0.11)}\npattern Plain 4 4 {{\n    load 2 0.0 [expr -{AXIAL}*$W] 0.0\n}}\n"
        return {"cause": "varying_axial_load", "script": swapped(m.filled(), "timeSeries Path 3", jack + "timeSeries Path 3"), "where": place(m, "force", ["force"], "element 1")}
    return (*pendulum(rng), conceal)


# ------------------------------------------------------------------ 3: block foundation of a machine [lb, in, s]

BLOCK = """#===============================================================
#  BLOCK FOUNDATION OF A COMPRESSOR - RUN-UP            lb, in, s
#===============================================================
wipe
model basic -ndm 2 -ndf 3
pset kx @kx@
pset cx @cx@
pset kr @kr@
set g 386.4
set Wb 148000.        ;# block
set Wm  26000.        ;# machine
node 1  0.   0.
node 2  0.  42.       ;# CG of the block
node 3  0. 120.       ;# shaft
node 10 0.   0.
fix 10 1 1 1
mass 2 [expr $Wb/$g] [expr $Wb/$g] [expr 1.15e8/$g]
mass 3 [expr $Wm/$g] [expr $Wm/$g] 1.0
uniaxialMaterial Elastic 1 $kx $cx
uniaxialMaterial Elastic 2 2.2e6 2.4e4
uniaxialMaterial Elastic 3 [expr 1.0e9*$kr] 1.3e7
element zeroLength 1 10 1 -mat 1 2 3 -dir 1 2 6
# elements of the block and the pedestal
geomTransf Linear 1
element elasticBeamColumn 2 1 2 8000. 3.6e6 1.0e7 1
element elasticBeamColumn 3 2 3 1500. 3.6e6 8.0e5 1
# rotating force at the shaft
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    load 3 1.0 0.0 0.0
}
recorder Node -file shaft.out -time -node 3 -dof 1 disp
recorder Node -file block.out -time -node 2 -dof 1 3 accel
constraints Plain
numberer RCM
system ProfileSPD
test NormDispIncr 1.e-10 20
algorithm Newton
integrator HHT 0.95
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
"""


def block(rng):
    runs = [run(name, role, 0.006, [v for v in signals.sweep(size, f0, f1, 8.4, 0.006)])
            for name, role, size, f0, f1 in (("low", "fit", 5200.0, 2.0, 14.0), ("high", "fit", 15000.0, 2.0, 14.0), ("down", "holdout", 8500.0, 15.0, 2.5))]
    channels = [Channel("shaft", "in", "shaft.out", 1, "shaft"), Channel("block", "in/s2", "block.out", 1, "block")]
    return "block foundation of a compressor", BLOCK, {"kx": rng.uniform(7.0e5, 9.0e5), "cx": rng.uniform(4.0e3, 5.5e3), "kr": rng.uniform(3.2, 4.2)}, runs, channels


def case_d(rng):
    def conceal(m):
        guide = "uniaxialMaterial ElasticPP 4 6.0e6 4.0e-4\nelement zeroLength 4 10 1 -mat 4 -dir 1\n"
        return {"cause": "friction", "script": swapped(m.filled(), "# elements of the block", guide + "# elements of the block"), "where": place(m, "shaft", ["shaft", "block"], "support")}
    return (*block(rng), conceal)


# ------------------------------------------------------------------ 4: braced frame [N, mm, t]

BRACED = """# Industrial frame, two braced bays, pinned columns          [N, mm, t, s]
wipe; model basic -ndm 2 -ndf 2
pset rA @rA@
pset fy @fy@
pset aM @aM@
set E 2.05e5
set A [expr 1750.0*$rA]

set x {0.0 6000.0 12000.0}
foreach n {1 2 3} X $x {
    node $n $X 0.0
    node 1$n $X 4200.0 -mass 34.0 34.0
    fix $n 1 1
}
uniaxialMaterial Elastic 1 $E
uniaxialMaterial Steel02 2 $fy $E 0.01 18.0 0.925 0.15
foreach n {1 2 3} {element truss $n $n 1$n 9100.0 1}      ;# columns
element truss 4 11 12 6000.0 1                            ;# struts
element truss 5 12 13 6000.0 1
element corotTruss 21 1 12 $A 2                           ;# braces
element corotTruss 22 3 12 $A 2
rayleigh $aM 0.0 0.0 0.0006

timeSeries Path 1 -dt $dt -filePath $motion -factor 1000.0
pattern UniformExcitation 1 1 -accel 1
recorder Node -file roof.out -time -node 12 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 12 -dof 1 accel
recorder Element -file brace1.out -time -ele 21 axialForce
recorder Element -file brace2.out -time -ele 22 axialForce

constraints Plain; numberer RCM; system BandGeneral
test NormDispIncr 1.0e-7 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at $i"}
}
"""


def braced(rng):
    runs = quakes(rng, ("rec01", "rec02", "rec03"), (1.7, 2.3, 2.1), 10.0, 0.01)
    channels = [Channel("roof", "mm", "roof.out", 1, "roof"), Channel("acc", "mm/s2", "acc.out", 1, "roof"), Channel("west", "N", "brace1.out", 1, "element 21"), Channel("east", "N", "brace2.out", 1, "element 22")]
    return "industrial frame with two braces", BRACED, {"rA": rng.uniform(0.9, 1.1), "fy": rng.uniform(265.0, 310.0), "aM": rng.uniform(0.3, 0.6)}, runs, channels


def case_e(rng):
    def conceal(m):
        text = m.filled()
        text = swapped(text, "model basic -ndm 2 -ndf 2", "model basic -ndm 2 -ndf 3")
        text = swapped(text, "-mass 34.0 34.0\n    fix $n 1 1\n", "-mass 34.0 34.0 0.0\n    fix $n 1 1 1\n    fix 1$n 0 0 1\n")
        old = "element corotTruss 21 1 12 $A 2                           ;# braces\nelement corotTruss 22 3 12 $A 2\n"
        new = """geomTransf Corotational 9
set b [expr $A/280.0]
section Fiber 9 {
    patch rect 2 10 1 -140.0 [expr -$b/2.0] 140.0 [expr $b/2.0]
}
foreach {e i x0} {21 1 0.0 22 3 12000.0} {
    for {set k 1} {$k <= 5} {incr k} {
        set s [expr ($k-1)/4.0]
        set off [expr 7.3*sin(3.14159265*$s)]
        node [expr 100*$e+$k] [expr $x0+$s*(6000.0-$x0)] [expr 4200.0*$s+$off]
    }
    equalDOF $i [expr 100*$e+1] 1 2
    equalDOF 12 [expr 100*$e+5] 1 2
    for {set k 1} {$k <= 4} {incr k} {
        set tag [expr $k==1 ? $e : 100*$e+$k]
        element forceBeamColumn $tag [expr 100*$e+$k] [expr 100*$e+$k+1] 3 9 9
    }
}
"""
        text = swapped(text, old, new)
        text = text.replace("axialForce", "basicForce").replace("constraints Plain", "constraints Transformation").replace("system BandGeneral", "system UmfPack")
        text = swapped(text, "if {[analyze 1 $dt] != 0} {error \"no convergence at $i\"}", """set ok [analyze 4 [expr $dt/4.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 40 [expr $dt/40.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at $i"}""")
        return {"cause": "axial_shear_interaction", "script": text, "where": place(m, "west", ["roof", "acc", "west", "east"], "braces")}
    return (*braced(rng), conceal)


# ------------------------------------------------------------------ 5: isolated frame of one bay in space [kN, m, t]

SPACE = """# One-storey frame of one bay on four rubber bearings, kN m t s
wipe
model basic -ndm 3 -ndf 6
pset Qd @Qd@
pset k2 @k2@
pset rI @rI@

set corners {1 0.0 0.0  2 7.2 0.0  3 7.2 5.4  4 0.0 5.4}
uniaxialMaterial Elastic 1 2.0e6
uniaxialMaterial Elastic 2 5.0e3
geomTransf Linear 1 1.0 0.0 0.0
geomTransf Linear 2 0.0 0.0 1.0
set E 3.0e7
foreach {c x y} $corners {
    node $c    $x $y -0.30          ;# pedestal
    node 10$c  $x $y  0.00          ;# above the bearing
    node 20$c  $x $y  3.60          ;# roof
    fix $c   1 1 1 1 1 1
    fix 10$c 0 0 1 1 1 0            ;# grid of ground beams is stiff
    fix 20$c 0 0 1 0 0 0
    element elastomericBearingPlasticity $c $c 10$c [expr 10.0*$k2] [expr 0.9*$Qd/0.9] 0.1 0.0 2.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
    element elasticBeamColumn 5$c 10$c 20$c 0.16 $E 1.25e7 0.0036 [expr $rI*0.00213] [expr $rI*0.00213] 1
}
foreach {b i j} {61 201 202  62 202 203  63 203 204  64 204 201} {
    element elasticBeamColumn $b $i $j 0.15 $E 1.25e7 0.003 0.002 0.0045 2
}
# floors
node 100 3.6 2.7 0.0
node 200 3.6 2.7 3.6
fix 100 0 0 1 1 1 0
fix 200 0 0 1 1 1 0
rigidDiaphragm 3 100 101 102 103 104
rigidDiaphragm 3 200 201 202 203 204
mass 100 42.0 42.0 0.0 0.0 0.0 285.0
mass 200 36.0 36.0 0.0 0.0 0.0 245.0
rayleigh 0.15 0.0 0.0 0.0012

timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
foreach d {1 2} {pattern UniformExcitation $d $d -accel $d}
recorder Node -file x.out -timeSeries 1 -time -node 101 203 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 101 203 -dof 2 accel
recorder Node -file u.out -time -node 101 102 -dof 1 2 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-10 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at $i"}
}
""".replace("[expr 0.9*$Qd/0.9]", "$Qd")


def space(rng):
    M = 78.0
    runs = quakes(rng, ("ns", "ew"), (3.4, 4.3), 12.0, 0.02, two=True)
    channels = [Channel("base_x", "m/s2", "x.out", 1, "corner 1"), Channel("roof_x", "m/s2", "x.out", 2, "roof"), Channel("base_y", "m/s2", "y.out", 1, "corner 1"),
                Channel("ux", "m", "u.out", 1, "corner 1"), Channel("uy1", "m", "u.out", 2, "corner 1"), Channel("uy2", "m", "u.out", 4, "corner 2")]
    return "frame of one bay on four bearings", SPACE, {"Qd": 0.05 * M * 9.81 / 4 * rng.uniform(0.9, 1.1), "k2": M * (6.2832 / 2.1) ** 2 / 4, "rI": rng.uniform(0.85, 1.15)}, runs, channels


def case_f(rng):
    return (*space(rng), lambda m: {"cause": "none", "script": m.filled()})


# ------------------------------------------------------------------ 6: bridge bent with pendulums on its columns [kN, m, t]

BENT = """# Transverse model of pier 4: a round column and a pendulum under the deck.      kN, m, t
wipe
model basic -ndm 3 -ndf 6
pset mu @mu@
pset R  @R@
pset rE @rE@
set W 2400.0                             ;# weight on the pendulum
node 11 0 0 0                            ;# footing
node 21 0 0 7.5                          ;# column top
node 31 0 0 7.5                          ;# slider
fix 11 1 1 1 1 1 1
fix 21 1 0 0 0 1 1
fix 31 1 0 0 1 1 1
mass 21 0.0 44.0 44.0 0.0 0.0 0.0
mass 31 0.0 [expr $W/9.81] [expr $W/9.81] 0.0 0.0 0.0
geomTransf PDelta 1 1 0 0
element elasticBeamColumn 1 11 21 1.13 [expr $rE*3.1e7] 1.3e7 0.2 0.07 0.07 1
uniaxialMaterial Elastic 1 4.0e5
uniaxialMaterial Elastic 2 10.0
element FPBearingPTV 4 21 31 $mu 0 30000.0 @heat@ 4.44e-6 0.018 1 20. $R @a@ 6000. 1 2 2 2 0 0 1 1 0 0 0 0 0. 15 1e-6 2
rayleigh 0.2 0.0 0.0 0.001
# dead load
timeSeries Linear 1
pattern Plain 1 1 {
    load 31 0 0 [expr -$W] 0 0 0
}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-9 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
# earthquake
timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 2 -accel 2
recorder Node -file deck.out -time -node 31 21 -dof 2 disp
recorder Node -file acc.out -timeSeries 2 -time -node 31 -dof 2 accel
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-6 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1 $dt]
    if {$ok != 0} {error "no convergence at [getTime]"}
}
"""


def bent(rng):
    runs = quakes(rng, ("event1", "event2", "event3"), (4.2, 5.6, 5.0), 10.0, 0.01)
    channels = [Channel("deck", "m", "deck.out", 1, "deck"), Channel("column", "m", "deck.out", 2, "top of the column"), Channel("acc", "m/s2", "acc.out", 1, "deck")]
    return "bridge pier with a pendulum", BENT.replace("@heat@", "0").replace("@a@", "0.175"), {"mu": rng.uniform(0.07, 0.09), "R": rng.uniform(1.9, 2.3), "rE": rng.uniform(0.85, 1.1)}, runs, channels


def case_g(rng):
    def conceal(m):
        return {"cause": "self_heating", "script": swapped(m.filled(), "30000.0 0 4.44e-6", "30000.0 1 4.44e-6"), "where": place(m, "deck", ["deck", "column", "acc"], "pendulums")}
    return (*bent(rng), conceal)


# ------------------------------------------------------------------ 7: platform on flat sliders with a spring [N, m, kg]

FLAT = """# floor of a computer hall: flat sliders and a centring spring            N, m, kg
wipe
model basic -ndm 2 -ndf 3
pset mu @mu@
pset ks @ks@
set M 5400.
node 1 0. 0.
node 2 0. 0. -mass $M $M 0.
fix 1 1 1 1
fix 2 0 0 1
frictionModel Coulomb 1 $mu
uniaxialMaterial Elastic 1 5.0e8
uniaxialMaterial Elastic 2 1.0e3
uniaxialMaterial Elastic 3 $ks 500.
element flatSliderBearing 1 1 2 1 8.0e5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0 -iter 50 1e-12
element zeroLength 2 1 2 -mat 3 -dir 1
pattern Plain 1 "Linear" {
    load 2 0. [expr -9.81*$M] 0.
}
proc integrate {what args} {
    constraints Plain
    numberer Plain
    system FullGeneral
    test NormDispIncr 1.0e-10 60
    algorithm Newton
    eval integrator $args
    analysis $what
}
integrate Static LoadControl 0.5
analyze 2
loadConst -time 0.
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
recorder Node -file untimed.txt -node 2 -dof 2 1 disp
recorder Node -file floor.txt -timeSeries 2 -time -node 2 -dof 1 accel
integrate Transient HHT 0.95
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "step $i"}
}
""".replace('pattern Plain 1 "Linear" {', "timeSeries Linear 1\npattern Plain 1 1 {")
UNTIMED["untimed.txt"] = 0.01


def flat(rng):
    runs = quakes(rng, ("sim1", "sim2"), (2.4, 3.1), 14.0, 0.01)
    channels = [Channel("stroke", "m", "untimed.txt", 1, "floor"), Channel("acc", "m/s2", "floor.txt", 1, "floor")]
    return "floor of a computer hall on sliders", FLAT, {"mu": rng.uniform(0.045, 0.06), "ks": 5400.0 * (6.2832 / rng.uniform(2.6, 3.1)) ** 2}, runs, channels


DRIFT = 0.03


def case_h(rng):
    def conceal(m):
        def wanders(r, channels):
            x = channels["stroke"]
            top, n = signals.peak(x), len(x)
            knots = {"sim1": ((0.0, 0.0), (0.25, 0.3), (0.55, 1.0), (1.0, 0.8)), "sim2": ((0.0, 0.0), (0.4, -0.6), (0.7, -0.2), (1.0, -1.0))}[r.name]
            channels["stroke"] = [v + DRIFT * 2.2 * top * signals.interpolate([k for k, _ in knots], [d for _, d in knots], i / (n - 1)) for i, v in enumerate(x)]
        return {"cause": "sensor_drift", "script": m.filled(), "fault": wanders, "where": place(m, "stroke", ["stroke"], "floor")}
    return (*flat(rng), conceal)


# ------------------------------------------------------------------ 8: two neighbours [kip, in, s]

NEIGHBOURS = """# Hotel (3 storeys) and its annex (2 storeys), stick models side by side. kip-in-sec
wipe
model basic -ndm 1 -ndf 1
pset kH @kH@
pset kA @kA@
set g 386.1

proc stick {first weights stiffness ratios eta} {
    global g
    node $first 0.0
    fix $first 1
    set below $first
    foreach W $weights r $ratios {
        set n [expr $below+1]
        node $n 0.0 -mass [expr $W/$g]
        uniaxialMaterial Elastic $n [expr $r*$stiffness] [expr $eta*$r*$stiffness]
        element zeroLength $n $below $n -mat $n -dir 1
        set below $n
    }
}
stick 100 {520.0 520.0 440.0} $kH {1.0 0.9 0.75} 0.008
stick 200 {300.0 260.0}       $kA {1.0 0.8}      0.004

timeSeries Path 1 -dt $dt -filePath $motion -factor $g
pattern UniformExcitation 1 1 -accel 1
recorder Node -file hotel.out -timeSeries 1 -time -node 102 103 -dof 1 accel
recorder Node -file annex.out -timeSeries 1 -time -node 202 -dof 1 accel
recorder Node -file disp.out -time -node 103 202 -dof 1 disp
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 2 [expr $dt/2.0]]} {error "no convergence at [getTime]"}
}
"""


def neighbours(rng):
    runs = quakes(rng, ("A", "B"), (0.24, 0.31), 14.0, 0.01)
    channels = [Channel("hotel2", "in/s2", "hotel.out", 1, "hotel, floor 2"), Channel("hotel3", "in/s2", "hotel.out", 2, "hotel, roof"), Channel("annex2", "in/s2", "annex.out", 1, "annex, roof"),
                Channel("hotel_roof", "in", "disp.out", 1, "hotel, roof"), Channel("annex_roof", "in", "disp.out", 2, "annex, roof")]
    return "hotel and annex side by side", NEIGHBOURS, {"kH": rng.uniform(420.0, 520.0), "kA": rng.uniform(640.0, 780.0)}, runs, channels


def case_i(rng):
    def conceal(m):
        joint = "uniaxialMaterial ImpactMaterial 900 1500.0 600.0 -0.05 -2.6\nelement zeroLength 900 102 202 -mat 900 -dir 1\n"
        text = swapped(m.filled(), "timeSeries Path 1", joint + "timeSeries Path 1").replace("analyze 2 [expr $dt/2.0]", "analyze 5 [expr $dt/5.0]")
        return {"cause": "gap_impact", "script": text, "where": place(m, "annex2", [c.name for c in m.channels], "joint between the buildings")}
    return (*neighbours(rng), conceal)


# ------------------------------------------------------------------ 9: shear building of links with a damper [N, m, kg]

SHEAR = """# office block: storeys as twoNodeLink, viscous damper in the first storey.  SI (N, m, kg)
wipe
model basic -ndm 2 -ndf 3
pset k1 @k1@
pset cd @cd@
array set m {1 82.0e3 2 82.0e3 3 64.0e3}
array set r {1 1.00 2 0.85 3 0.70}
array set z {0 0.0 1 4.0 2 7.2 3 10.4}
node 0 0.0 $z(0)
fix 0 1 1 1
foreach s {1 2 3} {
    node $s 0.0 $z($s) -mass $m($s) $m($s) 0.0
    fix $s 0 1 1
    set below [expr $s - 1]
    uniaxialMaterial Elastic $s [expr $r($s)*$k1]
    element twoNodeLink $s $below $s -mat $s -dir 2 -doRayleigh
}
uniaxialMaterial ViscousDamper 9 9.0e7 $cd 0.6
element twoNodeLink 9 0 1 -mat 9 -dir 2
rayleigh 0.35 0.0 0.0009 0.0
# shaking
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file acc.txt -timeSeries 1 -time -node 1 2 3 -dof 1 accel
recorder Node -file roof.txt -time -node 3 -dof 1 disp
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
"""


def shear(rng):
    runs = quakes(rng, ("spring", "autumn"), (1.6, 2.1), 14.0, 0.01)
    channels = [Channel("a1", "m/s2", "acc.txt", 1, "floor 1"), Channel("a2", "m/s2", "acc.txt", 2, "floor 2"), Channel("a3", "m/s2", "acc.txt", 3, "floor 3"), Channel("roof", "m", "roof.txt", 1, "floor 3")]
    return "office block with a damper", SHEAR, {"k1": rng.uniform(5.2e7, 6.5e7), "cd": rng.uniform(1.6e5, 2.2e5)}, runs, channels


def case_j(rng):
    """A machine that runs on the second floor while it is recorded: none of the library."""
    def conceal(m):
        machine = "timeSeries Trig 5 0.0 1000.0 0.2941\npattern Plain 5 5 {\n    load 2 9.0e4 0.0 0.0\n}\n"
        return {"cause": "unknown", "script": swapped(m.filled(), "# shaking\n", machine + "# shaking\n"), "where": place(m, "a2", ["a1", "a2", "a3", "roof"], "floor 2")}
    return (*shear(rng), conceal)


# ------------------------------------------------------------------ 10: isolated house of two unequal storeys [kN, cm]

UNEQUAL = """# clinic on isolators: soft ground floor 4.8 m, upper floor 3.2 m; plane model.   kN, cm, s
wipe
model basic -ndm 2 -ndf 3
pset Fy @Fy@
pset Kd @Kd@
pset rI @rI@
set g 981.0
proc floor {n y W} {
    upvar g g
    node $n 0.0 $y -mass [expr $W/$g] [expr $W/$g] 0.0
    fix $n 0 1 1
}
node 1 0.0 0.0
fix 1 1 1 1
floor 2   0.0 2900.0
floor 3 480.0 2500.0
floor 4 800.0 2100.0
# isolation layer: rubber and steel dampers side by side
uniaxialMaterial Elastic   1 $Kd
uniaxialMaterial Steel02 2 $Fy [expr 9.0*$Kd] 0.002 12.0 0.9 0.15
uniaxialMaterial Parallel  3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1
geomTransf Linear 1
# eight columns in one
set I [expr 8*$rI*1.6e5]
element elasticBeamColumn 2 2 3 12800.0 2900.0 $I 1
element elasticBeamColumn 3 3 4 12800.0 2900.0 $I 1
region 1 -ele 2 3 -rayleigh 0.0 0.0 0.004 0.0
timeSeries Path 1 -dt $dt -filePath $motion -factor 100.0
pattern UniformExcitation 1 1 -accel 1
recorder Node -file rows.txt -node 1 2 3 4 -dof 1 disp
recorder Node -file acc.txt -timeSeries 1 -time -node 2 3 4 -dof 1 accel
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 30
algorithm KrylovNewton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
""".replace("algorithm KrylovNewton", "algorithm Newton")
UNTIMED["rows.txt"] = 0.0125


def unequal(rng):
    runs = quakes(rng, ("trial1", "trial2"), (3.6, 4.6), 16.0, 0.0125)
    M = 7500.0 / 981.0
    channels = [Channel("u_base", "cm", "rows.txt", 1, "above the isolators"), Channel("a_base", "cm/s2", "acc.txt", 1, "above the isolators"), Channel("a_first", "cm/s2", "acc.txt", 2, "floor"), Channel("a_roof", "cm/s2", "acc.txt", 3, "roof")]
    return "clinic of two unequal storeys", UNEQUAL, {"Fy": rng.uniform(0.045, 0.055) * 7500.0, "Kd": M * (6.2832 / rng.uniform(2.2, 2.6)) ** 2, "rI": rng.uniform(0.85, 1.2)}, runs, channels


def case_k(rng):
    return (*unequal(rng), lambda m: {"cause": "none", "script": m.filled()})


# ------------------------------------------------------------------ 11: long bridge [MN, m, kt]

LONG = """# Viaduct of four spans, along its axis. Units MN, m, 1000 t
wipe
model basic -ndm 2 -ndf 3
pset Fy @Fy@
pset kd @kd@
pset ka @ka@
set Ec 3.3e4
geomTransf Linear 1
set stations {0.0 42.0 92.0 142.0 184.0}
set masses   {0.32 0.66 0.74 0.66 0.32}
set i 0
foreach x $stations m $masses {
    incr i
    node 20$i $x 0.0
    mass 20$i $m $m 0.0
    fix 20$i 0 1 1
    if {$i > 1} {element elasticBeamColumn 30$i 20[expr $i-1] 20$i 6.2 $Ec 4.0 1}
}
uniaxialMaterial Steel02 1 $Fy [expr 8.0*$kd] 0.125 15.0 0.925 0.15
# piers
foreach p {2 3 4} x {42.0 92.0 142.0} h {11.0 16.0 13.0} {
    node 1$p $x [expr -$h]
    node 10$p $x 0.0 -mass 0.14 0.14 0.0
    fix 10$p 0 1 0
    fix 1$p 1 1 1
    element elasticBeamColumn $p 1$p 10$p 4.6 $Ec 1.9 1
    element zeroLength 40$p 10$p 20$p -mat 1 -dir 1
}
# abutments: rubber strips and backfill as one spring
uniaxialMaterial Elastic 2 $ka 0.6
foreach a {1 5} x {0.0 184.0} {
    node 1$a $x 0.0
    fix 1$a 1 1 1
    element zeroLength 40$a 1$a 20$a -mat 2 -dir 1
}
rayleigh 0.2 0.0 0.0015 0.0
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file piers.out -time -node 102 103 -dof 1 disp
recorder Node -file deck.out -time -node 203 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 103 203 -dof 1 accel
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-9 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at [getTime]"}
}
"""


def long(rng):
    runs = quakes(rng, ("small", "large", "check"), (2.2, 4.6, 4.0), 14.0, 0.0125)
    channels = [Channel("pier2", "m", "piers.out", 1, "top of pier 2"), Channel("pier3", "m", "piers.out", 2, "top of pier 3"), Channel("deck", "m", "deck.out", 1, "deck"),
                Channel("a_pier", "m/s2", "acc.out", 1, "top of pier 3"), Channel("a_deck", "m/s2", "acc.out", 2, "deck")]
    M = 2.7
    return "viaduct of four spans", LONG, {"Fy": rng.uniform(0.055, 0.065) * M * 9.81 / 3, "kd": M * (6.2832 / 2.3) ** 2 / 3 * 0.75, "ka": M * (6.2832 / 2.3) ** 2 * 0.25 / 2}, runs, channels


def case_l(rng):
    def conceal(m):
        text = swapped(m.filled(), "    fix 1$p 1 1 1\n", """    node 5$p $x [expr -$h]
    fix 5$p 1 1 1
    fix 1$p 0 1 0
    mass 1$p 0.25 0.25 3.0
    uniaxialMaterial Elastic 5$p 9000.0 60.0
    uniaxialMaterial Elastic 6$p 3.2e5 800.0
    element zeroLength 5$p 5$p 1$p -mat 5$p 6$p -dir 1 6
""")
        kd = m.parameters["kd"]
        hard = (f"uniaxialMaterial ElasticMultiLinear 7 0.0 -strain -0.6 -0.12 -0.07 0.0 0.07 0.12 0.6 -stress {number(-3.0 * kd * 0.48 - 0.045 * kd)} {number(-0.045 * kd)} 0.0 0.0 0.0 {number(0.045 * kd)} {number(3.0 * kd * 0.48 + 0.045 * kd)}\n"
                "foreach p {2 3 4} {element zeroLength 70$p 10$p 20$p -mat 7 -dir 1}\n")
        text = swapped(text, "# abutments", hard + "# abutments")
        return {"cause": "foundation_flexibility", "also": ["strain_stiffening"], "script": text, "where": place(m, "pier3", ["pier2", "pier3", "deck", "a_pier", "a_deck"], "support")}
    return (*long(rng), conceal)


ALL = (case_e, case_j, case_a, case_l, case_f, case_c, case_h, case_i, case_k, case_g, case_b, case_d)
