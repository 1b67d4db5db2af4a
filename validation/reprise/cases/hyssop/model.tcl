# Steel column C4 on its base plate, top displacement imposed
# units: kN, m, s
wipe
model basic -ndm 2 -ndf 3
set L 3.2
pset rEI 1.0      ;# flexural rigidity / drawing value
pset kth 30000.0  ;# base plate, rotation
pset My  70.0

node 1 0.0 0.0
node 2 0.0 0.0
node 3 0.0 [expr 0.5*$L]
node 4 0.0 $L
fix 1 1 1 1
equalDOF 1 2 1 2

uniaxialMaterial Steel01 1 $My $kth 0.06
element zeroLength 1 1 2 -mat 1 -dir 6
geomTransf Linear 1
element elasticBeamColumn 2 2 3 0.01 2.0e8 [expr $rEI*24000.0/2.0e8] 1
element elasticBeamColumn 3 3 4 0.01 2.0e8 [expr $rEI*24000.0/2.0e8] 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 4 1 1.0
}
recorder Element -file column.out -time -ele 3 force
recorder Node -file disp.out -time -node 3 4 -dof 1 disp

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
