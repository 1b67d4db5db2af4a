# Machine hall slab on four bearings
# units: kN, m, t, s
wipe
model basic -ndm 3 -ndf 6
pset Kd 500.0
pset Qd 45.0
node 100 0.0 0.0 0.0
mass 100 380.0 380.0 0.0 0.0 0.0 14000.0
fix 100 0 0 1 1 1 0
set ki [expr $Kd/0.1]
set uy [expr $Qd/(0.9*$ki)]
uniaxialMaterial BoucWen 1 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
node 1 -9.0 -6.0 0.0
node 11 -9.0 -6.0 0.0
fix 1 1 1 1 1 1 1
fix 11 0 0 1 1 1 0
element zeroLength 1 1 11 -mat 1 1 -dir 1 2
node 2 9.0 -6.0 0.0
node 12 9.0 -6.0 0.0
fix 2 1 1 1 1 1 1
fix 12 0 0 1 1 1 0
element zeroLength 2 2 12 -mat 1 1 -dir 1 2
node 3 9.0 6.0 0.0
node 13 9.0 6.0 0.0
fix 3 1 1 1 1 1 1
fix 13 0 0 1 1 1 0
element zeroLength 3 3 13 -mat 1 1 -dir 1 2
node 4 -9.0 6.0 0.0
node 14 -9.0 6.0 0.0
fix 4 1 1 1 1 1 1
fix 14 0 0 1 1 1 0
element zeroLength 4 4 14 -mat 1 1 -dir 1 2
rigidDiaphragm 3 100 11 12 13 14
timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file dispx.out -time -node 11 14 -dof 1 disp
recorder Node -file dispy.out -time -node 11 12 -dof 2 disp
recorder Node -file accx.out -timeSeries 1 -time -node 11 14 -dof 1 accel
recorder Node -file accy.out -timeSeries 2 -time -node 11 12 -dof 2 accel
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 40
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
