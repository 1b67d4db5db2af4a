# Joint2D: a beam-column subassembly pushed in cycles, with springs at the four nodes of one joint and a rigid second one, then
# shaken; modes. Units: kN, m, s.
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 0. 2.7
node 3 0.25 3.
node 4 0. 3.3
node 5 -0.25 3.
node 6 5.75 3.
node 7 6. 2.7
node 8 6.25 3.
node 9 6. 3.3
node 10 6. 0.
node 11 0. 5.
fix 1 1 1 1
fix 10 1 1 0
geomTransf Linear 1
geomTransf PDelta 2
uniaxialMaterial Hysteretic 1 120. 0.003 160. 0.03 100. 0.08 -100. -0.003 -140. -0.03 -90. -0.08 0.7 0.3 0.01 0.01 0.2
uniaxialMaterial Steel01 2 150. 60000. 0.02
uniaxialMaterial Elastic 3 2e5
uniaxialMaterial Steel02 4 180. 80000. 0.01 18. 0.925 0.15
element elasticBeamColumn 1 1 2 0.16 2.5e7 2.1e-3 2
element elasticBeamColumn 2 3 6 0.15 2.5e7 3.1e-3 1
element elasticBeamColumn 3 10 7 0.16 2.5e7 2.1e-3 2
element elasticBeamColumn 4 4 11 0.16 2.5e7 2.1e-3 2
element Joint2D 5 2 3 4 5 100 2 1 2 0 4 0
element Joint2D 6 7 8 9 6 101 1 0
mass 4 20. 20. 0.
mass 9 20. 20. 0.
mass 11 5. 5. 0.
recorder Node -file disp.out -time -node 2 3 4 5 6 11 -dof 1 2 3 disp
recorder Node -file centre.out -time -node 100 101 -dof 1 2 3 4 disp
recorder Element -file moment.out -ele 5 6 moment
recorder Element -file deformation.out -ele 5 6 deformation
recorder Element -file plastic.out -ele 5 6 plasticRotation
recorder Element -file size.out -ele 5 6 size
recorder Element -file panel.out -ele 5 spring 5 stressStrain
recorder Element -file force.out -ele 5 force
recorder Element -file beam.out -ele 2 3 localForce
pattern Plain 1 Linear { load 4 0. -300. 0.; load 9 0. -300. 0.; load 8 0. -20. 0. }
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 50
algorithm Newton
integrator LoadControl 0.5
analysis Static
analyze 2
loadConst -time 0.
puts "modes [eigen 3]"
pattern Plain 2 Linear { load 11 1. 0. 0. }
foreach {step count} {0.001 40 -0.001 80 0.002 60} {
    integrator DisplacementControl 11 1 $step
    puts "[analyze $count]"
}
loadConst -time 0.
set motion {}
for {set i 0} {$i < 300} {incr i} { lappend motion [expr 5. * sin(0.11 * $i) * exp(-0.01 * $i)] }
timeSeries Path 3 -dt 0.02 -values $motion
pattern UniformExcitation 3 1 -accel 3
rayleigh 0.3 0. 0.002 0.
wipeAnalysis
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
puts "[analyze 300 0.02]"
wipe
