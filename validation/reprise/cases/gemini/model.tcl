# Three-storey frame on two lines of isolators
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 3000000.0
pset Qd 300000.0
pset rE 1.0     ;# rigidity of the frame / drawing value
node 1 0.0 0
mass 1 70000.0 70000.0 2000.0
node 2 7.0 0
mass 2 70000.0 70000.0 2000.0
node 3 0.0 3.4
mass 3 60000.0 60000.0 2000.0
node 4 7.0 3.4
mass 4 60000.0 60000.0 2000.0
node 5 0.0 6.8
mass 5 60000.0 60000.0 2000.0
node 6 7.0 6.8
mass 6 60000.0 60000.0 2000.0
node 7 0.0 10.2
mass 7 52000.0 52000.0 2000.0
node 8 7.0 10.2
mass 8 52000.0 52000.0 2000.0
geomTransf Linear 1
element elasticBeamColumn 10 1 3 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 11 2 4 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 20 3 5 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 21 4 6 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 30 5 7 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 31 6 8 0.25 [expr $rE*30000000000.0] 5.2e-3 1
element elasticBeamColumn 15 1 2 0.3 [expr $rE*30000000000.0] 0.03 1
element elasticBeamColumn 25 3 4 0.3 [expr $rE*30000000000.0] 0.009 1
element elasticBeamColumn 35 5 6 0.3 [expr $rE*30000000000.0] 0.009 1
element elasticBeamColumn 45 7 8 0.3 [expr $rE*30000000000.0] 0.009 1
rayleigh 0.1 0.0 0.0025 0.0
# isolators
set ki [expr 0.5*$Kd/0.1]
set uy [expr 0.5*$Qd/((1.0-0.1)*$ki)]
uniaxialMaterial BoucWen 1 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
uniaxialMaterial Elastic 2 1.5e9
node 101 0.0 0.0
node 102 7.0 0.0
fix 101 1 1 1
fix 102 1 1 1
element zeroLength 101 101 1 -mat 1 2 -dir 1 2
element zeroLength 102 102 2 -mat 1 2 -dir 1 2

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 1 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 1 5 7 -dof 1 accel

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set sub 1
if {[info exists nsub]} {set sub $nsub}
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze $sub [expr $dt/double($sub)]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze $sub [expr $dt/double($sub)]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
