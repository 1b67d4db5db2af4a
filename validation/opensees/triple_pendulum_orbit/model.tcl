# TripleFrictionPendulum with speed-dependent friction: growing orbit beyond the edge of the surfaces, under varying axial load, with rotations.
# Units: kN, m, s
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 0.3
fix 1 1 1 1 1 1 1
frictionModel VelDependent 1 0.012 0.02 25
frictionModel VelDependent 2 0.03 0.06 20
frictionModel VelDependent 3 0.05 0.10 15
uniaxialMaterial Elastic 1 1.0e6
uniaxialMaterial Elastic 2 10.0
uniaxialMaterial Elastic 3 20.0
uniaxialMaterial Elastic 4 30.0
element TripleFrictionPendulum 1 1 2 1 2 3 1 2 3 4 0.36 1.25 1.25 0.1 0.2 0.2 900.0 0.001 1.0 0.1 1e-8

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
for {set i 0} {$i<=300} {incr i} {
 set t [expr {6.2831853*$i/75.0}]
 set g [expr {$i/300.0}]
 lappend xs [expr {0.62*$g*sin($t)}]
 lappend ys [expr {0.372*$g*sin(1.3*$t+0.4)}]
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
recorder Element -file fr1_COF.out -precision 12 -ele 1 frictionModel 1 COF
recorder Element -file fr3_vel.out -precision 12 -ele 1 frictionModel 3 vel
constraints Transformation
numberer Plain
system FullGeneral
test NormUnbalance 1e-8 200
algorithm Newton
integrator LoadControl 0.02
analysis Static
for {set i 0} {$i<300} {incr i} { if {[analyze 1]!=0} { puts "failed $i"; break } }
wipe
