# pad 17, cyclic shear
# units: N, m, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
set ko 5000000
set Qd 55000
set alpha 0.08
set uy [expr $Qd/((1.0-$alpha)*$ko)]
uniaxialMaterial KikuchiAikenHDR 1 X0.6 0.16 0.16
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
