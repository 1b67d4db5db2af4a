# Four-storey frame
# units: kN, m, t, s
wipe
model basic -ndm 1 -ndf 1

pset rE 1.0
pset rF 1.0
pset b 0.03
node 1 0.0
fix 1 1
node 2 0.0 -mass 160.0
node 3 0.0 -mass 160.0
node 4 0.0 -mass 160.0
node 5 0.0 -mass 130.0

uniaxialMaterial Steel01 1 [expr $rF*1500.0] [expr $rE*260000.0] $b
uniaxialMaterial Steel01 2 [expr $rF*1300.0] [expr $rE*230000.0] $b
uniaxialMaterial Steel01 3 [expr $rF*1000.0] [expr $rE*190000.0] $b
uniaxialMaterial Steel01 4 [expr $rF*650.0] [expr $rE*140000.0] $b
element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
element zeroLength 2 2 3 -mat 2 -dir 1 -doRayleigh 1
element zeroLength 3 3 4 -mat 3 -dir 1 -doRayleigh 1
element zeroLength 4 4 5 -mat 4 -dir 1 -doRayleigh 1
rayleigh 0.3 0.0 0.0018 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 -dof 1 accel
recorder Node -file disp.out -time -node 2 3 4 5 -dof 1 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 50
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
