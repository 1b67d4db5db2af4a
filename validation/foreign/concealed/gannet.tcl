# hotel and annex side by side, series gannet
# Hotel (3 storeys) and its annex (2 storeys), stick models side by side. kip-in-sec
wipe
model basic -ndm 1 -ndf 1
set kH 432.7895
set kA 777.2803
set g 386.1

proc stick {first weights stiffness ratios eta} {
    global g
    node $first 0.0
    fix $first 1
    set below $first
    foreach W $weights r $ratios {
        set n [expr $below+1]
        node $n 0.0 -mass [expr $W/$g]
        uniaxialMaterial Elastic $n [expr $r*$stiffness] [expr $eta*$r*$stiffness]
        element zeroLength $n $below $n -mat $n -dir 1
        set below $n
    }
}
stick 100 {520.0 520.0 440.0} $kH {1.0 0.9 0.75} 0.008
stick 200 {300.0 260.0}       $kA {1.0 0.8}      0.004

uniaxialMaterial ImpactMaterial 900 1500.0 600.0 -0.05 -2.6
element zeroLength 900 102 202 -mat 900 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion -factor $g
pattern UniformExcitation 1 1 -accel 1
recorder Node -file hotel.out -timeSeries 1 -time -node 102 103 -dof 1 accel
recorder Node -file annex.out -timeSeries 1 -time -node 202 -dof 1 accel
recorder Node -file disp.out -time -node 103 202 -dof 1 disp
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 5 [expr $dt/5.0]]} {error "no convergence at [getTime]"}
}
