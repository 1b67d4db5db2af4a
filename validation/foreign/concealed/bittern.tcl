# industrial frame with two braces, series bittern
# Industrial frame, two braced bays, pinned columns          [N, mm, t, s]
wipe; model basic -ndm 2 -ndf 3
set rA 0.9606112
set fy 295.8187
set aM 0.3855649
set E 2.05e5
set A [expr 1750.0*$rA]

set x {0.0 6000.0 12000.0}
foreach n {1 2 3} X $x {
    node $n $X 0.0
    node 1$n $X 4200.0 -mass 34.0 34.0 0.0
    fix $n 1 1 1
    fix 1$n 0 0 1
}
uniaxialMaterial Elastic 1 $E
uniaxialMaterial Steel02 2 $fy $E 0.01 18.0 0.925 0.15
foreach n {1 2 3} {element truss $n $n 1$n 9100.0 1}      ;# columns
element truss 4 11 12 6000.0 1                            ;# struts
element truss 5 12 13 6000.0 1
geomTransf Corotational 9
set b [expr $A/280.0]
section Fiber 9 {
    patch rect 2 10 1 -140.0 [expr -$b/2.0] 140.0 [expr $b/2.0]
}
foreach {e i x0} {21 1 0.0 22 3 12000.0} {
    for {set k 1} {$k <= 5} {incr k} {
        set s [expr ($k-1)/4.0]
        set off [expr 7.3*sin(3.14159265*$s)]
        node [expr 100*$e+$k] [expr $x0+$s*(6000.0-$x0)] [expr 4200.0*$s+$off]
    }
    equalDOF $i [expr 100*$e+1] 1 2
    equalDOF 12 [expr 100*$e+5] 1 2
    for {set k 1} {$k <= 4} {incr k} {
        set tag [expr $k==1 ? $e : 100*$e+$k]
        element forceBeamColumn $tag [expr 100*$e+$k] [expr 100*$e+$k+1] 3 9 9
    }
}
rayleigh $aM 0.0 0.0 0.0006

timeSeries Path 1 -dt $dt -filePath $motion -factor 1000.0
pattern UniformExcitation 1 1 -accel 1
recorder Node -file roof.out -time -node 12 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 12 -dof 1 accel
recorder Element -file brace1.out -time -ele 21 basicForce
recorder Element -file brace2.out -time -ele 22 basicForce

constraints Transformation; numberer RCM; system UmfPack
test NormDispIncr 1.0e-7 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 4 [expr $dt/4.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 40 [expr $dt/40.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at $i"}
}
