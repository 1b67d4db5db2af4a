# A steel coupon under cyclic strain: Giuffré-Menegotto-Pinto with isotropic hardening (Filippou et al., 1983).
# Units: MPa and strain.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 1.0
fix 1 1

pset Fy  400.0
pset E0  200000.0
pset b   0.01
pset R0  18.0
pset cR1 0.9
pset a1  0.02

uniaxialMaterial Steel02 1 $Fy $E0 $b $R0 $cR1 0.15 $a1 1.0 $a1 1.0
element truss 1 1 2 1.0 1

timeSeries Path 1 -dt 1.0 -filePath $motion -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file stress.out -time -ele 1 axialForce

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-10 50
algorithm Newton
integrator LoadControl 1.0
analysis Static
if {[analyze [expr {$npts-1}]] != 0} {error "no convergence at [getTime]"}
