# Bridge pier with isolated deck
# units: kN, m, t, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 4000.0
pset Qd 400.0
pset rE 1.0     ;# flexural rigidity / drawing value
node 1 0.0 0.0
node 2 0.0 3.0
node 3 0.0 6.0
node 4 0.0 9.0
node 20 0.0 9.0
fix 1 1 1 1
fix 20 0 1 1
mass 2 52.0 52.0 0.0
mass 3 52.0 52.0 0.0
mass 4 90.0 90.0 0.0
mass 20 560.0 560.0 0.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 2.6 [expr $rE*2.833333333e7] 0.3 1
element elasticBeamColumn 2 2 3 2.6 [expr $rE*2.833333333e7] 0.3 1
element elasticBeamColumn 3 3 4 2.6 [expr $rE*2.833333333e7] 0.3 1
rayleigh 0.5 0.0 0.0015 0.0
set ki [expr $Kd/0.08]
set uy [expr $Qd/((1.0-0.08)*$ki)]
uniaxialMaterial BoucWen 1 0.08 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 20 4 20 -mat 1 -dir 1
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 4 20 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 4 20 -dof 1 accel
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 40
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
