# bearing in the plane, series ironwood
wipe
model basic -ndm 2 -ndf 3
set Q 45
set G 700
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1 1
fix 2 0 0 1
uniaxialMaterial Elastic 1 4.0e5
uniaxialMaterial Elastic 2 1.0e4
element elastomericBearingBoucWen 1 1 2 [expr 12.0*$G] $Q 0.0833333 0.0 2.0 1.0 0.6 0.4 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
set axial 900.0
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
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
recorder Node -file force.out -time -node 2 -dof 1 reaction
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
