# A strip of acrylic polymer in tension: stiff at first, softer from a knee on, elastic (neither rate nor loss).
# Units: N, mm, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset k1 0.03    ;# N/mm
pset k2 0.005   ;# beyond the knee
pset uk 20.0    ;# mm

uniaxialMaterial ElasticBilin 1 $k1 $k2 $uk
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
if {[analyze [expr {$npts-1}]] != 0} {error "no convergence at [getTime]"}
