# two-storey portal frame, series onyx
wipe
model basic -ndm 2 -ndf 3
set rE 0.9790627
set aM 0.5334391
node 1 0.0 0.0
node 2 6.0 0.0
node 3 0.0 3.5 -mass 30.0 30.0 0.0
node 4 6.0 3.5 -mass 30.0 30.0 0.0
node 5 0.0 7.0 -mass 24.0 24.0 0.0
node 6 6.0 7.0 -mass 24.0 24.0 0.0
fix 1 1 1 1
fix 2 1 1 1
geomTransf PDelta 1
set E [expr $rE*2.5e7]
# columns
element elasticBeamColumn 1 1 3 0.16 $E 0.00213 1
element elasticBeamColumn 2 2 4 0.16 $E 0.00213 1
element elasticBeamColumn 3 3 5 0.16 $E 0.00213 1
element elasticBeamColumn 4 4 6 0.16 $E 0.00213 1
# beams
element elasticBeamColumn 5 3 4 0.18 $E 0.0054 1
element elasticBeamColumn 6 5 6 0.18 $E 0.0054 1
rayleigh $aM 0.0 0.0 0.0008
uniaxialMaterial ViscousDamper 9 60000.0 30.0 0.45
element twoNodeLink 9 1 4 -mat 9 -dir 1
element twoNodeLink 10 3 6 -mat 9 -dir 1
# weight
timeSeries Linear 1
pattern Plain 1 1 {
    load 3 0.0 -294.0 0.0
    load 4 0.0 -294.0 0.0
    load 5 0.0 -235.0 0.0
    load 6 0.0 -235.0 0.0
}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-10 20
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis

timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
recorder Node -file acc.out -timeSeries 2 -time -node 3 5 -dof 1 accel
recorder Node -file disp.out -time -node 3 5 -dof 1 disp
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 2 [expr $dt/2.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 2 [expr $dt/2.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
