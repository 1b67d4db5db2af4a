# bridge of three spans on isolators, series xenotime
wipe
model basic -ndm 2 -ndf 3
set Qd 176.58
set kd 2447.021
set rE 0.9590178
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
timeSeries Path 2 -dt $dt -filePath $motion -startTime 0.16
pattern MultipleSupport 1 {
    groundMotion 1 Plain -accel 1
    groundMotion 2 Plain -accel 2
    imposedMotion 1 1 1
    imposedMotion 10 1 1
    imposedMotion 2 1 2
    imposedMotion 15 1 2
}
recorder Node -file acc.out -time -node 3 12 -dof 1 accel
recorder Node -file total.out -time -node 1 3 12 -dof 1 disp
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 2 [expr $dt/2.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 2 [expr $dt/2.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}

remove recorders
set in [open total.out r]
set out [open disp.out w]
foreach {t g p d} [read $in] {puts $out "$t [expr $p-$g] [expr $d-$g]"}
close $in
close $out
