# The same frame on four bearings, a linear spring and a dashpot. The base has the mass of a level.
# Storeys have the values that the fixed-base tests gave. Units: in, s; a level has the mass 1.
wipe
model basic -ndm 1 -ndf 1

pset kb 60.0   ;# stiffness of the bearings over the mass of a level, 1/s2
pset cb 4.0    ;# their damping over that mass, 1/s
set k1 499.0
set k2 330.0
set k3 262.0
set beta 0.0075

for {set i 1} {$i <= 5} {incr i} {node $i 0.0}
fix 1 1
for {set i 2} {$i <= 5} {incr i} {mass $i 1.0}
uniaxialMaterial Elastic 10 $kb $cb
element zeroLength 10 1 2 -mat 10 -dir 1 -doRayleigh 0
foreach i {1 2 3} k [list $k1 $k2 $k3] {
    uniaxialMaterial Elastic $i $k [expr {$beta*$k}]
    element zeroLength $i [expr {$i+1}] [expr {$i+2}] -mat $i -dir 1 -doRayleigh 0
}

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Element -file drift.out -time -ele 1 2 3 deformation
recorder Node -file slip.out -time -node 2 -dof 1 disp
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
