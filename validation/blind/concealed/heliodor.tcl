wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.0
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
uniaxialMaterial Elastic 1 7.395393e+09
uniaxialMaterial Elastic 2 7.395393e+07
element elastomericBearingBoucWen 1 1 2 7395393 44868.1 0.02707408 0.0 2.0 2.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
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
