# A five-storey building on high-damping-rubber bearings: a shear building on one Bouc-Wen spring with hardening
# (elastomericBearingBoucWen: F = hysteresis + alpha1 k u + alpha2 k sgn(u) |u|^mu). Masses are taken as equal, 75 t a level, so
# forces are those of a building of 450 t; ratios of stiffness to mass are what the recordings determine.
# Units: kN, m, t, s.
wipe
model basic -ndm 2 -ndf 3

pset k0     30000.0   ;# initial stiffness of the isolators, kN/m
pset Qd     200.0     ;# their characteristic strength, kN
pset alpha1 0.08
pset alpha2 0.05
pset mu     3.0
pset ks     250000.0  ;# stiffness of a storey, kN/m
pset cs     500.0     ;# its damping, kN s/m

for {set i 1} {$i <= 7} {incr i} {node $i 0.0 0.0}
fix 1 1 1 1
for {set i 2} {$i <= 7} {incr i} {
    fix $i 0 1 1
    mass $i 75.0 75.0 1.0
}
uniaxialMaterial Elastic 1 1.0e8
element elastomericBearingBoucWen 1 1 2 $k0 $Qd $alpha1 $alpha2 $mu 1.0 0.5 0.5 -P 1 -Mz 1 -orient 0 1 0 -1 0 0
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
