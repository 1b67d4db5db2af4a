# A post-tensioned rocking timber wall as a bilinear hysteretic spring (Steel01).
# Units: kN, mm; no times in the source, a sample a second.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset k  4.0    ;# kN/mm
pset Fy 60.0    ;# kN
pset b  0.2

uniaxialMaterial Steel01 1 $Fy $k $b
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
