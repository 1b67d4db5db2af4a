# Clocks and damping under HHT: a triple pendulum, which has no way to stay out of Rayleigh damping, and lead that heats by the
# domain time. Units: kN, m, s.
model BasicBuilder -ndm 3 -ndf 6
set weight 1000.0
set m [expr {$weight/9.81}]
uniaxialMaterial Elastic 1 2.0e6
uniaxialMaterial Elastic 2 1.0e5
frictionModel Coulomb 1 0.03
frictionModel Coulomb 2 0.06
foreach {base top height} {1 2 0.0 3 4 0.3} {
    node $base $base 0 0
    fix $base 1 1 1 1 1 1
    node $top $base 0 $height -mass $m $m $m 1 1 1
    fix $top 0 0 0 1 1 1
}
element TripleFrictionPendulum 1 1 2 1 2 2 1 2 2 2 0.3 1. 1. 0.1 0.3 0.3 $weight 0.002 2.0e6 0.1 1e-8
element LeadRubberX 2 3 4 60. 0.12 700. 2e6 0.1 0.6 0.003 0.008 20 0 0 1 1 0 0 10. 0.7 1. 0.4 0. 0. 0. 11.2 130. 0.05 1.41e-5 0 0 0 0 1
timeSeries Linear 1
pattern Plain 1 1 { load 2 0 0 -$weight 0 0 0; load 4 0 0 -$weight 0 0 0 }
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-12 100 0
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
rayleigh 0.1 0.0 0.001 0.0
timeSeries Trig 2 0.0 1.5 0.6 -factor 0.6
pattern UniformExcitation 2 1 -accel 2
recorder Node -file disp.out -time -node 2 4 -dof 1 3 disp
recorder Element -file force.out -ele 1 2 force
recorder Element -file temperature.out -ele 2 Parameters
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-10 200 0
algorithm Newton
integrator HHT 0.9
analysis Transient
set file [open done.out w]
puts $file [analyze 150 0.01]
close $file
