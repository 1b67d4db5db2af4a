# Damping of single elements: a portal of elastic, displacement-based and force-based beams over a spring, a strip of quads and
# one of shells, under constant loads and shaken.
model basic -ndm 2 -ndf 3
damping Uniform 1 0.05 0.5 30
damping SecStif 2 0.01 -activateTime 0.2 -deactivateTime 1.6
damping URD 3 3 0.5 0.03 5 0.05 50 0.04 -iter 100
damping URDbeta 4 3 0.5 0.03 5 0.05 50 0.04
damping Uniform 5 0.03 0.2 60
node 1 0 0; node 2 0 3; node 3 4 3; node 4 4 0; node 5 0 0; node 6 8 3; node 7 8 0
fix 5 1 1 1; fix 4 1 1 1; fix 7 1 1 1
foreach n {2 3 6} { mass $n 1. 1. 1e-4 }
mass 1 0.1 0.1 1e-4
geomTransf PDelta 1
geomTransf Corotational 2
uniaxialMaterial Steel01 1 300e3 2e8 0.02
uniaxialMaterial Elastic 2 1e5
uniaxialMaterial Elastic 3 2e4
section Fiber 1 { patch rect 1 8 1 -0.05 -0.04 0.05 0.04 }
beamIntegration Lobatto 1 1 5
element zeroLength 1 5 1 -mat 2 2 3 -dir 1 2 6 -damp 5
element elasticBeamColumn 2 1 2 0.008 2e8 6.67e-6 1 -damp 1
element dispBeamColumn 3 2 3 1 1 -damp 3
element forceBeamColumn 4 4 3 2 1 -damp 4
element elasticBeamColumn 5 3 6 0.008 2e8 6.67e-6 1
element elasticBeamColumn 6 7 6 0.008 2e8 6.67e-6 2 -damp 2
timeSeries Linear 1
pattern Plain 1 1 { load 2 0 -20 0; load 3 0 -20 0; eleLoad -ele 3 -type -beamUniform -5. }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-11 50; algorithm Newton
integrator LoadControl 0.1; analysis Static
analyze 10
loadConst -time 0
wipeAnalysis
# A damping that comes later begins without a history.
region 1 -ele 5 -damp 1
timeSeries Trig 2 0 100 0.37 -factor 6.0
pattern UniformExcitation 2 1 -accel 2
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-11 50; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient
recorder Node -file disp.out -precision 10 -time -node 1 2 3 6 -dof 1 2 3 disp
recorder Element -file force.out -precision 10 -time -ele 1 2 3 4 5 6 force
recorder Element -file local.out -precision 10 -time -ele 2 3 4 localForce
recorder Element -file damping.out -precision 10 -time -ele 2 3 4 5 6 globalDampingForce
recorder Node -file reaction.out -precision 10 -time -node 4 5 7 -dof 1 2 3 reaction
recorder Node -file dynamic.out -precision 10 -time -node 4 5 7 -dof 1 2 3 reactionIncludingInertia
analyze 220 0.01
wipe
model basic -ndm 2 -ndf 2
nDMaterial ElasticIsotropic 1 2e5 0.2 0.001
damping Uniform 1 0.05 0.5 30
for {set i 0} {$i <= 4} {incr i} { for {set j 0} {$j <= 1} {incr j} { node [expr 1+$i+5*$j] [expr 1.0*$i+0.1*$j] [expr 1.0*$j] } }
fix 1 1 1; fix 6 1 1
for {set i 1} {$i <= 4} {incr i} { element quad $i $i [expr $i+1] [expr $i+6] [expr $i+5] 1.0 PlaneStress 1 0. 0. 0. -0.2 -damp 1 }
timeSeries Trig 2 0 100 0.37
pattern Plain 2 2 { load 5 10. -30. }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-12 50; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient
recorder Node -file quads.out -precision 10 -time -node 5 -dof 1 2 disp
recorder Element -file quad.out -precision 10 -time -ele 1 forces
analyze 120 0.01
wipe
model basic -ndm 3 -ndf 6
section ElasticMembranePlateSection 1 2e5 0.2 0.1 0.001
damping SecStif 1 0.01
for {set i 0} {$i <= 4} {incr i} { for {set j 0} {$j <= 1} {incr j} { node [expr 1+$i+5*$j] [expr 1.0*$i+0.1*$j] [expr 1.0*$j] 0.0 } }
fix 1 1 1 1 1 1 1; fix 6 1 1 1 1 1 1
element ShellMITC4 1 1 2 7 6 1 -damp 1
element ShellDKGQ 2 2 3 8 7 1 -damp 1
element ShellDKGT 3 3 4 9 1 -damp 1
element ShellDKGT 4 3 9 8 1 -damp 1
element ShellMITC4 5 4 5 10 9 1
timeSeries Trig 2 0 100 0.37
pattern Plain 2 2 { load 5 2. 1. -5. 0 0 0 }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-12 50; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient
recorder Node -file shells.out -precision 10 -time -node 5 -dof 1 2 3 disp
recorder Element -file shell.out -precision 10 -time -ele 1 2 forces
analyze 120 0.01
wipe
