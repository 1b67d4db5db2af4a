"""The first six models of batch 4 and the effect concealed in each. Each script names its units."""

import math

from generator import signals
from generator.model import Channel, number
from generator.scripts import place, quakes, run, swapped

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
