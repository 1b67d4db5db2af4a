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

# beamColumnJoint: the same kind of subassembly with bar slip, interface shear and a pinching panel, in the plane and turned in space.
proc lawsOfJoint {} {
    uniaxialMaterial Steel02 1 400. 400000. 0.02 18. 0.925 0.15
    uniaxialMaterial Hysteretic 2 300. 0.001 400. 0.01 420. 0.04 -300. -0.001 -400. -0.01 -420. -0.04 0.6 0.3 0.01 0.01 0.2
    uniaxialMaterial Elastic 3 1e8
    uniaxialMaterial Pinching4 4 80. 0.001 110. 0.004 120. 0.015 30. 0.05 -80. -0.001 -110. -0.004 -120. -0.015 -30. -0.05 0.3 0.3 0.1 0.3 0.3 0.1 0. 0.1 0.1 0.2 0.3 0. 0. 0. 0. 0. 0. 0. 0. 0. 0. 10. energy
}
proc cyclesOfJoint {node} {
    constraints Plain
    numberer RCM
    system UmfPack
    test NormDispIncr 1e-10 100
    algorithm Newton
    integrator LoadControl 0.5
    analysis Static
    analyze 2
    loadConst -time 0.
    pattern Plain 2 Linear [list load $node {*}[lrange {1. 0. 0. 0. 0. 0.} 0 [expr {[llength [nodeDisp $node]] - 1}]]]
    foreach {step count} {0.001 30 -0.001 70 0.001 100 -0.001 60} {
        integrator DisplacementControl $node 1 $step
        puts "[analyze $count]"
    }
}
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 0. 2.7
node 3 0.25 3.
node 4 0. 3.3
node 5 -0.25 3.
node 6 4. 3.
node 7 -4. 3.
node 8 0. 5.
fix 1 1 1 0
fix 6 0 1 0
fix 7 0 1 0
geomTransf Linear 1
geomTransf PDelta 2
lawsOfJoint
element elasticBeamColumn 1 1 2 0.16 2.5e7 2.1e-3 2
element elasticBeamColumn 2 3 6 0.15 2.5e7 3.1e-3 1
element elasticBeamColumn 3 7 5 0.15 2.5e7 3.1e-3 1
element elasticBeamColumn 4 4 8 0.16 2.5e7 2.1e-3 2
element beamColumnJoint 5 2 3 4 5 1 1 3 2 2 3 1 1 3 2 2 3 4 0.8 0.9
recorder Node -file joint_plane_disp.out -precision 10 -time -node 2 3 4 5 8 -dof 1 2 3 disp
recorder Element -file joint_plane_beams.out -precision 10 -ele 1 2 3 4 globalForce
recorder Element -file joint_plane_panel.out -precision 10 -ele 5 shearpanel stressStrain
recorder Element -file joint_plane_slip.out -precision 10 -ele 5 node2BarSlipT stressStrain
recorder Element -file joint_plane_edges.out -precision 10 -ele 5 internalDisplacement
recorder Element -file joint_plane_parts.out -precision 10 -ele 5 deformation
recorder Element -file joint_plane_nodes.out -precision 10 -ele 5 externalDisplacement
pattern Plain 1 Linear { load 8 0. -150. 0.; load 4 0. -150. 0. }
cyclesOfJoint 8
wipe
model basic -ndm 3 -ndf 6
set s [expr sqrt(0.5)]
node 1 0. 0. 0.
node 2 0. 0. 2.7
node 3 [expr 0.25 * $s] [expr 0.25 * $s] 3.
node 4 0. 0. 3.3
node 5 [expr -0.25 * $s] [expr -0.25 * $s] 3.
node 6 [expr 4. * $s] [expr 4. * $s] 3.
node 7 [expr -4. * $s] [expr -4. * $s] 3.
node 8 0. 0. 5.
fix 1 1 1 1 1 1 1
fix 6 0 0 1 1 0 0
fix 7 0 0 1 1 0 0
geomTransf Linear 1 0 0 1
geomTransf PDelta 2 1 1 0
lawsOfJoint
element elasticBeamColumn 1 1 2 0.16 2.5e7 1e7 4e-3 2.1e-3 2.2e-3 2
element elasticBeamColumn 2 3 6 0.15 2.5e7 1e7 4e-3 3.1e-3 3.3e-3 1
element elasticBeamColumn 3 7 5 0.15 2.5e7 1e7 4e-3 3.1e-3 3.3e-3 1
element elasticBeamColumn 4 4 8 0.16 2.5e7 1e7 4e-3 2.1e-3 2.2e-3 2
element beamColumnJoint 5 2 3 4 5 1 1 3 2 2 3 1 1 3 2 2 3 4
# The joint has no stiffness across its plane: the opposite nodes move together there.
uniaxialMaterial Elastic 9 1e6
foreach {tag i j} {11 2 3 12 3 4 13 4 5 14 5 2} { element twoNodeLink $tag $i $j -mat 9 9 9 -dir 1 5 6 -orient [expr -$s] $s 0. 0. 0. 1. }
recorder Node -file joint_space_disp.out -precision 10 -time -node 2 3 4 5 8 -dof 1 2 3 4 5 6 disp
recorder Element -file joint_space_panel.out -precision 10 -ele 5 shearPanel stressStrain
recorder Element -file joint_space_slip.out -precision 10 -ele 5 node1BarSlipL stressStrain
recorder Element -file joint_space_edges.out -precision 10 -ele 5 internalDisplacement
pattern Plain 1 Linear { load 8 0. 0. -150. 0. 0. 0.; load 4 0. 0. -150. 0. 0. 0. }
cyclesOfJoint 8
wipe

