# Beams between rotational springs, elastic and hysteretic, under gravity, to and fro, then in time.
model basic -ndm 2 -ndf 3
node 1 0 0; node 2 6 0; node 3 0 3; node 4 6 3; fix 1 1 1 1; fix 2 1 1 0
mass 3 2 2 0.01; mass 4 2 2 0.01
geomTransf Linear 1
uniaxialMaterial Elastic 5 1e5
uniaxialMaterial Hysteretic 6 50 0.001 80 0.01 60 0.05 -50 -0.001 -80 -0.01 -60 -0.05 0.8 0.2 0 0 0
element componentElement2d 1 1 3 0.1 2e6 0.001 1 5 6 -rho 0.3
element componentElement2d 2 2 4 0.1 2e6 0.001 1 5 6 -rho 0.3
element componentElement2d 3 3 4 0.1 2e6 0.001 1 5 6 -rho 0.3
timeSeries Constant 1
timeSeries Path 10 -dt 10 -values {0 3 -4 6 -6 7 -2 3 -8 8 0}
pattern Plain 1 1 { load 3 0 -20 0; load 4 0 -20 0
 eleLoad -ele 3 -type -beamUniform -3.0 }
recorder Node -file d.out -time -node 3 4 -dof 1 2 3 disp
recorder Element -file f.out -time -ele 1 2 3 localForce
recorder Element -file g.out -time -ele 1 2 3 force
recorder Element -file t.out -time -ele 1 2 3 hingeTangent
constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-8 60; algorithm Newton; integrator LoadControl 1; analysis Static
analyze 1
loadConst -time 0
pattern Plain 3 10 { load 3 6 0 0 }
integrator LoadControl 1
analyze 100
wipeAnalysis
constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-8 60; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient
analyze 100 0.02
