# A base-isolated frame of 40 x 40 bays and 4 storeys, 50,430 degrees of freedom: gravity, ten modes and twenty steps
# of shaking on 1,681 bearings of Bouc and Wen. Arguments: bays, storeys, system of equations. Units: kN, m, s.
# Prints the seconds of each part, the settlement of the roof, the first and tenth period, and the drift at the end.
set bays 40; set storeys 4; set solver "UmfPack"
foreach {name value} [list bays [lindex $argv 0] storeys [lindex $argv 1] solver [lindex $argv 2]] { if {$value ne ""} { set $name $value } }
wipe
model BasicBuilder -ndm 3 -ndf 6
proc nd {l i j} { expr {10000*$l + 100*$i + $j + 1} }
proc lap {} { global last; set now [clock milliseconds]; set took [expr {0.001*($now-$last)}]; set last $now; return $took }
set last [clock milliseconds]
for {set l 0} {$l <= $storeys + 1} {incr l} {
  for {set i 0} {$i <= $bays} {incr i} { for {set j 0} {$j <= $bays} {incr j} {
    node [nd $l $i $j] [expr {6.0*$i}] [expr {6.0*$j}] [expr {$l < 1 ? 0.0 : 0.3 + 3.2*($l-1)}]
    if {$l == 0} { fix [nd $l $i $j] 1 1 1 1 1 1 } else { mass [nd $l $i $j] 36. 36. 36. 0.5 0.5 0.5 }
  } }
}
uniaxialMaterial Elastic 1 2.0e6
uniaxialMaterial Elastic 2 1.0e3
geomTransf PDelta 1 0 1 0
geomTransf Linear 2 0 0 1
set e 0
for {set l 0} {$l <= $storeys} {incr l} {
  for {set i 0} {$i <= $bays} {incr i} { for {set j 0} {$j <= $bays} {incr j} {
    incr e
    if {$l == 0} {
      element elastomericBearingBoucWen $e [nd 0 $i $j] [nd 1 $i $j] 9000. 250.0 0.10 0.0 2.0 1.0 0.5 0.5 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
    } else {
      element elasticBeamColumn $e [nd $l $i $j] [nd [expr {$l+1}] $i $j] 0.64 3.0e7 1.25e7 0.058 0.034 0.034 1
    }
  } }
}
for {set l 1} {$l <= $storeys + 1} {incr l} {
  for {set i 0} {$i <= $bays} {incr i} { for {set j 0} {$j <= $bays} {incr j} {
    if {$i < $bays} { incr e; element elasticBeamColumn $e [nd $l $i $j] [nd $l [expr {$i+1}] $j] 0.24 3.0e7 1.25e7 0.008 0.0032 0.0072 2 }
    if {$j < $bays} { incr e; element elasticBeamColumn $e [nd $l $i $j] [nd $l $i [expr {$j+1}]] 0.24 3.0e7 1.25e7 0.008 0.0032 0.0072 2 }
  } }
}
set roof [nd [expr {$storeys+1}] 0 0]
puts "model [lap]"
timeSeries Linear 1
pattern Plain 1 1 { for {set l 1} {$l <= $storeys + 1} {incr l} { for {set i 0} {$i <= $bays} {incr i} { for {set j 0} {$j <= $bays} {incr j} { load [nd $l $i $j] 0 0 [expr {-36*9.81}] 0 0 0 } } } }
constraints Plain; numberer RCM; system $solver; test NormDispIncr 1e-8 20; algorithm Newton; integrator LoadControl 1.0; analysis Static
puts "static [analyze 1] [lap]"
puts "settlement [nodeDisp $roof 3]"
loadConst -time 0
set values [eigen 10]
puts "modes [lap]"
puts "periods [expr {6.283185307179586/sqrt([lindex $values 0])}] [expr {6.283185307179586/sqrt([lindex $values 9])}]"
timeSeries Trig 2 0 10 1.0 -factor 3.0
pattern UniformExcitation 2 1 -accel 2
wipeAnalysis
constraints Plain; numberer RCM; system $solver; test NormDispIncr 1e-8 20; algorithm Newton; integrator Newmark 0.5 0.25; analysis Transient
puts "steps [analyze 20 0.02] [lap]"
puts "drift [nodeDisp [nd 1 0 0] 1] [nodeDisp $roof 1]"
