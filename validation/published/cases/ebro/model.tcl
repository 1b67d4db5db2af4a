# Two-span viaduct, longitudinal direction
# units: kN, m, t, s
wipe
model basic -ndm 1 -ndf 1
pset Kd 2400.0
pset Qd 200.0
pset rp 1.0     ;# pier stiffness / drawing value
node 1 0.0
fix 1 1
node 2 0.0 -mass 160.0
node 3 0.0 -mass 720.0
node 4 0.0 -mass 380.0
# pier
uniaxialMaterial Elastic 1 [expr $rp*90000.0]
uniaxialMaterial Viscous 2 300.0 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1
# bearings of the long span and of the short span (0.7 of the size)
set ki [expr $Kd/0.1]
set uy [expr $Qd/(0.9*$ki)]
uniaxialMaterial BoucWen 11 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
uniaxialMaterial BoucWen 12 0.1 [expr 0.7*$ki] 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 11 1 3 -mat 11 -dir 1
element zeroLength 12 2 3 -mat 11 -dir 1
element zeroLength 13 2 4 -mat 12 -dir 1
element zeroLength 14 1 4 -mat 12 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
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
