# A band brake as a plain friction damper: a spring and friction of different size in the two directions. No backlash.
# Units: kN, mm, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset Fp 13.0    ;# friction in the positive direction
pset Fn 17.0    ;# and in the negative one
pset ko 20.0    ;# spring in series

uniaxialMaterial ElasticPP 1 $ko [expr {$Fp/$ko}] [expr {-$Fn/$ko}]
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
