# slab on four pendulums, series juniper
wipe
model basic -ndm 3 -ndf 6
set mu 0.05982812
set R 1.423783
foreach {i x y} {1 0.0 0.0 2 6.0 0.0 3 6.0 6.0 4 0.0 6.0} {
    node $i $x $y 0.0
    node 1$i $x $y 0.0
    fix $i 1 1 1 1 1 1
    fix 1$i 0 0 0 1 1 0
}
frictionModel Coulomb 1 $mu
uniaxialMaterial Elastic 1 1.0e6
uniaxialMaterial Elastic 2 1.0e3
foreach i {1 2 3 4} {
    element singleFPBearing $i $i 1$i 1 $R 2.5e4 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
}
node 20 3.0 3.0 0.0
mass 20 160.0 160.0 0.0 1.0 1.0 1900.0
fix 20 0 0 1 1 1 0
rigidDiaphragm 3 20 11 12 13 14
foreach i {11 12 13 14} {mass $i 0.0 0.0 40.0 0.0 0.0 0.0}
uniaxialMaterial ImpactMaterial 9 3.0e4 1.2e4 -0.004 -0.032
node 50 3.0 3.0 0.0
fix 50 1 1 1 1 1 1
element zeroLength 50 50 20 -mat 9 -dir 1
timeSeries Linear 1
pattern Plain 1 1 {
    foreach i {11 12 13 14} {load $i 0.0 0.0 -392.4 0.0 0.0 0.0}
}
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-10 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
timeSeries Path 3 -dt $dt -filePath $second
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
recorder Node -file acc.out -timeSeries 2 -time -node 20 -dof 1 accel
recorder Node -file disp.out -time -node 20 -dof 1 2 disp
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 4 [expr $dt/4.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 4 [expr $dt/4.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
