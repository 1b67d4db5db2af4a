# Damping rubber pad at three speeds
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3
pset kInit 1400000.0
pset qd 11000.0
pset alpha 0.3
node 1 0.0 0.0
node 2 0.0 0.16
fix 1 1 1 1
fix 2 0 0 1
mass 2 40.0 40.0 1.0
uniaxialMaterial Elastic 1 5.0e8
uniaxialMaterial Elastic 2 1.0e8
element elastomericBearingBoucWen 1 1 2 $kInit $qd $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl 0.25
analysis Static
analyze 4
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
integrator Newmark 0.6 0.3025
analysis Transient
set sub 1
if {[info exists nsub]} {set sub $nsub}
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze $sub [expr $dt/double($sub)]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze $sub [expr $dt/double($sub)]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
