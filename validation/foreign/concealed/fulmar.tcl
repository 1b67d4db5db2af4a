# floor of a computer hall on sliders, series fulmar
# floor of a computer hall: flat sliders and a centring spring            N, m, kg
wipe
model basic -ndm 2 -ndf 3
set mu 0.04729746
set ks 31215.89
set M 5400.
node 1 0. 0.
node 2 0. 0. -mass $M $M 0.
fix 1 1 1 1
fix 2 0 0 1
frictionModel Coulomb 1 $mu
uniaxialMaterial Elastic 1 5.0e8
uniaxialMaterial Elastic 2 1.0e3
uniaxialMaterial Elastic 3 $ks 500.
element flatSliderBearing 1 1 2 1 8.0e5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0 -iter 50 1e-12
element zeroLength 2 1 2 -mat 3 -dir 1
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0. [expr -9.81*$M] 0.
}
proc integrate {what args} {
    constraints Plain
    numberer Plain
    system FullGeneral
    test NormDispIncr 1.0e-10 60
    algorithm Newton
    eval integrator $args
    analysis $what
}
integrate Static LoadControl 0.5
analyze 2
loadConst -time 0.
wipeAnalysis
timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
recorder Node -file untimed.txt -node 2 -dof 2 1 disp
recorder Node -file floor.txt -timeSeries 2 -time -node 2 -dof 1 accel
integrate Transient HHT 0.95
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "step $i"}
}
