# Timber-to-steel joint, in-plane
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset My   36.0
pset K0   6.0
pset rp   0.5      ;# force level of reloading
pset hard 0.05

set e1 [expr $My/$K0]
set e2 60.0
set s2 [expr $My + $hard*$K0*($e2-$e1)]
uniaxialMaterial Hysteretic 1 $My $e1 $s2 $e2 [expr -$My] [expr -$e1] [expr -$s2] [expr -$e2] 0.7 $rp 0.0 0.0 0.25
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-10 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
