# Springs between a pile and soil: to and fro, and a short pile that is shaken through them.
model basic -ndm 1 -ndf 1
uniaxialMaterial PySimple1 1 1 50. 0.01 0.3
uniaxialMaterial PySimple1 2 2 50. 0.02 0.1 20.
uniaxialMaterial TzSimple1 3 1 50. 0.01
uniaxialMaterial TzSimple1 4 2 50. 0.01
uniaxialMaterial QzSimple1 5 1 50. 0.01 0.05
uniaxialMaterial QzSimple1 6 2 50. 0.01
set path {}
set at 0.
foreach {to steps} {0.004 8 -0.003 10 0.015 12 -0.012 20 0.02 15 0.012 8 0.03 20 -0.04 50 0.05 40 0. 30 -0.03 20} {
    for {set i 1} {$i <= $steps} {incr i} {lappend path [expr {$at + ($to-$at)*$i/$steps}]}
    set at $to
}
timeSeries Path 1 -dt 1 -values "0 $path"
node 1 0.; fix 1 1
# so that something is free
node 9 0.; uniaxialMaterial Elastic 9 1.; element zeroLength 9 1 9 -mat 9 -dir 1
foreach i {1 2 3 4 5 6} {
    node 1$i 0.
    element zeroLength $i 1 1$i -mat $i -dir 1
    pattern Plain $i 1 "sp 1$i 1 1.0"
    recorder Element -file spring$i.out -time -ele $i material 1 stressStrain
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-12 20
algorithm Newton
integrator LoadControl 1
analysis Static
analyze [llength $path]
remove recorders
wipe
model basic -ndm 2 -ndf 3
uniaxialMaterial PySimple1 1 1 40. 0.01 0.3 30.
uniaxialMaterial PySimple1 2 2 60. 0.008 0.1
uniaxialMaterial TzSimple1 3 1 25. 0.006 20.
uniaxialMaterial QzSimple1 4 2 300. 0.02 0.02
node 1 0. 0.; node 2 0. 2.; node 3 0. 4.; node 4 0. 6. -mass 10. 10. 1.
geomTransf PDelta 1
foreach i {1 2 3} {
    node 10$i 0. [expr {2.*($i-1)}]; fix 10$i 1 1 1
    element elasticBeamColumn $i $i [expr {$i+1}] 0.3 3.e7 0.007 1
}
element zeroLength 11 101 1 -mat 2 4 -dir 1 2
element zeroLength 12 102 2 -mat 2 3 -dir 1 2
element zeroLength 13 103 3 -mat 1 3 -dir 1 2
pattern Plain 1 Linear {load 4 0. -98.1 0.}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 60
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
recorder Node -file disp.out -time -node 1 3 4 -dof 1 2 disp
recorder Element -file foot.out -time -ele 11 force
timeSeries Trig 2 0.0 10.0 0.7 -factor 2.5
pattern UniformExcitation 9 1 -accel 2
rayleigh 0.1 0. 0.001 0.
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
puts "done [analyze 800 0.01]"
