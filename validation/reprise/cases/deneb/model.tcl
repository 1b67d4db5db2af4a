# Bearing 4, reversed shear
# units: N, m, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset ko    4000000.0
pset Qd    50000.0
pset alpha 0.18

set uy [expr $Qd/((1.0-$alpha)*$ko)]
uniaxialMaterial BoucWen 1 $alpha $ko 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-10 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
