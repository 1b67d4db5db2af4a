# Three-span bridge, along the road
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 4800000.0
pset Qd 450000.0
pset rE 1.0     ;# pier flexural rigidity / drawing value
geomTransf Linear 1
node 1 0.0 0
mass 1 50000.0 50000.0 2500.0
node 2 0.0 2.8
mass 2 50000.0 50000.0 2500.0
node 3 0.0 5.6
mass 3 50000.0 50000.0 2500.0
node 4 0.0 8.4
mass 4 90000.0 90000.0 4500.0
fix 1 1 1 1
element elasticBeamColumn 1 1 2 2.6 [expr $rE*30000000000.0] 0.42 1
element elasticBeamColumn 2 2 3 2.6 [expr $rE*30000000000.0] 0.42 1
element elasticBeamColumn 3 3 4 2.6 [expr $rE*30000000000.0] 0.42 1
node 11 40.0 0
mass 11 50000.0 50000.0 2500.0
node 12 40.0 2.3
mass 12 50000.0 50000.0 2500.0
node 13 40.0 4.6
mass 13 50000.0 50000.0 2500.0
node 14 40.0 6.9
mass 14 90000.0 90000.0 4500.0
fix 11 1 1 1
element elasticBeamColumn 11 11 12 2.6 [expr $rE*30000000000.0] 0.42 1
element elasticBeamColumn 12 12 13 2.6 [expr $rE*30000000000.0] 0.42 1
element elasticBeamColumn 13 13 14 2.6 [expr $rE*30000000000.0] 0.42 1
# deck
node 20 20.0 9.0
node 24 0.0 8.4
node 34 40.0 6.9
node 30 -30.0 9.0
node 31 -30.0 9.0
fix 20 0 1 1
fix 30 1 1 1
# the deck moves as one along the road
foreach i {24 34 31} {
    fix $i 0 1 1
    equalDOF 20 $i 1
}
mass 20 900000.0 900000.0 1.0
set ki [expr $Kd/0.08]
set uy [expr $Qd/((1.0-0.08)*$ki)]
foreach {tag i j share} {101 4 24 0.3 102 14 34 0.3 103 30 31 0.4} {
    uniaxialMaterial BoucWen $tag 0.08 [expr $share*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
    element zeroLength $tag $i $j -mat $tag -dir 1
}
rayleigh 0.5 0.0 0.003 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 4 20 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 4 20 -dof 1 accel

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
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
