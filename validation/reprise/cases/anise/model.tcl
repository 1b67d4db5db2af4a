# Four-storey moment frame, one spring per storey
# units: N, m, kg, s
wipe
model basic -ndm 1 -ndf 1

pset rk 1.0   ;# storey stiffness / drawing value
pset ry 1.0   ;# storey strength / drawing value
node 1 0.0
fix 1 1
node 2 0.0 -mass 90000.0
node 3 0.0 -mass 90000.0
node 4 0.0 -mass 90000.0
node 5 0.0 -mass 70000.0
uniaxialMaterial Steel01 11 [expr $ry*1050000.0] [expr $rk*125000000.0] 0.06
uniaxialMaterial Viscous 21 600000.0 1.0
element zeroLength 11 1 2 -mat 11 21 -dir 1 1
uniaxialMaterial Steel01 12 [expr $ry*900000.0] [expr $rk*110000000.0] 0.06
uniaxialMaterial Viscous 22 550000.0 1.0
element zeroLength 12 2 3 -mat 12 22 -dir 1 1
uniaxialMaterial Steel01 13 [expr $ry*700000.0] [expr $rk*90000000.0] 0.06
uniaxialMaterial Viscous 23 450000.0 1.0
element zeroLength 13 3 4 -mat 13 23 -dir 1 1
uniaxialMaterial Steel01 14 [expr $ry*450000.0] [expr $rk*70000000.0] 0.06
uniaxialMaterial Viscous 24 350000.0 1.0
element zeroLength 14 4 5 -mat 14 24 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 -dof 1 accel
recorder Node -file disp.out -time -node 2 3 4 5 -dof 1 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-11 40
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
