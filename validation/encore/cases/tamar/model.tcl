# Two-storey museum on isolators
# units: kN, mm, s
wipe
model basic -ndm 1 -ndf 1

pset Kd 3.4
pset Qd 260.0
pset rk 1.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 0.3
node 3 0.0 -mass 0.26
node 4 0.0 -mass 0.21

# isolation layer
set ki [expr $Kd/0.1]
set uy [expr $Qd/((1.0-0.1)*$ki)]
uniaxialMaterial BoucWen 1 0.1 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1

# storeys
uniaxialMaterial Elastic 11 [expr $rk*430.0]
uniaxialMaterial Viscous 21 1.0 1.0
element zeroLength 11 2 3 -mat 11 21 -dir 1 1
uniaxialMaterial Elastic 12 [expr $rk*330.0]
uniaxialMaterial Viscous 22 0.8 1.0
element zeroLength 12 3 4 -mat 12 22 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-6 40
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
