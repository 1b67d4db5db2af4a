# bridge pier with a pendulum, series linnet
# Transverse model of pier 4: a round column and a pendulum under the deck.      kN, m, t
wipe
model basic -ndm 3 -ndf 6
set mu 0.07337728
set R  1.965121
set rE 0.8885715
set W 2400.0                             ;# weight on the pendulum
node 11 0 0 0                            ;# footing
node 21 0 0 7.5                          ;# column top
node 31 0 0 7.5                          ;# slider
fix 11 1 1 1 1 1 1
fix 21 1 0 0 0 1 1
fix 31 1 0 0 1 1 1
mass 21 0.0 44.0 44.0 0.0 0.0 0.0
mass 31 0.0 [expr $W/9.81] [expr $W/9.81] 0.0 0.0 0.0
geomTransf PDelta 1 1 0 0
element elasticBeamColumn 1 11 21 1.13 [expr $rE*3.1e7] 1.3e7 0.2 0.07 0.07 1
uniaxialMaterial Elastic 1 4.0e5
uniaxialMaterial Elastic 2 10.0
element FPBearingPTV 4 21 31 $mu 0 30000.0 1 4.44e-6 0.018 1 20. $R 0.175 6000. 1 2 2 2 0 0 1 1 0 0 0 0 0. 15 1e-6 2
rayleigh 0.2 0.0 0.0 0.001
# dead load
timeSeries Linear 1
pattern Plain 1 1 {
    load 31 0 0 [expr -$W] 0 0 0
}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-9 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 10
loadConst -time 0.0
wipeAnalysis
# earthquake
timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 2 -accel 2
recorder Node -file deck.out -time -node 31 21 -dof 2 disp
recorder Node -file acc.out -timeSeries 2 -time -node 31 -dof 2 accel
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-6 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1 $dt]
    if {$ok != 0} {error "no convergence at [getTime]"}
}
