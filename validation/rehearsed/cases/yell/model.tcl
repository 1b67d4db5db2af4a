# Square pad under constant vertical load
# units: kN, mm, s
wipe
model basic -ndm 2 -ndf 3
pset kInit 2.2
pset qd 13.0
pset alpha 0.2
set H 180.0
node 1 0.0 0.0
node 2 0.0 $H
fix 1 1 1 1
fix 2 0 0 1
uniaxialMaterial Elastic 1 900.0
uniaxialMaterial Elastic 2 1.0e7
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha 0.0 2.0 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
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
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
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
