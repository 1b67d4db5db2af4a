# The band brake with its backlash, in series; friction does not depend on speed.
# Units: kN, mm, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset Fp 13.0    ;# friction in the positive direction
pset Fn 17.0    ;# and in the negative one
pset ko 20.0    ;# spring in series
pset gap 3.0    ;# half of the backlash
pset kr 0.05    ;# what is left within it

uniaxialMaterial ElasticPP 1 $ko [expr {$Fp/$ko}] [expr {-$Fn/$ko}]
uniaxialMaterial ElasticPPGap 11 $ko  1.0e4  $gap
uniaxialMaterial ElasticPPGap 12 $ko -1.0e4 [expr {-$gap}]
uniaxialMaterial Elastic 13 $kr
uniaxialMaterial Parallel 2 11 12 13
uniaxialMaterial Series 3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1

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
