# A steel frame of four storeys and three bays, force-based beams with fibers of Steel02: how dear curves of steel are.
# Units: kN, m, s. Prints the displacement of the roof after eight seconds of shaking.
wipe
model BasicBuilder -ndm 2 -ndf 3
set nst 4; set nb 3
for {set s 0} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { node [expr {100*$s+$b}] [expr {$b*7.3}] [expr {$s*3.9}] } }
for {set b 0} {$b <= $nb} {incr b} { fix $b 1 1 1 }
uniaxialMaterial Steel02 1 345e3 2.0e8 0.02 18.5 0.925 0.15
proc W {id d bf tf tw} {
  section Fiber $id {
    set h [expr {$d/2.0}]; set w [expr {$bf/2.0}]; set hw [expr {$h-$tf}]; set t2 [expr {$tw/2.0}]
    patch quad 1 16 2 [expr {-$h}] $w [expr {-$h}] [expr {-$w}] [expr {-$hw}] [expr {-$w}] [expr {-$hw}] $w
    patch quad 1 2 16 [expr {-$hw}] $t2 [expr {-$hw}] [expr {-$t2}] $hw [expr {-$t2}] $hw $t2
    patch quad 1 16 2 $hw $w $hw [expr {-$w}] $h [expr {-$w}] $h $w
  }
}
W 1 0.50 0.30 0.03 0.018
W 2 0.60 0.25 0.02 0.012
geomTransf PDelta 1
geomTransf Linear 2
set e 0
for {set s 1} {$s <= $nst} {incr s} {
 for {set b 0} {$b <= $nb} {incr b} { incr e; element forceBeamColumn $e [expr {100*($s-1)+$b}] [expr {100*$s+$b}] 5 1 1 }
 for {set b 0} {$b < $nb} {incr b} { incr e; element forceBeamColumn $e [expr {100*$s+$b}] [expr {100*$s+$b+1}] 5 2 2 }
 for {set b 0} {$b <= $nb} {incr b} { mass [expr {100*$s+$b}] 40. 40. 0. }
}
pattern Plain 1 Linear { for {set s 1} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { load [expr {100*$s+$b}] 0 -400 0 } } }
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-8 20; algorithm Newton; integrator LoadControl 0.1; analysis Static
analyze 10
loadConst -time 0
set lam [eigen 2]; set w1 [expr {sqrt([lindex $lam 0])}]; set w2 [expr {sqrt([lindex $lam 1])}]
rayleigh [expr {0.04*$w1*$w2/($w1+$w2)}] 0 0 [expr {0.04/($w1+$w2)}]
set m {}; for {set i 0} {$i <= 1000} {incr i} { set t [expr {0.01*$i}]; lappend m [expr {8.*sin(4.7*$t)*exp(-0.2*$t)+3*sin(17*$t)}] }
timeSeries Path 2 -dt 0.01 -values $m
pattern UniformExcitation 2 1 -accel 2
wipeAnalysis
constraints Plain; numberer RCM; system BandGeneral; test NormDispIncr 1e-8 20; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient
for {set i 0} {$i < 800} {incr i} { set ok [analyze 1 0.01]; if {$ok} {puts "fail $i"; break} }
puts [nodeDisp 400 1]
