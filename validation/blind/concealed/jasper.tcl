# three-storey school on a fixed base
# units: N, m, s
wipe
model basic -ndm 1 -ndf 1
set rk 1.126452
set rc 1.115844
node 1 0.0
fix 1 1
node 2 0.0 -mass 220700
node 3 0.0 -mass 229900
node 4 0.0 -mass 160400
node 50 0.0 -mass 48880
uniaxialMaterial Elastic 51 3581883
uniaxialMaterial Viscous 52 16737.14 1.0
element zeroLength 50 4 50 -mat 51 52 -dir 1 1

# storeys
uniaxialMaterial Elastic 11 [expr $rk*8.69e+07]
uniaxialMaterial Viscous 21 [expr $rc*732000] 1.0
element zeroLength 11 1 2 -mat 11 21 -dir 1 1
uniaxialMaterial Elastic 12 [expr $rk*7.53e+07]
uniaxialMaterial Viscous 22 [expr $rc*635000] 1.0
element zeroLength 12 2 3 -mat 12 22 -dir 1 1
uniaxialMaterial Elastic 13 [expr $rk*6.37e+07]
uniaxialMaterial Viscous 23 [expr $rc*537000] 1.0
element zeroLength 13 3 4 -mat 13 23 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
recorder Node -file floordisp.out -time -node 2 3 4 -dof 1 disp
constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1e-09 40
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
