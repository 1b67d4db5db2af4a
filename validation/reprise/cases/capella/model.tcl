# Viaduct of three spans, across the road, in plan
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 3
pset Kd 800000.0
pset Qd 90000.0
pset rk 1.0     ;# stiffness of the piers / drawing value
set ki [expr $Kd/0.09]
set uy [expr $Qd/((1.0-0.09)*$ki)]
node 1 0.0 0.0
fix 1 1 1 1
node 20 0.0 0.0
fix 20 1 0 1
mass 20 60000.0 60000.0 1.0
node 10 0.0 0.0
fix 10 1 0 0
mass 10 280000.0 280000.0 1400000.0
node 2 45.0 0.0
fix 2 1 1 1
node 21 45.0 0.0
fix 21 1 0 1
mass 21 130000.0 130000.0 1.0
node 11 45.0 0.0
fix 11 1 0 0
mass 11 560000.0 560000.0 2800000.0
node 3 90.0 0.0
fix 3 1 1 1
node 22 90.0 0.0
fix 22 1 0 1
mass 22 130000.0 130000.0 1.0
node 12 90.0 0.0
fix 12 1 0 0
mass 12 560000.0 560000.0 2800000.0
node 4 135.0 0.0
fix 4 1 1 1
node 23 135.0 0.0
fix 23 1 0 1
mass 23 60000.0 60000.0 1.0
node 13 135.0 0.0
fix 13 1 0 0
mass 13 280000.0 280000.0 1400000.0
uniaxialMaterial Elastic 20 [expr 900000000.0]
uniaxialMaterial Viscous 30 3000000.0 1.0
element zeroLength 20 1 20 -mat 20 30 -dir 2 2
uniaxialMaterial BoucWen 10 0.09 [expr 0.7*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 10 20 10 -mat 10 -dir 2
uniaxialMaterial Elastic 21 [expr $rk*130000000.0]
uniaxialMaterial Viscous 31 900000.0 1.0
element zeroLength 21 2 21 -mat 21 31 -dir 2 2
uniaxialMaterial BoucWen 11 0.09 [expr 1.3*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 11 21 11 -mat 11 -dir 2
uniaxialMaterial Elastic 22 [expr $rk*100000000.0]
uniaxialMaterial Viscous 32 800000.0 1.0
element zeroLength 22 3 22 -mat 22 32 -dir 2 2
uniaxialMaterial BoucWen 12 0.09 [expr 1.3*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 12 22 12 -mat 12 -dir 2
uniaxialMaterial Elastic 23 [expr 900000000.0]
uniaxialMaterial Viscous 33 3000000.0 1.0
element zeroLength 23 4 23 -mat 23 33 -dir 2 2
uniaxialMaterial BoucWen 13 0.09 [expr 0.7*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 13 23 13 -mat 13 -dir 2
geomTransf Linear 1
element elasticBeamColumn 1 10 11 6.0 30000000000.0 9.0 1
element elasticBeamColumn 2 11 12 6.0 30000000000.0 9.0 1
element elasticBeamColumn 3 12 13 6.0 30000000000.0 9.0 1
rayleigh 0.0 0.0 0.002 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 2 -accel 1
recorder Element -file bearing.out -time -ele 10 13 deformation
recorder Node -file pier.out -time -node 21 -dof 2 disp
recorder Node -file acc.out -timeSeries 1 -time -node 10 12 -dof 2 accel

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
