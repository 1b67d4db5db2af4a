# Isolated span on a pier
# units: kip, in, s
wipe
model basic -ndm 1 -ndf 1

pset Kd 16.0
pset Qd 70.0
pset kp 260.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 0.55
node 3 0.0 -mass 2.6
uniaxialMaterial Elastic 1 $kp
uniaxialMaterial Viscous 2 1.1 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1
set ki [expr $Kd/0.1]
set uy [expr $Qd/(0.9*$ki)]
uniaxialMaterial BoucWen 3 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 2 2 3 -mat 3 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel
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
