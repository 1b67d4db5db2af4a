# NewmarkHSFixedNumIter on a shaken frame with a yielding link.
model basic -ndm 2 -ndf 3
node 1 0 0; node 2 0 3; node 3 0 6; fix 1 1 1 1
mass 2 2 2 0.1; mass 3 1 1 0.1
geomTransf Linear 1
uniaxialMaterial Steel01 1 80 4000 0.05
uniaxialMaterial Viscous 2 5 1.0
element elasticBeamColumn 1 1 2 0.1 2e4 0.01 1
node 4 0 3; fix 4 1 1 1
element twoNodeLink 2 4 2 -mat 1 -dir 1 -orient 1 0 0 0 1 0
element elasticBeamColumn 3 2 3 0.1 2e4 0.01 1
rayleigh 0.3 0.002 0 0
timeSeries Trig 1 0 10 1.0 -factor 3
pattern UniformExcitation 1 1 -accel 1
timeSeries Linear 2
pattern Plain 2 2 { load 3 5 0 0 }
recorder Node -file disp.out -time -node 2 3 -dof 1 2 3 disp
recorder Node -file vel.out -time -node 2 3 -dof 1 3 vel
recorder Node -file acc.out -time -node 2 3 -dof 1 3 accel
recorder Element -file ele.out -time -ele 1 2 3 force
constraints Plain
system BandGeneral
numberer Plain
test FixedNumIter 4
algorithm Newton
integrator NewmarkHSFixedNumIter 0.5 0.25
analysis Transient
analyze 300 0.01
