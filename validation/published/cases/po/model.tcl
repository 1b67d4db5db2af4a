# Instrument platform on rubber springs, cabinet on top
# units: N, m, kg, s
wipe
model basic -ndm 2 -ndf 2

pset k 1.2e6
pset c 5.0e4
node 1 0.0 0.0
fix 1 1 1
node 2 0.0 0.0 -mass 52000.0 52000.0
fix 2 0 1
node 3 0.0 0.0 -mass 9000.0 9000.0
fix 3 0 1

# isolation layer
uniaxialMaterial Elastic 1 $k
uniaxialMaterial Viscous 2 $c 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1

# storeys
uniaxialMaterial Elastic 11 9000000.0
uniaxialMaterial Viscous 21 15000.0 1.0
element zeroLength 11 2 3 -mat 11 21 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file basedisp.out -time -node 2 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel
recorder Node -file floordisp.out -time -node 2 3 -dof 1 disp
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
