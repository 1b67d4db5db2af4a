# Hospital wing, four storeys
# units: N, m, kg, s
wipe
model basic -ndm 1 -ndf 1
pset rk 1.0     ;# storey stiffness / drawing value
pset rc 1.0     ;# dashpots / assumed value
node 1 0.0
fix 1 1
node 2 0.0 -mass 210000.0
node 3 0.0 -mass 200000.0
node 4 0.0 -mass 190000.0
node 5 0.0 -mass 150000.0
uniaxialMaterial Elastic 11 [expr $rk*260000000.0]
uniaxialMaterial Viscous 21 [expr $rc*700000.0] 1.0
element zeroLength 11 1 2 -mat 11 21 -dir 1 1
uniaxialMaterial Elastic 12 [expr $rk*240000000.0]
uniaxialMaterial Viscous 22 [expr $rc*650000.0] 1.0
element zeroLength 12 2 3 -mat 12 22 -dir 1 1
uniaxialMaterial Elastic 13 [expr $rk*210000000.0]
uniaxialMaterial Viscous 23 [expr $rc*550000.0] 1.0
element zeroLength 13 3 4 -mat 13 23 -dir 1 1
uniaxialMaterial Elastic 14 [expr $rk*170000000.0]
uniaxialMaterial Viscous 24 [expr $rc*450000.0] 1.0
element zeroLength 14 4 5 -mat 14 24 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 5 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 4 5 -dof 1 accel

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
