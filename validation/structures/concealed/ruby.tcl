# tank on a lead rubber bearing, series ruby
wipe
model basic -ndm 3 -ndf 6
set Fy 110
set G 450
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 200.0 200.0 200.0 0.0 0.0 0.0
element LeadRubberX 1 1 2 $Fy 0.08 $G 2.0e6 0.12 0.70 0.003 0.008 25 0 0 1 1 0 0 10.0 0.75 1.0 0.5 0.0 5.0 0.005 11.2 130. 0.05 1.41e-5 0 0 0 0 1
set axial 1962.0
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
timeSeries Path 3 -dt $dt -filePath $second
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
recorder Node -file disp.out -time -node 2 -dof 1 2 disp
recorder Element -file force.out -time -ele 1 force
constraints Plain
numberer RCM
system FullGeneral
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 2 [expr $dt/2.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 2 [expr $dt/2.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
