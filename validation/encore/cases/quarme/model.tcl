# Deck on four isolators, two components
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 520000.0
pset Qd 45000.0
node 100 0.0 0.0
mass 100 420000.0 420000.0 12500000.0
set ki [expr $Kd/0.1]
set uy [expr $Qd/((1.0-0.1)*$ki)]
node 1 -8.0 -5.0
node 11 -8.0 -5.0
fix 1 1 1 1
rigidLink beam 100 11
uniaxialMaterial BoucWen 11 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 12 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
element zeroLength 1 1 11 -mat 11 12 -dir 1 2
node 2 8.0 -5.0
node 12 8.0 -5.0
fix 2 1 1 1
rigidLink beam 100 12
uniaxialMaterial BoucWen 21 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 22 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
element zeroLength 2 2 12 -mat 21 22 -dir 1 2
node 3 8.0 5.0
node 13 8.0 5.0
fix 3 1 1 1
rigidLink beam 100 13
uniaxialMaterial BoucWen 31 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 32 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
element zeroLength 3 3 13 -mat 31 32 -dir 1 2
node 4 -8.0 5.0
node 14 -8.0 5.0
fix 4 1 1 1
rigidLink beam 100 14
uniaxialMaterial BoucWen 41 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 42 0.1 $ki 2.0 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
element zeroLength 4 4 14 -mat 41 42 -dir 1 2
timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 2
recorder Node -file xdisp.out -time -node 11 14 -dof 1 disp
recorder Node -file ydisp.out -time -node 11 12 -dof 2 disp
recorder Node -file xacc.out -timeSeries 1 -time -node 11 14 -dof 1 accel
recorder Node -file yacc.out -timeSeries 2 -time -node 11 12 -dof 2 accel
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
