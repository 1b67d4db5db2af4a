# bridge of three spans on isolators, series kyanite
wipe
model basic -ndm 2 -ndf 3
set Qd 176.58
set kd 2447.021
set rE 1.052831
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
node 21 25.0 -9.0
node 22 55.0 -9.0
fix 21 1 1 1
fix 22 1 1 1
mass 1 80.0 80.0 150.0
mass 2 80.0 80.0 150.0
fix 10 1 1 1
fix 15 1 1 1
geomTransf Linear 1
set E [expr $rE*3.2e7]
element elasticBeamColumn 1 1 3 2.5 $E 0.30 1
element elasticBeamColumn 2 2 4 2.5 $E 0.30 1
element elasticBeamColumn 3 11 12 5.0 3.2e7 2.0 1
element elasticBeamColumn 4 12 13 5.0 3.2e7 2.0 1
element elasticBeamColumn 5 13 14 5.0 3.2e7 2.0 1
uniaxialMaterial PySimple1 31 2 9000.0 0.006 0.0 300.0
uniaxialMaterial Elastic 32 4.0e6
uniaxialMaterial Elastic 33 1.2e7 6.0e4
element zeroLength 31 21 1 -mat 31 32 33 -dir 1 2 3
element zeroLength 32 22 2 -mat 31 32 33 -dir 1 2 3
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
constraints Plain
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
