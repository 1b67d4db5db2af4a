# Three-storey steel frame on a shake table, as a shear building. A level has the mass 1, so that a stiffness is one over s2.
# Units: in, s.
wipe
model basic -ndm 1 -ndf 1

pset k1   400.0   ;# stiffness of the first storey over the mass of a level, 1/s2
pset k2   400.0   ;# of the second
pset k3   400.0   ;# of the third
pset beta 0.002   ;# damping per stiffness, s

for {set i 1} {$i <= 4} {incr i} {node $i 0.0}
fix 1 1
for {set i 2} {$i <= 4} {incr i} {mass $i 1.0}
foreach i {1 2 3} k [list $k1 $k2 $k3] {
    uniaxialMaterial Elastic $i $k [expr {$beta*$k}]
    element zeroLength $i $i [expr {$i+1}] -mat $i -dir 1 -doRayleigh 0
}

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Element -file drift.out -time -ele 1 2 3 deformation
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
