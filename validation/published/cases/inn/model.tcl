# Damper D
# units: N, m, s
wipe
model basic -ndm 2 -ndf 2
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1
fix 2 0 1

pset E  2.0e6
pset Fy 2.0e4
pset b  0.03

uniaxialMaterial Steel01 1 $Fy $E $b

element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Penalty 1.0e12 1.0e12
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
