# industrial frame with two braces, series bittern
# Industrial frame, two braced bays, pinned columns          [N, mm, t, s]
wipe; model basic -ndm 2 -ndf 2
pset rA 0.8955805
pset fy 371.5963
pset aM 0.3781868
set E 2.05e5
set A [expr 1750.0*$rA]

set x {0.0 6000.0 12000.0}
foreach n {1 2 3} X $x {
    node $n $X 0.0
    node 1$n $X 4200.0 -mass 34.0 34.0
    fix $n 1 1
}
uniaxialMaterial Elastic 1 $E
uniaxialMaterial Steel02 2 $fy $E 0.01 18.0 0.925 0.15
foreach n {1 2 3} {element truss $n $n 1$n 9100.0 1}      ;# columns
element truss 4 11 12 6000.0 1                            ;# struts
element truss 5 12 13 6000.0 1
element corotTruss 21 1 12 $A 2                           ;# braces
element corotTruss 22 3 12 $A 2
rayleigh $aM 0.0 0.0 0.0006

timeSeries Path 1 -dt $dt -filePath $motion -factor 1000.0
pattern UniformExcitation 1 1 -accel 1
recorder Node -file roof.out -time -node 12 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 12 -dof 1 accel
recorder Element -file brace1.out -time -ele 21 axialForce
recorder Element -file brace2.out -time -ele 22 axialForce

constraints Plain; numberer RCM; system BandGeneral
test NormDispIncr 1.0e-7 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at $i"}
}
