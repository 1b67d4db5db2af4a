# pad 38, cyclic shear
# units: N, m, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
set ko 1.867202e+07
set Qd 65163.65
set alpha 0.1017821
set uy [expr $Qd/((1.0-$alpha)*$ko)]
uniaxialMaterial Pinching4 1 39618.81 0.002331223 66031.34 0.005050982 116029.5 0.02653652 166027.7 0.06272268 0.45 0.25 0.02 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 10.0 energy
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
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
