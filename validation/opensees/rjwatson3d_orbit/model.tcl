# RJWatsonEqsBearing in space: growing orbit with rotations under varying axial load, inelastic spring of shear.
# Units: kN, m, s
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 0.0
fix 1 1 1 1 1 1 1
frictionModel VelDependent 1 0.03 0.09 25.0
uniaxialMaterial Elastic 1 1.0e6
uniaxialMaterial Elastic 2 100.0
uniaxialMaterial Elastic 3 2500.0
uniaxialMaterial Elastic 4 1800.0
uniaxialMaterial ElasticPP 5 400.0 0.05
uniaxialMaterial Elastic 6 300.0

element RJWatsonEqsBearing 1 1 2 1 20000.0 -P 1 -Vy 5 -Vz 6 -T 2 -My 3 -Mz 4 -orient 0.1 0.2 1 1 0.3 0 -iter 60 1e-11 -shearDist 0.3
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
set xs {}; set ys {}; set r1 {}; set r2 {}; set r3 {}; set ps {}
for {set i 0} {$i<=200} {incr i} {
 set t [expr {6.2831853*$i/50.0}]
 set g [expr {$i/200.0}]
 lappend xs [expr {0.22*$g*sin($t)}]
 lappend ys [expr {0.18*$g*sin(1.3*$t+0.4)}]
 lappend r1 [expr {0.015*$g*sin(1.7*$t)}]
 lappend r2 [expr {0.012*$g*cos(1.1*$t)}]
 lappend r3 [expr {0.02*$g*sin(0.7*$t)}]
 lappend ps [expr {300.0*sin(0.6*$t)}]
}
remove loadPattern 5
set k 10
foreach v {xs ys r1 r2 r3} d {1 2 4 5 6} {
 incr k
 timeSeries Path $k -dt 1.0 -values [set $v]
 pattern Plain $k $k "sp 2 $d 1.0"
}
timeSeries Path 4 -dt 1.0 -values $ps
pattern Plain 4 4 { load 2 0 0 1.0 0 0 0 }

recorder Element -file force.out -precision 12 -time -ele 1 force
recorder Element -file basicForce.out -precision 12 -time -ele 1 basicForce
recorder Node -file disp.out -precision 12 -time -node 2 -dof 1 2 3 4 5 6 disp
recorder Element -file fr_COF.out -precision 12 -ele 1 frictionModel COF
constraints Transformation
numberer Plain
system FullGeneral
test NormUnbalance 1e-8 200
algorithm Newton
integrator LoadControl 1.0
analysis Static
for {set i 0} {$i<200} {incr i} { if {[analyze 1]!=0} { puts "failed $i"; break } }
wipe
