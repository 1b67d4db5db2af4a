# River bridge, pier with isolated deck
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 2.6e6
pset Qd 3.0e5
pset rE 1.0     ;# pier flexural rigidity / drawing value
node 1 0.0 0.0
node 2 0.0 5.5
node 3 0.0 11.0
node 4 0.0 11.0
# base
fix 1 1 1 1
fix 4 0 1 1
mass 2 60000.0 60000.0 4000.0
mass 3 110000.0 110000.0 6000.0
mass 4 520000.0 520000.0 1.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 2.8 [expr $rE*3.1e10] 0.62 1
element elasticBeamColumn 2 2 3 2.8 [expr $rE*3.1e10] 0.62 1
rayleigh 0.6 0.0 0.003 0.0
set ki [expr $Kd/0.08]
set uy [expr $Qd/(0.92*$ki)]
uniaxialMaterial BoucWen 1 0.08 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 20 3 4 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
recorder Element -file bearing.out -time -ele 20 deformation
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
