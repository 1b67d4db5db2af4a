# curved slider, type test, series ibis
# curved slider, type test, quasi-static        units: kN, mm
wipe
model BasicBuilder -ndm 2 -ndf 3
set mu 0.07176807
set R  2166.803
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
timeSeries Trig 4 0.0 1000.0 9.090909
pattern Plain 4 4 {
    load 2 0.0 [expr -0.22*$W] 0.0
}
timeSeries Path 3 -dt $dt -filePath $motion
pattern Plain 3 3 {
    sp 2 1 1.0
}
recorder Node -file actuator.out -time -node 1 -dof 1 2 reaction
solver $dt
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] < 0} {error "at [getTime]"}
}
