# Stair tower, five storeys, as a stick
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3

pset rE 0.9       ;# flexural rigidity / drawing value
pset aK 0.002     ;# damping, proportional to stiffness

node 1 0.0 0.0
fix 1 1 1 1
geomTransf Linear 1
foreach i {2 3 4 5 6} m {110000.0 110000.0 110000.0 110000.0 90000.0} {
    node $i 0.0 [expr 3.3*($i-1)]
    mass $i $m $m 0.0
    element elasticBeamColumn [expr $i-1] [expr $i-1] $i 2.4 [expr $rE*3.0e10] 1.1 1
}
rayleigh 0.0 0.0 $aK 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 6 -dof 1 accel
recorder Node -file disp.out -time -node 2 3 4 5 6 -dof 1 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-11 40
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
