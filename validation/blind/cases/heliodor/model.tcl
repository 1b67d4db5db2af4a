# pad 32, series heliodor
# units: N, m, s
wipe
model basic -ndm 2 -ndf 2
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1
pset ko 7375415
pset Qd 47876.88
pset alpha 0.0227069
set uy [expr $Qd/((1.0-$alpha)*$ko)]
# one spring per direction
uniaxialMaterial BoucWen 1 $alpha $ko 2 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 2 $alpha $ko 2 [expr 0.5/pow($uy,2)] [expr 0.5/pow($uy,2)] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 2
timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
pattern Plain 1 1 {
    sp 2 1 1.0
}
pattern Plain 2 2 {
    sp 2 2 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer Plain
system UmfPack
test NormDispIncr 1e-09 60
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
