# Two links side by side between rigid heads
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset Fy 75.0    ;# link a
pset E0 28.0
pset b  0.03
pset Qf 20.0    ;# link b

uniaxialMaterial Steel02 1 $Fy $E0 $b 18.0 0.9 0.14
set uy [expr $Qf/(0.99*18.0)]
uniaxialMaterial BoucWen 2 0.01 18.0 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1
element zeroLength 2 1 2 -mat 2 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file forcea.out -time -ele 1 force
recorder Element -file forceb.out -time -ele 2 force

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
