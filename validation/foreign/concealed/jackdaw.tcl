# viaduct of four spans, series jackdaw
# Viaduct of four spans, along its axis. Units MN, m, 1000 t
wipe
model basic -ndm 2 -ndf 3
set Fy 0.561018
set kd 5.03744
set ka 2.51872
set Ec 3.3e4
geomTransf Linear 1
set stations {0.0 42.0 92.0 142.0 184.0}
set masses   {0.32 0.66 0.74 0.66 0.32}
set i 0
foreach x $stations m $masses {
    incr i
    node 20$i $x 0.0
    mass 20$i $m $m 0.0
    fix 20$i 0 1 1
    if {$i > 1} {element elasticBeamColumn 30$i 20[expr $i-1] 20$i 6.2 $Ec 4.0 1}
}
uniaxialMaterial Steel02 1 $Fy [expr 8.0*$kd] 0.125 15.0 0.925 0.15
# piers
foreach p {2 3 4} x {42.0 92.0 142.0} h {11.0 16.0 13.0} {
    node 1$p $x [expr -$h]
    node 10$p $x 0.0 -mass 0.14 0.14 0.0
    fix 10$p 0 1 0
    node 5$p $x [expr -$h]
    fix 5$p 1 1 1
    fix 1$p 0 1 0
    mass 1$p 0.25 0.25 3.0
    uniaxialMaterial Elastic 5$p 9000.0 60.0
    uniaxialMaterial Elastic 6$p 3.2e5 800.0
    element zeroLength 5$p 5$p 1$p -mat 5$p 6$p -dir 1 6
    element elasticBeamColumn $p 1$p 10$p 4.6 $Ec 1.9 1
    element zeroLength 40$p 10$p 20$p -mat 1 -dir 1
}
uniaxialMaterial ElasticMultiLinear 7 0.0 -strain -0.6 -0.12 -0.07 0.0 0.07 0.12 0.6 -stress -7.480598 -0.2266848 0.0 0.0 0.0 0.2266848 7.480598
foreach p {2 3 4} {element zeroLength 70$p 10$p 20$p -mat 7 -dir 1}
# abutments: rubber strips and backfill as one spring
uniaxialMaterial Elastic 2 $ka 0.6
foreach a {1 5} x {0.0 184.0} {
    node 1$a $x 0.0
    fix 1$a 1 1 1
    element zeroLength 40$a 1$a 20$a -mat 2 -dir 1
}
rayleigh 0.2 0.0 0.0015 0.0
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file piers.out -time -node 102 103 -dof 1 disp
recorder Node -file deck.out -time -node 203 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 103 203 -dof 1 accel
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-9 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at [getTime]"}
}
