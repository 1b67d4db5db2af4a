# A concrete frame of three storeys and two bays, force-based beams with fibers of Concrete01 and Steel02.
# Units: kN, m, s. Prints the displacement of the roof after eighteen seconds of shaking.
wipe
model BasicBuilder -ndm 2 -ndf 3
set nst 3; set nb 2
for {set s 0} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { node [expr {100*$s+$b}] [expr {$b*6.0}] [expr {$s*3.2}] } }
for {set b 0} {$b <= $nb} {incr b} { fix $b 1 1 1 }
uniaxialMaterial Concrete01 1 -35e3 -0.004 -20e3 -0.014
uniaxialMaterial Concrete01 2 -28e3 -0.002 0. -0.006
uniaxialMaterial Steel02 3 420e3 2.0e8 0.01 18 0.925 0.15
section Fiber 1 {
 patch rect 1 12 1 -0.2 -0.2 0.2 0.2
 patch rect 2 12 1 -0.25 0.2 0.25 0.25
 patch rect 2 12 1 -0.25 -0.25 0.25 -0.2
 patch rect 2 2 1 -0.25 -0.2 -0.2 0.2
 patch rect 2 2 1 0.2 -0.2 0.25 0.2
 layer straight 3 4 0.0005 0.2 0.2 0.2 -0.2
 layer straight 3 2 0.0005 0. 0.2 0. -0.2
 layer straight 3 4 0.0005 -0.2 0.2 -0.2 -0.2
}
geomTransf PDelta 1
geomTransf Linear 2
set e 0
for {set s 1} {$s <= $nst} {incr s} {
 for {set b 0} {$b <= $nb} {incr b} { incr e; element forceBeamColumn $e [expr {100*($s-1)+$b}] [expr {100*$s+$b}] 5 1 1 }
 for {set b 0} {$b < $nb} {incr b} { incr e; element forceBeamColumn $e [expr {100*$s+$b}] [expr {100*$s+$b+1}] 5 1 2 }
 for {set b 0} {$b <= $nb} {incr b} { mass [expr {100*$s+$b}] 25. 25. 0. }
}
pattern Plain 1 Linear { for {set s 1} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { load [expr {100*$s+$b}] 0 -200 0 } } }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-8 20; algorithm Newton; integrator LoadControl 0.1; analysis Static
analyze 10
loadConst -time 0
set lam [eigen 2]; set w1 [expr {sqrt([lindex $lam 0])}]; set w2 [expr {sqrt([lindex $lam 1])}]
rayleigh [expr {0.1*$w1*$w2/($w1+$w2)}] 0 0 [expr {0.1/($w1+$w2)}]
set m {}; for {set i 0} {$i <= 2000} {incr i} { set t [expr {0.01*$i}]; lappend m [expr {4.*sin(7.7*$t)*exp(-0.2*$t)+2*sin(17*$t)}] }
timeSeries Path 2 -dt 0.01 -values $m
pattern UniformExcitation 2 1 -accel 2
wipeAnalysis
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-8 20; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient
for {set i 0} {$i < 1800} {incr i} { set ok [analyze 1 0.01]; if {$ok} {puts "fail $i"; break} }
puts [nodeDisp 300 1]
