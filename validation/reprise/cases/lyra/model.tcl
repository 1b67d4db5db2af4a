# Control tower, shaft as a stick
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset rE 1.0       ;# flexural rigidity / drawing value
pset bk 0.003     ;# damping, share of the stiffness
node 1 0.0 0.0
fix 1 1 1 1
node 2 0.0 6.0
mass 2 92000.0 92000.0 184000.0
node 3 0.0 12.0
mass 3 92000.0 92000.0 184000.0
node 4 0.0 18.0
mass 4 92000.0 92000.0 184000.0
node 5 0.0 24.0
mass 5 92000.0 92000.0 184000.0
node 6 0.0 30.0
mass 6 92000.0 92000.0 184000.0
node 7 0.0 36.0
mass 7 64400.0 64400.0 128800.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 5.0 [expr $rE*30000000000.0] 5.2 1
element elasticBeamColumn 2 2 3 5.0 [expr $rE*30000000000.0] 5.2 1
element elasticBeamColumn 3 3 4 5.0 [expr $rE*30000000000.0] 5.2 1
element elasticBeamColumn 4 4 5 5.0 [expr $rE*30000000000.0] 5.2 1
element elasticBeamColumn 5 5 6 5.0 [expr $rE*30000000000.0] 5.2 1
element elasticBeamColumn 6 6 7 5.0 [expr $rE*30000000000.0] 5.2 1
rayleigh 0.12 0.0 $bk 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 7 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 1 4 7 -dof 1 accel

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
