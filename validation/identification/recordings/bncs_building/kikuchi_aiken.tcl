# The building of model.tcl on one spring of Kikuchi and Aiken's law for high-damping rubber (KikuchiAikenHDR, compound X0.6), whose stiffness
# and strength follow the amplitude: area and thickness of the rubber, and the factors on modulus, damping and shape.
# Units: kN, m, t, s; the law itself is in N, hence the area in square metres over 1000.
wipe
model basic -ndm 2 -ndf 3

pset area 0.5    ;# m2, of all isolators
pset height 0.15 ;# m of rubber
pset cg 1.0      ;# factor on the modulus
pset ch 1.0      ;# on the equivalent damping
pset cu 1.0      ;# on the ratio of the force at zero displacement
pset ks     250000.0  ;# stiffness of a storey, kN/m
pset cs     500.0     ;# its damping, kN s/m

for {set i 1} {$i <= 7} {incr i} {node $i 0.0 0.0}
fix 1 1 1 1
for {set i 2} {$i <= 7} {incr i} {
    fix $i 0 1 1
    mass $i 75.0 75.0 1.0
}
uniaxialMaterial KikuchiAikenHDR 1 X0.6 [expr {$area/1000.0}] $height -coGHU $cg $ch $cu
element zeroLength 1 1 2 -mat 1 -dir 1
uniaxialMaterial Elastic 2 $ks
uniaxialMaterial Viscous 3 $cs 1.0
for {set i 2} {$i <= 6} {incr i} {
    element zeroLength $i $i [expr {$i+1}] -mat 2 3 -dir 1 1
}

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 7 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 7 -dof 1 accel

constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
