# Bearing under two-way motion
# units: kN, m, s
wipe
model basic -ndm 3 -ndf 6
pset kInit 7000.0
pset qd 70.0
pset alpha 0.13
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.25
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 1.0e5
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha 0.0 2.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl 0.5
analysis Static
analyze 2
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motionx
timeSeries Path 3 -dt $dt -filePath $motiony
pattern Plain 2 2 {
    sp 2 1 1.0
}
pattern Plain 3 3 {
    sp 2 2 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
