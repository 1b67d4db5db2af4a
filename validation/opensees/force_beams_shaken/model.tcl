# A frame of force-based beams with loads along them, P-Delta and joints tied, shaken until its concrete crushes: OpenSees' route through
# the inner iterations. kN, m, s.
model BasicBuilder -ndm 2 -ndf 3
node 1 0.0 0.0
node 2 5.0 0.0
node 3 10.0 0.0
node 11 0.0 3.2
node 12 5.0 3.2
node 13 10.0 3.2
fix 1 1 1 1 
fix 2 1 1 1 
fix 3 1 1 1 
mass 11 19.129656706401185 19.129656706401185 1e-3
mass 12 19.129656706401185 19.129656706401185 1e-3
mass 13 19.129656706401185 19.129656706401185 1e-3
uniaxialMaterial ElasticPP 1 200000000.0 0.0017283376571815379
uniaxialMaterial Concrete02 2 -3.5e4 -0.004 -2.5e4 -0.014 0.5 3000 5e5
uniaxialMaterial Concrete01 3 -2.8e4 -0.002 0.0 -0.006
uniaxialMaterial Hysteretic 4 120 0.003 150 0.02 90 0.05 -120 -0.003 -150 -0.02 -90 -0.05 0.7469275635714446 0.5504277148659731 0.0 0.0 0
uniaxialMaterial ElasticPPGap 5 200000000.0 345667.5314363076 0.0004 0.02
uniaxialMaterial Elastic 6 1e9
uniaxialMaterial Elastic 7 8e5
section Fiber 1 {
  patch rect 2 4 1 -0.15000000000000002 -0.15000000000000002 0.15000000000000002 0.15000000000000002
  patch rect 3 1 1 0.15000000000000002 -0.15000000000000002 0.2 0.15000000000000002
  patch rect 3 1 1 -0.2 -0.15000000000000002 -0.15000000000000002 0.15000000000000002
  layer straight 1 3 0.0005 0.15000000000000002 0.15000000000000002 0.15000000000000002 -0.15000000000000002
  layer straight 1 3 0.0005 -0.15000000000000002 0.15000000000000002 -0.15000000000000002 -0.15000000000000002
}
section Fiber 2 {
  patch rect 2 10 2 -0.2 -0.12499999999999999 0.2 0.12499999999999999
  patch rect 3 1 2 0.2 -0.12499999999999999 0.25 0.12499999999999999
  patch rect 3 1 2 -0.25 -0.12499999999999999 -0.2 0.12499999999999999
  layer straight 1 3 0.0005 0.2 0.12499999999999999 0.2 -0.12499999999999999
  layer straight 1 3 0.0005 -0.2 0.12499999999999999 -0.2 -0.12499999999999999
}
geomTransf PDelta 1
geomTransf Linear 2
element nonlinearBeamColumn 1 1 11 3 1 1 
element nonlinearBeamColumn 2 2 12 5 1 1 
element nonlinearBeamColumn 3 3 13 3 1 1 
element nonlinearBeamColumn 4 11 12 5 2 2 
element nonlinearBeamColumn 5 12 13 3 2 2 -mass 0.4
equalDOF 11 12 1
equalDOF 11 13 1
timeSeries Linear 1
pattern Plain 1 1 {
  load 11 0 -153.03725365120948 0
  load 12 0 -153.03725365120948 0
  load 13 0 -153.03725365120948 0
  eleLoad -ele 4 -type -beamUniform -12.0
  eleLoad -ele 5 -type -beamUniform -12.0
}
constraints Transformation; numberer RCM; system BandGeneral
test NormDispIncr 1e-10 50 0; algorithm Newton; integrator LoadControl 0.1; analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
recorder Node -file disp.out -time -node 11 11 -dof 1 2 3 disp
recorder Element -file force.out -time -ele 1 5 force
recorder Node -file reaction.out -time -node 1 2 -dof 1 2 3 reaction
recorder Element -file section.out -time -ele 1 section 1 deformation
constraints Transformation; numberer RCM; system UmfPack; test NormUnbalance 1e-6 100 0
rayleigh 0.2 0.0 0.0 0.001
timeSeries Path 2 -dt 0.02 -filePath motion.txt -factor 10.0
pattern UniformExcitation 2 1 -accel 2
recorder Node -file accel.out -time -timeSeries 2 -node 11 -dof 1 accel
algorithm ModifiedNewton
integrator Newmark 0.5 0.25; analysis Transient
set done [analyze 240 0.01]
wipe
set file [open done.out w]; puts $file $done; close $file
# Mixed beams: a column in space pushed to and fro in two directions, and a beam in the plane with a rule that is not exact.
wipe
model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 0 0 1.5; node 3 0 0 3; fix 1 1 1 1 1 1 1
uniaxialMaterial Steel02 1 350000. 2e8 0.01 18. 0.925 0.15
section Fiber 1 -GJ 5000. { patch rect 1 6 4 -0.1 -0.08 0.1 0.08 }
geomTransf Corotational 1 1 0 0
beamIntegration Lobatto 1 1 5
element mixedBeamColumn 1 1 2 1 1
element mixedBeamColumn 2 2 3 1 1 -mass 0.1
timeSeries Linear 1
pattern Plain 1 1 { load 3 10. 4. -50. 0 0 1. }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-10 50 0; algorithm Newton; analysis Static
recorder Node -file mixed_space.out -time -node 3 -dof 1 2 3 4 5 6 disp
recorder Element -file mixed_space_force.out -ele 1 localForce
recorder Element -file mixed_space_section.out -ele 1 section 1 deformation
foreach {d n} {0.002 60 -0.002 120 0.002 60} { integrator DisplacementControl 3 1 $d; analyze $n }
wipe
model basic -ndm 2 -ndf 3
node 1 0 0; node 2 4 0; fix 1 1 1 0; fix 2 0 1 0
uniaxialMaterial Steel02 1 350000. 2e8 0.01 18. 0.925 0.15
section Fiber 1 { patch rect 1 10 1 -0.1 -0.08 0.1 0.08 }
geomTransf Linear 1
beamIntegration Lobatto 1 1 3
beamIntegration Legendre 2 1 2
node 3 8 0; fix 3 0 0 1
element mixedBeamColumn 1 1 2 1 1
element mixedBeamColumn 2 2 3 1 2
timeSeries Linear 1
pattern Plain 1 1 { eleLoad -ele 1 2 -type -beamUniform -8. 3.
 load 3 0 -20. 0 }
