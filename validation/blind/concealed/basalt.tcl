wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.25
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
element HDR 1 1 2 0.45e6 2.0e9 0.15 0.60 0.003 0.006 28 1.1e6 -6.0e6 9.0e7 1.8e4 4.0e5 60.0 4.0 1.5 0.75 3.0 0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0
timeSeries Linear 9
pattern Plain 9 9 {
    load 2 0.0 0.0 -1.0e6 0.0 0.0 0.0
}
constraints Transformation
numberer RCM
system FullGeneral
test NormUnbalance 1e-6 60
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Transformation
numberer RCM
system FullGeneral
test NormUnbalance 1e-6 100
algorithm Newton
integrator LoadControl $dt
analysis Static
analyze [expr $npts-1]
