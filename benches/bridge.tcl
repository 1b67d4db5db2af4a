# An isolated bridge of three spans in space on two round piers of concrete fibers: what beams with fiber sections cost.
# Units: kN, m, s. Prints the displacement of the middle of the deck after six seconds of shaking.
wipe
model BasicBuilder -ndm 3 -ndf 6
set g 9.81
set height 8.0

# Deck, and piers with two fixed feet.
for {set i 0} {$i <= 18} {incr i} { node [expr {100+$i}] [expr {$i*5.0}] 0.0 [expr {$height+1.0}] -mass 40. 40. 40. 1. 60. 60. }
foreach p {1 2} {
    for {set k 0} {$k <= 4} {incr k} { node [expr {1000*$p+$k}] [expr {$p*30.0}] 0.0 [expr {$k*$height/4.0}] -mass 8. 8. 8. 0.5 0.5 0.5 }
    fix [expr {1000*$p}] 1 1 1 1 1 1
}
foreach {tag x} {900 0.0 901 90.0} { node $tag $x 0.0 $height; fix $tag 1 1 1 1 1 1 }
uniaxialMaterial Concrete02 1 -34500. -0.004 -21000. -0.014 0.1 3000. 1.5e6
uniaxialMaterial Concrete01 2 -27600. -0.002 0. -0.006
uniaxialMaterial Steel02 3 414000. 2.0e8 0.01 18 0.925 0.15
section Fiber 1 -GJ 5.0e6 {
    patch circ 1 16 6 0. 0. 0. 0.6 0 360
    patch circ 2 16 2 0. 0. 0.6 0.7 0 360
    layer circ 3 20 0.0005 0. 0. 0.6
}
geomTransf PDelta 1 1 0 0
geomTransf Linear 2 0 0 1
foreach p {1 2} {
    for {set k 0} {$k < 4} {incr k} {
        set tag [expr {1000*$p+$k}]
        element nonlinearBeamColumn $tag $tag [expr {$tag+1}] 4 1 1
    }
}
for {set i 100} {$i < 118} {incr i} { element elasticBeamColumn $i $i [expr {$i+1}] 6.0 3.0e7 1.25e7 8.0 3.0 40.0 2 -mass 15.0 }

# Rubber on the piers, sliders on the abutments.
uniaxialMaterial Elastic 11 2.0e6
uniaxialMaterial Elastic 12 1.0e5
foreach p {1 2} {
    element elastomericBearingPlasticity [expr {500+$p}] [expr {1000*$p+4}] [expr {100+6*$p}] 8000. 150. 0.1 0.02 2.0 \
        -P 11 -T 12 -My 12 -Mz 12 -orient 0 0 1 1 0 0
}
frictionModel VelDependent 1 0.04 0.09 20.
foreach {tag from to} {503 900 100 504 901 118} {
    element singleFPBearing $tag $from $to 1 2.2 12000. -P 11 -T 12 -My 12 -Mz 12 -orient 0 0 1 1 0 0
}

timeSeries Linear 1
pattern Plain 1 1 { for {set i 100} {$i <= 118} {incr i} { load $i 0 0 [expr {-60.0*$g}] 0 0 0 } }
constraints Transformation; numberer RCM; system UmfPack
test NormDispIncr 1e-9 50; algorithm Newton; integrator LoadControl 0.1; analysis Static
if {[analyze 10] != 0} { error "no equilibrium under the weight" }
loadConst -time 0.0
wipeAnalysis
# The tangents of bearings are not symmetric, as the default solver of OpenSees takes them to be.
set lambda [eigen -fullGenLapack 3]
set w1 [expr {sqrt([lindex $lambda 0])}]
set w2 [expr {sqrt([lindex $lambda 2])}]
rayleigh [expr {0.1*$w1*$w2/($w1+$w2)}] 0.0 0.0 [expr {0.1/($w1+$w2)}]
set motion {}
for {set i 0} {$i <= 300} {incr i} {
    set t [expr {0.02*$i}]
    lappend motion [expr {$t*exp(-0.5*$t)*(sin(5.1*$t) + 0.6*sin(11.7*$t+1.0) + 0.4*sin(23.0*$t+2.0))}]
}
timeSeries Path 2 -dt 0.02 -values $motion -factor 2.0
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 2 -fact 0.7
constraints Transformation; numberer RCM; system UmfPack
test NormDispIncr 1e-7 50; algorithm KrylovNewton; integrator Newmark 0.5 0.25; analysis Transient
if {[analyze 600 0.01] != 0} { error "no convergence" }
puts [nodeDisp 109]
