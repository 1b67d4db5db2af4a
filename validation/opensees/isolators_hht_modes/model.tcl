# Masses on a row of isolators under HHT: a damper of dashpot and spring, an element with mass, Rayleigh damping, and the
# modes of those that have yielded or slid. Units: kN, m, s.
model BasicBuilder -ndm 3 -ndf 6
set weight 1000.0
set m [expr {$weight/9.81}]
uniaxialMaterial Elastic 1 2.0e6
uniaxialMaterial Elastic 2 1.0e5
uniaxialMaterial ViscousDamper 3 4000. 150. 0.5
frictionModel VelDependent 2 0.03 0.08 25.
foreach i {1 2 3} {
    node [expr {10*$i}] [expr {5.0*$i}] 0 0
    node [expr {10*$i+1}] [expr {5.0*$i}] 0 0.3 -mass $m $m $m 1 1 1
    fix [expr {10*$i}] 1 1 1 1 1 1
    fix [expr {10*$i+1}] 0 0 0 1 1 1
}
set springs {-P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0}
element elastomericBearingPlasticity 1 10 11 6000. 60. 0.1 0. 2. {*}$springs
element twoNodeLink 11 10 11 -mat 3 -dir 2 -orient 0 0 1 1 0 0
element singleFPBearing 2 20 21 2 2.0 9000. {*}$springs
element HDR 3 30 31 700. 2e6 0. 0.6 0.003 0.008 20 800. -700. 2500. 30. 300. 30. 0.5 0.5 0.4 3. 0 0 1 1 0 0 10. 0.7 1. 0.5 0.5 0.
timeSeries Linear 1
pattern Plain 1 1 { foreach i {1 2 3} { load [expr {10*$i+1}] 0 0 -$weight 0 0 0 } }
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
rayleigh 0.1 0.0 0.002 0.0

set motion {}
for {set i 0} {$i <= 100} {incr i} {
    set t [expr {0.02*$i}]
    lappend motion [expr {$t*exp(-0.5*$t)*(sin(6.1*$t) + 0.5*sin(13.7*$t+1.0))}]
}
timeSeries Path 2 -dt 0.02 -values $motion -factor 3.0
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 2 -fact 0.6
recorder Node -file disp.out -time -node 11 21 31 -dof 1 2 3 disp
recorder Node -file reaction.out -node 10 20 30 -dof 1 2 3 reaction
recorder Element -file force.out -ele 1 11 2 3 force
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1e-10 200 0
algorithm Newton
integrator HHT 0.9
analysis Transient
set done [analyze 200 0.01]
set file [open modes.out w]
puts $file $done
foreach lambda [eigen -fullGenLapack 9] { puts $file [format %.6e $lambda] }
close $file
