# Timber wall panel with nailed sheathing, shear against drift
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset Vy 40.0
pset dy 9.0
pset px 0.75

uniaxialMaterial Hysteretic 1 $Vy $dy [expr 1.35*$Vy] [expr 3.0*$dy] [expr 1.45*$Vy] [expr 8.0*$dy] \
    [expr -$Vy] [expr -$dy] [expr -1.35*$Vy] [expr -3.0*$dy] [expr -1.45*$Vy] [expr -8.0*$dy] $px 0.3 0.0 0.04 0.25
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-9 50
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
