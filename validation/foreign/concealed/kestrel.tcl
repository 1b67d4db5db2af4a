# office block with a damper, series kestrel
# office block: storeys as twoNodeLink, viscous damper in the first storey.  SI (N, m, kg)
wipe
model basic -ndm 2 -ndf 3
set k1 5.415903e+07
set cd 186975.5
array set m {1 82.0e3 2 82.0e3 3 64.0e3}
array set r {1 1.00 2 0.85 3 0.70}
array set z {0 0.0 1 4.0 2 7.2 3 10.4}
node 0 0.0 $z(0)
fix 0 1 1 1
foreach s {1 2 3} {
    node $s 0.0 $z($s) -mass $m($s) $m($s) 0.0
    fix $s 0 1 1
    set below [expr $s - 1]
    uniaxialMaterial Elastic $s [expr $r($s)*$k1]
    element twoNodeLink $s $below $s -mat $s -dir 2 -doRayleigh
}
uniaxialMaterial ViscousDamper 9 9.0e7 $cd 0.6
element twoNodeLink 9 0 1 -mat 9 -dir 2
rayleigh 0.35 0.0 0.0009 0.0
timeSeries Trig 5 0.0 1000.0 0.2941
pattern Plain 5 5 {
    load 2 9.0e4 0.0 0.0
}
# shaking
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file acc.txt -timeSeries 1 -time -node 1 2 3 -dof 1 accel
recorder Node -file roof.txt -time -node 3 -dof 1 disp
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 30
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
