# steel hall with a stiff roof, series maple
wipe
model basic -ndm 3 -ndf 6
set rE 1.09586
set aM 0.4753516
set E [expr $rE*2.0e8]
foreach {i x y} {1 0.0 0.0 2 8.0 0.0 3 8.0 6.0 4 0.0 6.0} {
    node $i $x $y 0.0
    node 1$i $x $y 4.0
    fix $i 1 1 1 1 1 1
}
node 20 4.0 3.0 4.0
mass 20 60.0 60.0 60.0 1.0 1.0 500.0
geomTransf Linear 1 0.0 1.0 0.0
geomTransf Linear 2 0.0 0.0 1.0
foreach i {1 2 3 4} {
    element elasticBeamColumn $i $i 1$i 0.0078 $E 7.7e7 8.0e-7 5.7e-5 8.0e-5 1
}
foreach {e i j} {11 11 12 12 12 13 13 13 14 14 14 11} {
    element elasticBeamColumn $e $i $j 0.010 $E 7.7e7 1.0e-6 2.0e-4 2.0e-5 2
}
rigidDiaphragm 3 20 11 12 13 14
fix 20 0 0 1 1 1 0
rayleigh $aM 0.0 0.0 0.001
timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 11 13 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 11 13 -dof 2 accel
recorder Node -file disp.out -time -node 11 -dof 1 2 disp
constraints Transformation
numberer RCM
system UmfPack
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
