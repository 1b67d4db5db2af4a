"""The other six models of batch 4 and the effect concealed in each. Each script names its units."""

from generator import signals
from generator.model import Channel, number
from generator.scripts import place, quakes, swapped

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
