# clinic of two unequal storeys, series heron
# clinic on isolators: soft ground floor 4.8 m, upper floor 3.2 m; plane model.   kN, cm, s
wipe
model basic -ndm 2 -ndf 3
set Fy 371.0331
set Kd 46.82453
set rI 1.12021
set g 981.0
proc floor {n y W} {
    upvar g g
    node $n 0.0 $y -mass [expr $W/$g] [expr $W/$g] 0.0
    fix $n 0 1 1
}
node 1 0.0 0.0
fix 1 1 1 1
floor 2   0.0 2900.0
floor 3 480.0 2500.0
floor 4 800.0 2100.0
# isolation layer: rubber and steel dampers side by side
uniaxialMaterial Elastic   1 $Kd
uniaxialMaterial Steel02 2 $Fy [expr 9.0*$Kd] 0.002 12.0 0.9 0.15
uniaxialMaterial Parallel  3 1 2
element zeroLength 1 1 2 -mat 3 -dir 1
geomTransf Linear 1
# eight columns in one
set I [expr 8*$rI*1.6e5]
element elasticBeamColumn 2 2 3 12800.0 2900.0 $I 1
element elasticBeamColumn 3 3 4 12800.0 2900.0 $I 1
region 1 -ele 2 3 -rayleigh 0.0 0.0 0.004 0.0
timeSeries Path 1 -dt $dt -filePath $motion -factor 100.0
pattern UniformExcitation 1 1 -accel 1
recorder Node -file rows.txt -node 1 2 3 4 -dof 1 disp
recorder Node -file acc.txt -timeSeries 1 -time -node 2 3 4 -dof 1 accel
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
