# Two supports that move differently: one by its acceleration, which is integrated, one by its displacement alone, which has
# no velocity in OpenSees. Stiffness-proportional damping and consistent mass feel the difference.
# Units: kN, m, t, s.
model basic -ndm 2 -ndf 3
node 1 0.0 0.0
node 2 5.0 0.0
node 3 0.0 4.0 -mass 2.0 2.0 0.1
node 4 5.0 4.0 -mass 3.0 3.0 0.1
fix 1 1 1 1
fix 2 1 1 1
geomTransf Linear 1
foreach {e i j} {1 1 3 2 2 4 3 3 4} {element elasticBeamColumn $e $i $j 0.02 2.0e7 1.0e-4 1 -mass 0.3 -cMass}
timeSeries Trig 1 0.0 3.0 0.5 -factor 1.5
timeSeries Trig 2 0.0 3.0 0.9 -factor 0.01
pattern MultipleSupport 1 {
    groundMotion 1 Plain -accel 1
    groundMotion 2 Plain -disp 2
    imposedMotion 1 1 1
    imposedMotion 2 1 2
}
rayleigh 0.3 0.0 0.001 0.0
recorder Node -file disp.out -precision 10 -time -node 1 2 3 4 -dof 1 2 3 disp
recorder Node -file vel.out -precision 10 -time -node 1 2 3 4 -dof 1 vel
recorder Node -file accel.out -precision 10 -time -node 1 2 3 4 -dof 1 accel
recorder Node -file reaction.out -precision 10 -time -node 1 2 -dof 1 2 3 reaction
recorder Element -file force.out -precision 10 -time -ele 1 2 3 force
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-12 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze 70 0.02] != 0} {puts "failed"}
wipe
