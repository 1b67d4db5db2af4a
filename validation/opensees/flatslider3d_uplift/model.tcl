# flatSliderBearing in space under strong vertical ground motion: lifts off and lands.
# Units: kN, m, s
model BasicBuilder -ndm 3 -ndf 6
node 1 0 0 0
node 2 0 0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 0 0 1 1 1
mass 2 90 90 90 1 1 1
frictionModel Coulomb 1 0.06
uniaxialMaterial Elastic 1 1.0e6 500.0
uniaxialMaterial Elastic 2 100.0
uniaxialMaterial Elastic 3 2500.0
uniaxialMaterial Elastic 4 1800.0
uniaxialMaterial ElasticPP 5 400.0 0.05
uniaxialMaterial Elastic 6 300.0

element flatSliderBearing 1 1 2 1 20000.0 -P 1 -T 2 -My 3 -Mz 4  -mass 3.0 -iter 60 1e-11 -shearDist 0.5
timeSeries Linear 1
pattern Plain 1 1 { load 2 0 0 -900.0 0 0 0 }
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-12 100
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10]!=0} { puts "gravity failed"; exit 1}
loadConst -time 0.0
wipeAnalysis

set xs {}; set ys {}; set zs {}
expr srand(17)
for {set i 0} {$i<=400} {incr i} {
 set t [expr {0.02*$i}]
 lappend xs [expr {3.0*sin(4.0*$t)+2.0*sin(9.1*$t)+2.0*sin(17.3*$t)}]
 lappend ys [expr {2.5*sin(3.1*$t+1)+1.5*sin(11.0*$t)+1.0*sin(21.3*$t)}]
 lappend zs [expr {12.5*sin(23.0*$t)}]
}
timeSeries Path 2 -dt 0.02 -values $xs
timeSeries Path 3 -dt 0.02 -values $ys
timeSeries Path 4 -dt 0.02 -values $zs
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 4 3 -accel 4
pattern UniformExcitation 3 2 -accel 3

recorder Element -file force.out -precision 12 -time -ele 1 force
recorder Node -file disp.out -precision 12 -time -node 2 -dof 1 2 3 4 5 6 disp
recorder Element -file fr_normalForce.out -precision 12 -ele 1 frictionModel normalForce
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-13 300
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 0} {$i<800} {incr i} { if {[analyze 1 0.005]!=0} { puts "failed $i"; break } }
wipe
