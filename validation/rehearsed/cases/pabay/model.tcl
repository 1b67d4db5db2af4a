# Pump house on isolators
# units: kip, in, s
wipe
model basic -ndm 1 -ndf 1

pset Kd 9.0
pset Qd 70.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 1.15
node 3 0.0 -mass 0.8
node 4 0.0 -mass 0.6

set ki [expr $Kd/0.08]
uniaxialMaterial Steel01 1 [expr $Qd/(1.0-0.08)] $ki 0.08
element zeroLength 1 1 2 -mat 1 -dir 1
uniaxialMaterial Elastic 11 [expr 1.0*1900.0]
uniaxialMaterial Viscous 21 4.6 1.0
element zeroLength 11 2 3 -mat 11 21 -dir 1 1
uniaxialMaterial Elastic 12 [expr 1.0*1400.0]
uniaxialMaterial Viscous 22 3.4 1.0
element zeroLength 12 3 4 -mat 12 22 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 2 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-7 50
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
