# house on an isolation layer, series damson
wipe
model basic -ndm 3 -ndf 6
set Q 245.25
set k 3731.437
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.0 -mass 300.0 300.0 300.0 0.0 0.0 0.0
node 3 0.0 0.0 0.0 -mass 200.0 200.0 200.0 0.0 0.0 0.0
fix 1 1 1 1 1 1 1
fix 2 0 0 1 1 1 1
fix 3 0 0 1 1 1 1
uniaxialMaterial Steel01 1 $Q [expr 12.0*$k] 0.0833333
uniaxialMaterial Elastic 2 2.5e5 700.0
element zeroLength 1 1 2 -mat 1 1 -dir 1 2
element zeroLength 2 2 3 -mat 2 2 -dir 1 2
timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file x.out -timeSeries 1 -time -node 2 3 -dof 1 accel
recorder Node -file disp.out -time -node 2 -dof 1 2 disp
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
