# wall under cyclic shear, series nephrite
wipe
model basic -ndm 1 -ndf 1
set Fy 300
set K 50000
set r 0.03
node 1 0.0
node 2 0.0
fix 1 1
set u [expr 1.0*$Fy/$K]
set F2 [expr $Fy*(1.0+7.0*$r)]
set F3 [expr $Fy*(1.0+20.0*$r)]
uniaxialMaterial Hysteretic 1 $Fy $u $F2 [expr 8.0*$u] $F3 [expr 21.0*$u] -$Fy -$u -$F2 [expr -8.0*$u] -$F3 [expr -21.0*$u] 0.75 0.25 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
constraints Penalty 1e10 1e10
numberer RCM
system FullGeneral
test NormDispIncr 1e-9 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1] != 0} {error "no convergence at [getTime]"}
}
