# frame of one bay on four bearings, series egret
# One-storey frame of one bay on four rubber bearings, kN m t s
wipe
model basic -ndm 3 -ndf 6
set Qd 8.850571
set k2 174.5652
set rI 1.021375

set corners {1 0.0 0.0  2 7.2 0.0  3 7.2 5.4  4 0.0 5.4}
uniaxialMaterial Elastic 1 2.0e6
uniaxialMaterial Elastic 2 5.0e3
geomTransf Linear 1 1.0 0.0 0.0
geomTransf Linear 2 0.0 0.0 1.0
set E 3.0e7
foreach {c x y} $corners {
    node $c    $x $y -0.30          ;# pedestal
    node 10$c  $x $y  0.00          ;# above the bearing
    node 20$c  $x $y  3.60          ;# roof
    fix $c   1 1 1 1 1 1
    fix 10$c 0 0 1 1 1 0            ;# grid of ground beams is stiff
    fix 20$c 0 0 1 0 0 0
    element elastomericBearingPlasticity $c $c 10$c [expr 10.0*$k2] $Qd 0.1 0.0 2.0 -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
    element elasticBeamColumn 5$c 10$c 20$c 0.16 $E 1.25e7 0.0036 [expr $rI*0.00213] [expr $rI*0.00213] 1
}
foreach {b i j} {61 201 202  62 202 203  63 203 204  64 204 201} {
    element elasticBeamColumn $b $i $j 0.15 $E 1.25e7 0.003 0.002 0.0045 2
}
# floors
node 100 3.6 2.7 0.0
node 200 3.6 2.7 3.6
fix 100 0 0 1 1 1 0
fix 200 0 0 1 1 1 0
rigidDiaphragm 3 100 101 102 103 104
rigidDiaphragm 3 200 201 202 203 204
mass 100 42.0 42.0 0.0 0.0 0.0 285.0
mass 200 36.0 36.0 0.0 0.0 0.0 245.0
rayleigh 0.15 0.0 0.0 0.0012

timeSeries Path 1 -dt $dt -filePath $motion
timeSeries Path 2 -dt $dt -filePath $second
foreach d {1 2} {pattern UniformExcitation $d $d -accel $d}
recorder Node -file x.out -timeSeries 1 -time -node 101 203 -dof 1 accel
recorder Node -file y.out -timeSeries 2 -time -node 101 203 -dof 2 accel
recorder Node -file u.out -time -node 101 102 -dof 1 2 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-10 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence at $i"}
}
