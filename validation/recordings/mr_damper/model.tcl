# A magnetorheological damper: Bouc-Wen beside a dashpot and a spring (Spencer, Dyke, Sain and Carlson, 1997). The voltage is
# random in the test and unknown to this model.
# Units: N, mm, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
mass 2 1.0e-6

pset Fz 500.0    ;# yield force
pset uz 0.1      ;# displacement at which it is reached
pset c0 1.0      ;# N s/mm
pset k0 1.0      ;# accumulator, N/mm

uniaxialMaterial BoucWen 1 0.0 [expr {$Fz/$uz}] 1.0 [expr {0.5/$uz}] [expr {0.5/$uz}] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 2 $c0 1.0
uniaxialMaterial Elastic 3 $k0
element zeroLength 1 1 2 -mat 1 2 3 -dir 1 1 1

timeSeries Path 1 -dt $dt -filePath $motion -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force

# Under Penalty the imposed displacement has a velocity, which the dashpot needs.
constraints Penalty 1.0e9 1.0e9
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-7 50
algorithm Newton
# Under imposed displacements the usual Newmark lets velocity ring from step to step; this one forgets within a few.
integrator Newmark 1.0 1.0
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
