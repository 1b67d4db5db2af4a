# Platform on four isolators, plan
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 380000.0
pset Qd 38000.0
node 100 0.35 -0.2
mass 100 320000.0 320000.0 9200000.0
set ki [expr $Kd/0.1]
set uy [expr $Qd/((1.0-0.1)*$ki)]
uniaxialMaterial BoucWen 1 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
node 1 -7 -4.5
node 11 -7 -4.5
fix 1 1 1 1
rigidLink beam 100 11
element zeroLength 1 1 11 -mat 1 1 -dir 1 2
node 2 7 -4.5
node 12 7 -4.5
fix 2 1 1 1
rigidLink beam 100 12
element zeroLength 2 2 12 -mat 1 1 -dir 1 2
node 3 7 4.5
node 13 7 4.5
fix 3 1 1 1
rigidLink beam 100 13
element zeroLength 3 3 13 -mat 1 1 -dir 1 2
node 4 -7 4.5
node 14 -7 4.5
fix 4 1 1 1
rigidLink beam 100 14
element zeroLength 4 4 14 -mat 1 1 -dir 1 2

timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file sw.out -time -node 11 -dof 1 2 disp
recorder Node -file se.out -time -node 12 -dof 2 disp
recorder Node -file accx.out -timeSeries 1 -time -node 100 -dof 1 accel
recorder Node -file accy.out -timeSeries 2 -time -node 100 -dof 2 accel

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
