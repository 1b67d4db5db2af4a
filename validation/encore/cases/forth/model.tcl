# Control room on rubber pads
# units: N, m, kg, s
wipe
model basic -ndm 1 -ndf 1

pset Kd 1200000.0
pset cb 90000.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 90000.0
node 3 0.0 -mass 70000.0

# isolation layer
uniaxialMaterial Elastic 1 $Kd
uniaxialMaterial Viscous 2 $cb 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1

# storeys
uniaxialMaterial Elastic 11 110000000.0
uniaxialMaterial Viscous 21 260000.0 1.0
element zeroLength 11 2 3 -mat 11 21 -dir 1 1

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
