# FPBearingPTV under a mass, shaken along three axes, with friction that depends on pressure, temperature and speed.
# kN, m, s, °C
model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 0 0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 100. 100. 100. 0 0 0
uniaxialMaterial Elastic 1 2e6; uniaxialMaterial Elastic 2 300.
uniaxialMaterial Elastic 3 500.; uniaxialMaterial Elastic 4 400.
element FPBearingPTV 1 1 2 0.06 1 9549. 1 4.44e-6 0.018 1 20. 2.0 0.2 8000. 1 2 3 4 0 0 1 1 0.3 0 0.3 0 0. 25 1e-8 2
timeSeries Linear 1
pattern Plain 1 1 { load 2 0 0 -1000. 0 0 0 }
constraints Plain
numberer Plain
system FullGeneral
test NormDispIncr 1e-10 60
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.
wipeAnalysis
timeSeries Trig 2 0 100 1.5 -factor 2.5
timeSeries Trig 3 0 100 1.1 -factor 1.5
timeSeries Trig 4 0 100 0.3 -factor 1.0
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
pattern UniformExcitation 4 3 -accel 4
recorder Node -file disp.out -precision 10 -time -node 2 -dof 1 2 3 disp
recorder Element -file force.out -precision 10 -ele 1 force
recorder Element -file temperature.out -precision 10 -ele 1 temperature
recorder Element -file factors.out -precision 10 -ele 1 MuFactors
recorder Element -file flux.out -precision 10 -ele 1 HeatFlux
constraints Plain
numberer Plain
system FullGeneral
test NormDispIncr 1e-10 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
analyze 300 0.01
