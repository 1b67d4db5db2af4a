# A concrete frame in the plane of force-based beams with fibers of Concrete01 and Steel02: gravity and some steps of shaking.
# Arguments: storeys, bays, steps; 40, 62 and 10 are 5,000 beams. Units: kN, m, s. Prints the seconds of each part and the
# displacement of the roof.
set nst 40; set nb 62; set steps 10
foreach {name value} [list nst [lindex $argv 0] nb [lindex $argv 1] steps [lindex $argv 2]] { if {$value ne ""} { set $name $value } }
proc lap {} { global last; set now [clock milliseconds]; set took [expr {0.001*($now-$last)}]; set last $now; return $took }
set last [clock milliseconds]
wipe
model BasicBuilder -ndm 2 -ndf 3
proc nd {s b} { expr {1000*$s + $b} }
for {set s 0} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { node [nd $s $b] [expr {$b*6.0}] [expr {$s*3.2}] } }
for {set b 0} {$b <= $nb} {incr b} { fix [nd 0 $b] 1 1 1 }
uniaxialMaterial Concrete01 1 -35e3 -0.004 -20e3 -0.014
uniaxialMaterial Concrete01 2 -28e3 -0.002 0. -0.006
uniaxialMaterial Steel02 3 420e3 2.0e8 0.01 18 0.925 0.15
section Fiber 1 {
 patch rect 1 16 1 -0.4 -0.4 0.4 0.4
 patch rect 2 16 1 -0.45 0.4 0.45 0.45
 patch rect 2 16 1 -0.45 -0.45 0.45 -0.4
 layer straight 3 6 0.001 0.4 0.4 0.4 -0.4
 layer straight 3 6 0.001 -0.4 0.4 -0.4 -0.4
}
geomTransf PDelta 1
geomTransf Linear 2
set e 0
for {set s 1} {$s <= $nst} {incr s} {
 for {set b 0} {$b <= $nb} {incr b} { incr e; element forceBeamColumn $e [nd [expr {$s-1}] $b] [nd $s $b] 5 1 1 }
 for {set b 0} {$b < $nb} {incr b} { incr e; element forceBeamColumn $e [nd $s $b] [nd $s [expr {$b+1}]] 5 1 2 }
 for {set b 0} {$b <= $nb} {incr b} { mass [nd $s $b] 25. 25. 0. }
}
puts "model of $e beams [lap]"
pattern Plain 1 Linear { for {set s 1} {$s <= $nst} {incr s} { for {set b 0} {$b <= $nb} {incr b} { load [nd $s $b] 0 -100 0 } } }
constraints Plain; numberer RCM; system UmfPack; test NormDispIncr 1e-8 20; algorithm Newton; integrator LoadControl 0.5; analysis Static
puts "static [analyze 2] [lap]"
loadConst -time 0
timeSeries Trig 2 0 10 0.6 -factor 4.0
pattern UniformExcitation 2 1 -accel 2
wipeAnalysis
constraints Plain; numberer RCM; system UmfPack; test NormDispIncr 1e-8 20; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient
puts "steps [analyze $steps 0.02] [lap]"
puts "roof [nodeDisp [nd $nst 0] 1] [nodeDisp [nd $nst 0] 2]"
