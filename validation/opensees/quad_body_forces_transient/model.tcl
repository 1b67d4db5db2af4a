# Plane-strain quadrilaterals with pressure, body forces and mass of their own, shaken and damped.
model basic -ndm 2 -ndf 2
node 1 0 0; node 2 1.1 0.1; node 3 2.2 -0.1; node 4 0.1 0.9; node 5 1.0 1.1; node 6 2.0 1.2; node 7 -0.1 2; node 8 1.2 2.1; node 9 2.1 2.2
fix 1 1 1; fix 2 0 1; fix 3 0 1
nDMaterial ElasticIsotropic 1 1000 0.3 0.003
element quad 1 1 2 5 4 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0
element quad 2 2 3 6 5 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0
element quad 3 4 5 8 7 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0
element quad 4 5 6 9 8 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0
timeSeries Linear 1
pattern Plain 1 1 { load 7 1 2
 load 9 2 -1 }
timeSeries Trig 2 0 1 0.2
pattern UniformExcitation 2 1 -accel 2
recorder Node -file d.out -time -node 4 5 6 7 8 9 -dof 1 2 disp
recorder Element -file f.out -time -ele 1 2 3 4 forces
recorder Element -file s.out -time -ele 1 2 3 4 stresses
recorder Element -file n.out -time -ele 1 2 3 4 stressesAtNodes
constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
rayleigh 0.2 0.001 0 0
integrator Newmark 0.5 0.25; analysis Transient
analyze 40 0.01
# Elements with one Gauss point.
wipe
model basic -ndm 2 -ndf 2
node 1 0 0; node 2 1.1 0.1; node 3 2.2 -0.1; node 4 0.1 0.9; node 5 1.0 1.1; node 6 2.0 1.2; node 7 -0.1 2; node 8 1.2 2.1; node 9 2.1 2.2
fix 1 1 1; fix 2 0 1; fix 3 0 1
nDMaterial ElasticIsotropic 1 1000 0.3 0.003
element SSPquad 1 1 2 5 4 1 PlaneStrain 0.4 0.5 -1.0
element SSPquad 2 2 3 6 5 1 PlaneStress 0.4
element tri31 3 4 5 7 0.4 PlaneStrain 1 3.0 0.002 0.5 -1.0
element tri31 4 5 8 7 0.4 PlaneStress 1
element SSPquad 5 5 6 9 8 1 PlaneStrain 0.4
timeSeries Linear 1
pattern Plain 1 1 { load 7 1 2
 load 9 2 -1 }
timeSeries Trig 2 0 1 0.2
pattern UniformExcitation 2 1 -accel 2
recorder Node -file one_point_d.out -time -node 4 5 6 7 8 9 -dof 1 2 disp
recorder Element -file one_point_quad.out -time -ele 1 2 5 stress
recorder Element -file one_point_triangle.out -time -ele 3 4 stresses
recorder Element -file one_point_f.out -time -ele 3 4 forces
constraints Plain; numberer RCM; system BandGeneral; test NormUnbalance 1e-9 20; algorithm Newton
rayleigh 0.2 0.001 0 0
integrator Newmark 0.5 0.25; analysis Transient
analyze 40 0.01
