# rubber bearing under two weights, series malachite
wipe
model basic -ndm 3 -ndf 6
set Fy 55
set G 480
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.35
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
element ElastomericX 1 1 2 $Fy 0.10 $G 2.0e6 0.10 0.55 0.003 0.009 28 0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0 0.0 0 0 1 0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 0.0 [expr -$axial] 0.0 0.0 0.0
}
constraints Transformation
numberer RCM
system FullGeneral
test NormDispIncr 1e-10 40
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
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
