# column under cyclic drift, series hornbeam
wipe
model basic -ndm 1 -ndf 1
set a 0.04
set K 15000
node 1 0.0
node 2 0.0
fix 1 1
uniaxialMaterial BoucWen 1 $a $K 1.6 1150.0 1150.0 1.0 0.0 0.012 0.004
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Penalty 1e10 1e10
numberer RCM
system FullGeneral
test NormDispIncr 1e-9 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] != 0} {error "no convergence at [getTime]"}
}
