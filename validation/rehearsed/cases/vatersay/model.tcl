# Isolated machine platform on four bearings, both directions
# units: kN, m, t, s
wipe
model basic -ndm 2 -ndf 3
pset E0 8000.0
pset Fy 40.0
pset b 0.12
node 100 0.0 0.0
mass 100 480.0 480.0 9800.0
uniaxialMaterial Steel01 1 $Fy $E0 $b
foreach {i x y} {1 -6 -4 2 6 -4 3 6 4 4 -6 4} {
    node $i $x $y
    node 1$i $x $y
    fix $i 1 1 1
    rigidLink beam 100 1$i
    element zeroLength $i $i 1$i -mat 1 1 -dir 1 2
}
timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file disp.out -time -node 100 -dof 1 2 disp
recorder Node -file accx.out -timeSeries 1 -time -node 100 -dof 1 accel
recorder Node -file accy.out -timeSeries 2 -time -node 100 -dof 2 accel
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 50
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
