# high damping rubber bearing, series unakite
wipe
model basic -ndm 3 -ndf 6
set Qd 70
set G 900
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 1.0e3
element elastomericBearingPlasticity 1 1 2 [expr 12.0*$G] $Qd 0.0833333 0.25 3.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
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
