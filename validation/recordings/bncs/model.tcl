# Five-storey building on high-damping-rubber bearings as a design office would model it: a shear building on one bilinear spring.
# Masses are taken as equal, 75 t a level (the source tells none), so forces are those of a building of 450 t.
# Units: kN, m, t, s.
wipe
model basic -ndm 1 -ndf 1

pset k0 20000.0   ;# initial stiffness of the isolators, kN/m
pset Fy 150.0     ;# their yield force, kN
pset b  0.15      ;# stiffness after yielding over the initial one
pset ks 250000.0  ;# stiffness of a storey, kN/m
pset cs 500.0     ;# its damping, kN s/m

for {set i 1} {$i <= 7} {incr i} {node $i 0.0}
fix 1 1
for {set i 2} {$i <= 7} {incr i} {mass $i 75.0}
uniaxialMaterial Steel01 1 $Fy $k0 $b
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
