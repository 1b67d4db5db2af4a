# TripleFrictionPendulumX with friction that depends on pressure, speed and temperature: growing orbit, under varying axial load, with rotations.
# OpenSees counts the heat right only where the domain time is not 0 when the element is made (else it writes beyond its
# arrays), and takes the tag of the conduction, 2, for that of the vertical material.
# Units: kN, m, s
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 0.3
fix 1 1 1 1 1 1 1
uniaxialMaterial Elastic 1 1.0e3
uniaxialMaterial Elastic 2 1.0e6
uniaxialMaterial Elastic 3 20.0
uniaxialMaterial Elastic 4 30.0
setTime 1.0
element TripleFrictionPendulumX 1 1 2 1 2 1 3 4 4 1 1 1 0.02 0.06 0.10 0.36 1.25 1.25 0.1 0.2 0.2 0.24 0.36 0.36 0.012 0.015 900.0 0.001 1.0 0.1 1e-8 19894.0 8842.0 8842.0 4.44e-6 0.018 20.0 20.0 2 2
setTime 0.0

timeSeries Linear 1
pattern Plain 1 1 { load 2 0 0 -900.0 0 0 0 }
constraints Transformation
numberer Plain
system FullGeneral
test NormUnbalance 1e-9 100
algorithm Newton
integrator LoadControl 0.1
analysis Static
pattern Plain 5 1 { sp 2 1 0.0; sp 2 2 0.0; sp 2 4 0.0; sp 2 5 0.0; sp 2 6 0.0 }
if {[analyze 10]!=0} { puts "gravity failed"; exit 1}
loadConst -time 0.0
wipeAnalysis
set xs {}; set ys {}; set r1 {}; set ps {}
for {set i 0} {$i<=400} {incr i} {
 set t [expr {6.2831853*$i/100.0}]
 set g [expr {$i/400.0}]
 lappend xs [expr {0.45*$g*sin($t)}]
 lappend ys [expr {0.27*$g*sin(1.3*$t+0.4)}]
 lappend r1 [expr {0.015*$g*sin(1.7*$t)}]
 lappend ps [expr {300.0*sin(0.6*$t)}]
}
remove loadPattern 5
set k 10
foreach v {xs ys r1 r1 r1} d {1 2 4 5 6} {
 incr k
 timeSeries Path $k -dt 0.02 -values [set $v]
 pattern Plain $k $k "sp 2 $d 1.0"
}
timeSeries Path 4 -dt 0.02 -values $ps
pattern Plain 4 4 { load 2 0 0 1.0 0 0 0 }

recorder Element -file force.out -precision 12 -time -ele 1 force
recorder Element -file basicForce.out -precision 12 -time -ele 1 basicForce
recorder Element -file compDisplacement.out -precision 12 -time -ele 1 compDisplacement
recorder Element -file Parameters.out -precision 12 -time -ele 1 Parameters
constraints Transformation
numberer Plain
system FullGeneral
test NormUnbalance 1e-8 200
algorithm Newton
integrator LoadControl 0.02
analysis Static
for {set i 0} {$i<400} {incr i} { if {[analyze 1]!=0} { puts "failed $i"; break } }
wipe
