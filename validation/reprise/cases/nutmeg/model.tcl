# Beam-column joint, moment against rotation
# units: kN, m, rad, s
wipe
model basic -ndm 2 -ndf 3
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1 1
fix 2 1 1 0

pset K0 10000.0
pset My 90.0
pset al 0.05

set ty [expr $My/((1.0-$al)*$K0)]
uniaxialMaterial BoucWen 1 $al $K0 1.0 [expr 0.5/$ty] [expr 0.5/$ty] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 6

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 3 1.0
}
recorder Element -file moment.out -time -ele 1 force
recorder Node -file rotation.out -time -node 2 -dof 3 disp

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-9 50
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
