# Lead-rubber bearing LR-6 between plates, orbits in plan
# units: N, m, s
wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.30
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1

pset kInit 6.0e6
pset Qd    50000.0
pset rp    0.12

uniaxialMaterial Elastic 1 9.0e8
uniaxialMaterial Elastic 2 1.0e7
uniaxialMaterial Elastic 3 1.0e7
element elastomericBearingPlasticity 1 1 2 $kInit $Qd $rp 0.0 2.0 -P 1 -T 2 -My 3 -Mz 3 -orient 0 0 1 1 0 0

timeSeries Path 1 -dt $dt -filePath $motionx
timeSeries Path 2 -dt $dt -filePath $motiony
timeSeries Constant 3
pattern Plain 1 1 {
    sp 2 1 1.0
}
pattern Plain 2 2 {
    sp 2 2 1.0
}
pattern Plain 3 3 {
    load 2 0.0 0.0 -600000.0 0.0 0.0 0.0
}
recorder Element -file force.out -time -ele 1 force

constraints Transformation
numberer Plain
system BandGeneral
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
