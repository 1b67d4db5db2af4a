# One Bouc-Wen bearing under an imposed orbit with constant axial load: the price of a step. Units: N, m, s.
model BasicBuilder -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.0
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
uniaxialMaterial Elastic 1 1.0e9
element elastomericBearingBoucWen 1 1 2 1.0e7 8.0e4 0.1 0.0 3.0 1.0 0.5 0.5 -P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0
timeSeries Constant 1
pattern Plain 1 1 { load 2 0.0 0.0 -1.0e6 0.0 0.0 0.0 }
timeSeries Trig 2 0.0 1000.0 1.0
timeSeries Trig 3 0.0 1000.0 2.0
pattern Plain 2 2 { sp 2 1 0.1 }
pattern Plain 3 3 { sp 2 2 0.05 }
constraints Transformation
numberer Plain
system BandGeneral
test NormUnbalance 1.0e-3 20
algorithm Newton
integrator LoadControl 0.005
analysis Static
if {[analyze 100000] != 0} { error "no convergence" }