# ElasticTubularJoint between a chord and a brace.
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 4. 0.
node 3 8. 0.
node 4 4.1 0.3
node 5 6. 3.6
fix 1 1 1 1
fix 3 1 1 0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 0.05 2e8 2e-3 1
element elasticBeamColumn 2 2 3 0.05 2e8 2e-3 1
element elasticBeamColumn 3 4 5 0.02 2e8 4e-4 1
element ElasticTubularJoint 4 2 4 0.3 60. 2e8 0.6 0.02 10.
recorder Node -file tubular_disp.out -precision 10 -time -node 2 4 5 -dof 1 2 3 disp
recorder Element -file tubular_force.out -precision 10 -ele 1 3 globalForce
pattern Plain 1 Linear { load 5 30. -20. 5. }
constraints Plain
numberer RCM
system UmfPack
algorithm Linear
integrator LoadControl 0.5
analysis Static
puts "[analyze 4]"
wipe

# Modes and shaking of a joint with beamColumnJoint.
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 0. 2.7
node 3 0.25 3.
node 4 0. 3.3
node 5 -0.25 3.
node 6 4. 3.
node 7 -4. 3.
node 8 0. 5.
fix 1 1 1 0
fix 6 0 1 0
fix 7 0 1 0
mass 8 10. 10. 0.
mass 4 30. 30. 0.5
geomTransf Linear 1
lawsOfJoint
element elasticBeamColumn 1 1 2 0.16 2.5e7 2.1e-3 1
element elasticBeamColumn 2 3 6 0.15 2.5e7 3.1e-3 1
element elasticBeamColumn 3 7 5 0.15 2.5e7 3.1e-3 1
element elasticBeamColumn 4 4 8 0.16 2.5e7 2.1e-3 1
element beamColumnJoint 5 2 3 4 5 1 1 3 2 2 3 1 1 3 2 2 3 4
set file [open joint_modes.out w]
puts $file [eigen 3]
close $file
rayleigh 0.4 0. 0.003 0.
recorder Node -file joint_shaken.out -precision 10 -time -node 3 4 8 -dof 1 2 3 disp
set motion {}
for {set i 0} {$i < 200} {incr i} { lappend motion [expr 12. * sin(0.2 * $i) * exp(-0.01 * $i)] }
timeSeries Path 3 -dt 0.02 -values $motion
pattern UniformExcitation 3 1 -accel 3
constraints Plain
numberer RCM
system UmfPack
algorithm Linear
integrator Newmark 0.5 0.25
analysis Transient
puts "[analyze 200 0.02]"
wipe
