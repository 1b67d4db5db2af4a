# Bearing LR-4, two-directional shear
# units: kN, mm, s
wipe
model basic -ndm 3 -ndf 6
pset kInit  8.0
pset qd     40.0
pset alpha1 0.1
node 1 0.0 0.0 0.0
node 2 0.0 0.0 180.0
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 0.00005 0.00005 0.00005 1.0 1.0 1.0
uniaxialMaterial Elastic 1 900.0
uniaxialMaterial Elastic 2 1.0e7
uniaxialMaterial Elastic 3 1.0e7
element elastomericBearingPlasticity 1 1 2 $kInit $qd $alpha1 0.0 2.0 -P 1 -T 2 -My 3 -Mz 3 -orient 0 0 1 1 0 0

timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
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
recorder Node -file disp.out -time -node 2 -dof 1 2 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-8 50
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
