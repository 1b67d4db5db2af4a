# Two elastic beams of Timoshenko with consistent mass and geometric stiffness: member loads, ground motion.
model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 1 3 0.5 -mass 1 1 1 .1 .1 .1; node 3 4 3.5 1.5 -mass 1 1 1 .1 .1 .1; fix 1 1 1 1 1 1 1
geomTransf Linear 1 0.3 0.2 1
section Elastic 1 2e4 0.1 0.01 0.02 8e3 0.03 0.5 0.6
element ElasticTimoshenkoBeam 1 1 2 2e4 8e3 0.1 0.03 0.02 0.01 0.05 0.06 1 -mass 0.3 -cMass -geomNonlinear
element ElasticTimoshenkoBeam 2 2 3 2e4 8e3 0.1 0.03 0.02 0.01 0.05 0.06 1 -mass 0.3 -cMass -geomNonlinear
timeSeries Linear 1
pattern Plain 1 1 { load 3 5 -4 1 2 3 4; eleLoad -ele 1 2 -type -beamUniform -5 3 2 }
recorder Element -file f.out -precision 16 -ele 1 2 force
recorder Element -file l.out -precision 16 -ele 1 2 localForce
recorder Node -file d.out -precision 16 -node 2 3 -dof 1 2 3 4 5 6 disp
recorder Node -file r.out -precision 16 -node 1 -dof 1 2 3 4 5 6 reaction
constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 50; algorithm Newton
integrator LoadControl 0.2; analysis Static; analyze 2
loadConst -time 0
timeSeries Trig 2 0 100 0.7
pattern UniformExcitation 2 1 -accel 2
rayleigh 0.1 0.002 0 0
wipeAnalysis
constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-12 50; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient; analyze 20 0.02
wipe
