# two storeys on four isolators, series wulfenite
wipe
model basic -ndm 3 -ndf 6
set Qd 42.91875
set kd 599.7183
set rE 1.11349
# isolators at the corners of the slab, on a rigid base
foreach {i x y} {1 0.0 0.0 2 12.0 0.0 3 12.0 8.0 4 0.0 8.0} {
    node $i $x $y 0.0
    fix $i 1 1 1 1 1 1
    node 1$i $x $y 0.3
}
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 1.0e3
foreach i {1 2 3 4} {
    element elastomericBearingBoucWen $i $i 1$i [expr 10.0*$kd] $Qd 0.1 0.0 2.0 1.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
}
node 20 6.0 4.0 0.3
node 30 6.0 4.0 3.8
node 40 6.0 4.0 7.3
mass 20 130.0 130.0 130.0 1.0 1.0 2300.0
mass 30 120.0 120.0 120.0 1.0 1.0 2100.0
mass 40 100.0 100.0 100.0 1.0 1.0 1750.0
rigidDiaphragm 3 20 11 12 13 14
fix 20 0 0 1 1 1 0
foreach i {11 12 13 14} {fix $i 0 0 1 1 1 0}
geomTransf Linear 1 1 0 0
set E [expr $rE*3.0e7]
element elasticBeamColumn 50 20 30 1.2 $E 1.25e7 0.3 0.045 0.06 1
element elasticBeamColumn 51 30 40 1.2 $E 1.25e7 0.3 0.045 0.06 1
rayleigh 0.12 0.0 0.0 0.0015

timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 11 40 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 11 12 40 -dof 2 accel
recorder Node -file disp.out -time -node 11 -dof 1 2 disp
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