recorder Node -file mixed_plane.out -time -node 1 2 3 -dof 1 2 3 disp
recorder Element -file mixed_plane_force.out -ele 1 2 force
constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-8 50 0; algorithm Newton; integrator LoadControl 0.05; analysis Static
analyze 30
wipe

# recorder Collapse: an infill wall of two beams on a diagonal is removed when its drifts in and out of the plane reach a curve.
model basic -ndm 3 -ndf 6
node 1 0. 0. 0.
node 2 2. 0. 1.5
node 3 4. 0. 3.
node 4 0. 0. 3.
node 5 4. 0. 0.
foreach n {1 5} { fix $n 1 1 1 1 1 1 }
geomTransf Linear 1 0. 1. 0.
geomTransf Linear 2 0. 1. 0.
element elasticBeamColumn 1 1 4 0.09 2.5e7 1e7 1e-3 6e-4 6e-4 1
element elasticBeamColumn 2 5 3 0.09 2.5e7 1e7 1e-3 6e-4 6e-4 1
element elasticBeamColumn 3 4 3 0.09 2.5e7 1e7 1e-3 6e-4 6e-4 1
uniaxialMaterial Steel01 1 2e3 5e6 0.02
section Fiber 1 -GJ 1e4 { patch rect 1 4 4 -0.1 -0.3 0.1 0.3 }
element forceBeamColumn 4 1 2 3 1 2
element forceBeamColumn 5 2 3 3 1 2
mass 4 20. 20. 20. 0.1 0.1 0.1
mass 3 20. 20. 20. 0.1 0.1 0.1
mass 2 4. 4. 4. 0.1 0.1 0.1
set log [recorder Collapse -ele 4 5 -time -crit INFILLWALL -file collapse_log.out -file_infill infill_curve.txt -global_gravaxis 3 -checknodes 1 2 3]
recorder Collapse -ele 4 5 -node 2
recorder Node -file collapse_disp.out -precision 10 -time -node 3 4 -dof 1 2 3 disp
set motion {}
for {set i 0} {$i < 300} {incr i} { lappend motion [expr 4. * sin(0.25 * $i) * exp(0.004 * $i)] }
timeSeries Path 1 -dt 0.02 -values $motion
pattern UniformExcitation 1 1 -accel 1
pattern UniformExcitation 2 2 -accel 1
rayleigh 0.5 0. 0. 0.
constraints Plain
numberer RCM
system FullGeneral
test NormDispIncr 1e-10 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
puts "[analyze 250 0.02]"
wipe
