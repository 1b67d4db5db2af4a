# low damping rubber bearing, pulled, series lazurite
wipe
model basic -ndm 3 -ndf 6
set G 500
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.25
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
element ElastomericX 1 1 2 60.0 0.10 $G 2.0e6 0.10 0.55 0.003 0.007 22 0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0 0.0 1 0 0 0
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 3 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer RCM
system FullGeneral
test NormDispIncr 1e-9 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] != 0} {error "no convergence at [getTime]"}
}
