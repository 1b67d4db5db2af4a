# A frame in space: force-based columns that turn with large rotations, hinged feet, diaphragm, loads along the beams, braces; pushed back and
# forth. kN, m.
model BasicBuilder -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 5.0 0.0 0.0
node 11 0.0 3.2 0.0
node 12 5.0 3.2 0.0
node 21 0.0 6.4 0.0
node 22 5.0 6.4 0.0
node 31 0.0 9.600000000000001 0.0
node 32 5.0 9.600000000000001 0.0
node 101 0.0 0.0 4.0
node 102 5.0 0.0 4.0
node 111 0.0 3.2 4.0
node 112 5.0 3.2 4.0
node 121 0.0 6.4 4.0
node 122 5.0 6.4 4.0
node 131 0.0 9.600000000000001 4.0
node 132 5.0 9.600000000000001 4.0
fix 1 1 1 1 1 1 1 
fix 2 1 1 1 1 1 1 
fix 101 1 1 1 1 1 1 
fix 102 1 1 1 1 1 1 
mass 11 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 12 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 21 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 22 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 31 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 32 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 111 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 112 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 121 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 122 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 131 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
mass 132 29.795404940330513 29.795404940330513 29.795404940330513 1 1 1
uniaxialMaterial Steel02 1 300603.1138499842 200000000.0 0.01 15 0.925 0.15 0.05 1.0 0.05 1.0
uniaxialMaterial Concrete02 2 -3.5e4 -0.004 -2.5e4 -0.014 0.1 2000 1e6
uniaxialMaterial Concrete02 3 -2.8e4 -0.002 -5e3 -0.006 0.1 2000 1e6
uniaxialMaterial Steel02 4 120 4e4 0.02 18 0.925 0.15
uniaxialMaterial Steel02 15 300603.1138499842 200000000.0 0.01 18 0.925 0.15
uniaxialMaterial Fatigue 5 15 -E0 0.191 -m -0.458
uniaxialMaterial Elastic 6 1e9
uniaxialMaterial Elastic 7 8e5
section Fiber 1 -GJ 1e5 {
  patch rect 2 4 4 -0.15000000000000002 -0.15000000000000002 0.15000000000000002 0.15000000000000002
  patch rect 3 1 4 0.15000000000000002 -0.15000000000000002 0.2 0.15000000000000002
  patch rect 3 1 4 -0.2 -0.15000000000000002 -0.15000000000000002 0.15000000000000002
  layer straight 1 3 0.0005 0.15000000000000002 0.15000000000000002 0.15000000000000002 -0.15000000000000002
  layer straight 1 3 0.0005 -0.15000000000000002 0.15000000000000002 -0.15000000000000002 -0.15000000000000002
}
section Fiber 2 -GJ 1e5 {
  patch rect 2 4 4 -0.2 -0.12499999999999999 0.2 0.12499999999999999
  patch rect 3 1 4 0.2 -0.12499999999999999 0.25 0.12499999999999999
  patch rect 3 1 4 -0.25 -0.12499999999999999 -0.2 0.12499999999999999
  layer straight 1 3 0.0005 0.2 0.12499999999999999 0.2 -0.12499999999999999
  layer straight 1 3 0.0005 -0.2 0.12499999999999999 -0.2 -0.12499999999999999
}
geomTransf Corotational 1 0 0 1
geomTransf Linear 2 0 0 1
geomTransf Linear 3 1 0 0
node 1001 0.0 0 0.0
equalDOF 1 1001 1 2 3 4 5
element zeroLength 501 1 1001 -mat 4 -dir 6
beamIntegration Radau 1 1 3
element forceBeamColumn 1 1001 11 1 1 
node 1002 5.0 0 0.0
equalDOF 2 1002 1 2 3 4 5
element zeroLength 502 2 1002 -mat 4 -dir 6
beamIntegration Lobatto 2 1 4
element forceBeamColumn 2 1002 12 1 2 
beamIntegration Lobatto 3 1 5
element forceBeamColumn 3 11 21 1 3 
element beamWithHinges 4 11 12 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 -mass 0.4
element elasticBeamColumn 5 11 111 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
beamIntegration Radau 6 1 4
element forceBeamColumn 6 12 22 1 6 -mass 0.2
element elasticBeamColumn 7 12 112 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
beamIntegration HingeRadau 8 1 0.3 1 0.3 1
element forceBeamColumn 8 21 31 1 8 
element beamWithHinges 9 21 22 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 
element elasticBeamColumn 10 21 121 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
beamIntegration Lobatto 11 1 5
element forceBeamColumn 11 22 32 1 11 -mass 0.2
element elasticBeamColumn 12 22 122 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
element beamWithHinges 13 31 32 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 
element elasticBeamColumn 14 31 131 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
element elasticBeamColumn 15 32 132 0.18 2.5e7 1e7 4e-3 2e-3 3e-3 3
node 1101 0.0 0 4.0
equalDOF 101 1101 1 2 3 4 5
element zeroLength 516 101 1101 -mat 4 -dir 6
beamIntegration Legendre 16 1 5
element forceBeamColumn 16 1101 111 1 16 
node 1102 5.0 0 4.0
equalDOF 102 1102 1 2 3 4 5
element zeroLength 517 102 1102 -mat 4 -dir 6
beamIntegration Lobatto 17 1 4
element forceBeamColumn 17 1102 112 1 17 
beamIntegration Lobatto 18 1 4
element forceBeamColumn 18 111 121 1 18 -mass 0.2
element beamWithHinges 19 111 112 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 
beamIntegration Lobatto 20 1 5
element forceBeamColumn 20 112 122 1 20 
beamIntegration Lobatto 21 1 3
element forceBeamColumn 21 121 131 1 21 -mass 0.2
element beamWithHinges 22 121 122 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 
beamIntegration Legendre 23 1 5
element forceBeamColumn 23 122 132 1 23 
element beamWithHinges 24 131 132 2 0.3 2 0.3 25000000.0 0.18 0.003 0.0024000000000000002 10416666.666666668 4e-3 2 -mass 0.4
element corotTruss 25 1 12 0.0005 5
element corotTruss 26 101 112 0.0005 5
rigidDiaphragm 2 11 12 111 112
rigidDiaphragm 2 21 22 121 122
rigidDiaphragm 2 31 32 131 132
timeSeries Linear 1
pattern Plain 1 1 {
  load 11 0 -238.3632395226441 0 0 0 0
  load 12 0 -238.3632395226441 0 0 0 0
  load 21 0 -238.3632395226441 0 0 0 0
  load 22 0 -238.3632395226441 0 0 0 0
  load 31 0 -238.3632395226441 0 0 0 0
  load 32 0 -238.3632395226441 0 0 0 0
  load 111 0 -238.3632395226441 0 0 0 0
  load 112 0 -238.3632395226441 0 0 0 0
  load 121 0 -238.3632395226441 0 0 0 0
  load 122 0 -238.3632395226441 0 0 0 0
  load 131 0 -238.3632395226441 0 0 0 0
  load 132 0 -238.3632395226441 0 0 0 0
  eleLoad -ele 4 -type -beamUniform -12.0 0.0
  eleLoad -ele 9 -type -beamUniform -12.0 0.0
  eleLoad -ele 13 -type -beamUniform -12.0 0.0
  eleLoad -ele 19 -type -beamUniform -12.0 0.0
  eleLoad -ele 22 -type -beamUniform -12.0 0.0
  eleLoad -ele 24 -type -beamUniform -12.0 0.0
}
constraints Transformation; numberer RCM; system FullGeneral
test NormDispIncr 1e-10 50 0; algorithm Newton; integrator LoadControl 0.1; analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
recorder Node -file disp.out -time -node 11 31 -dof 1 2 3 6 disp
recorder Element -file force.out -time -ele 1 24 force
recorder Node -file reaction.out -time -node 1 2 -dof 1 2 3 6 reaction
recorder Element -file section.out -time -ele 1 section 1 deformation
constraints Transformation; numberer RCM; system UmfPack; test EnergyIncr 1e-14 100 0
pattern Plain 2 1 {
  load 11 10.0 0 0 0 0 0
  load 21 20.0 0 0 0 0 0
  load 31 30.0 0 0 0 0 0
}
algorithm Newton
set done 0
foreach amplitude {0.02 -0.02 0.05 -0.05 0.0} {
  set d [expr {($amplitude * 3 - [nodeDisp 31 1]) / 48}]
  integrator DisplacementControl 31 1 $d; analysis Static
  set ok [analyze 48]; if {$ok != 0} { break }
}
wipe
set file [open done.out w]; puts $file $ok; close $file
