# Energy dissipating strut with a compression buffer
# units: N, mm, s
wipe
model basic -ndm 2 -ndf 2
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1

pset Fy 9000.0
pset E0 1800.0
pset b 0.04
pset kb 400.0

uniaxialMaterial Steel01 1 $Fy $E0 $b
uniaxialMaterial ENT 2 $kb

element zeroLength 1 1 2 -mat 1 2 -dir 1 1
# vertical guide of the rig
uniaxialMaterial Elastic 99 1.0e6
element zeroLength 99 1 2 -mat 99 -dir 2

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

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
