# TripleFrictionPendulum with Coulomb friction under three components of ground motion; Newmark.
# Units: kN, m, s
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 0
fix 1 1 1 1 1 1 1
frictionModel Coulomb 1 0.02
frictionModel Coulomb 2 0.06
frictionModel Coulomb 3 0.10
uniaxialMaterial ENT 1 1.0e6
uniaxialMaterial Elastic 2 10.0
uniaxialMaterial Elastic 3 20.0
uniaxialMaterial Elastic 4 30.0
element TripleFrictionPendulum 1 1 2 1 2 3 1 2 3 4 0.36 1.25 1.25 0.1 0.2 0.2 900.0 0.001 1.0 1.0 1e-8

fix 2 0 0 0 1 1 1
mass 2 90 90 90 1 1 1
timeSeries Linear 1
pattern Plain 1 1 { load 2 0 0 -900.0 0 0 0 }
constraints Plain
numberer Plain
system FullGeneral
test NormDispIncr 1e-10 100
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10]!=0} { puts "gravity failed"; exit 1}
loadConst -time 0.0
wipeAnalysis
set xs {}; set ys {}; set zs {}
for {set i 0} {$i<=400} {incr i} {
 set t [expr {0.02*$i}]
 lappend xs [expr {2.0*sin(2.5*$t)+2.0*sin(9.1*$t)+1.0*sin(17.3*$t)}]
 lappend ys [expr {1.5*sin(3.1*$t+1)+1.5*sin(11.0*$t)}]
 lappend zs [expr {3.0*sin(23.0*$t)}]
}
timeSeries Path 2 -dt 0.02 -values $xs
timeSeries Path 3 -dt 0.02 -values $ys
timeSeries Path 4 -dt 0.02 -values $zs
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 4 3 -accel 4
pattern UniformExcitation 3 2 -accel 3

recorder Element -file force.out -precision 12 -time -ele 1 force
recorder Node -file disp.out -precision 12 -time -node 2 -dof 1 2 3 4 5 6 disp
recorder Element -file compDisplacement.out -precision 12 -time -ele 1 compDisplacement
constraints Plain
numberer Plain
system FullGeneral
test NormDispIncr 1e-11 200
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 0} {$i<800} {incr i} { if {[analyze 1 0.005]!=0} { puts "failed $i"; break } }
wipe
