# A hydraulic damper as a symmetric power law of velocity.
# Units: N, mm, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
mass 2 1.0e-6

pset C 30.0    ;# N (s/mm)^alpha
pset alpha 0.5

uniaxialMaterial Viscous 1 $C $alpha
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force

# Under Penalty the imposed displacement has a velocity, which the damper needs.
constraints Penalty 1.0e9 1.0e9
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-7 50
algorithm Newton
# Under imposed displacements the usual Newmark lets velocity ring from step to step; this one forgets within a few.
integrator Newmark 1.0 1.0
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
