# Fluid damper in the rig
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
mass 2 0.01
fix 1 1
pset C 18.0
pset a 0.6
pset K 40.0
uniaxialMaterial ViscousDamper 1 $K $C $a
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force

constraints Penalty 1.0e8 1.0e8
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1 $dt]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1 $dt]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
