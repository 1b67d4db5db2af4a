# A high damping rubber bearing under imposed shear, as a bilinear spring.
# Units: tonf, cm. The clock counts samples: the speed of the test is not known.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset Fy 6.0   ;# tonf
pset Ke 8.0   ;# tonf/cm
pset b 0.15   ;# hardening

uniaxialMaterial Steel01 1 $Fy $Ke $b
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
