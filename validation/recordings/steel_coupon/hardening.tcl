# A steel coupon under cyclic strain, bilinear (kinematic hardening).
# Units: MPa and strain.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset E  200000.0
pset Fy 400.0
pset b  0.01

uniaxialMaterial Steel01 1 $Fy $E $b
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-10 50
algorithm Newton
integrator LoadControl $dt
analysis Static
if {[analyze [expr {$npts-1}]] != 0} {error "no convergence at [getTime]"}
