# Laboratory building, three storeys
# units: N, m, kg, s
wipe
model basic -ndm 1 -ndf 1

pset rk 1.0
pset b1 0.003
node 1 0.0
fix 1 1
node 2 0.0 -mass 240000.0
node 3 0.0 -mass 230000.0
node 4 0.0 -mass 190000.0

uniaxialMaterial Elastic 1 [expr $rk*310000000.0]
uniaxialMaterial Elastic 2 [expr $rk*260000000.0]
uniaxialMaterial Elastic 3 [expr $rk*190000000.0]
element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
element zeroLength 2 2 3 -mat 2 -dir 1 -doRayleigh 1
element zeroLength 3 3 4 -mat 3 -dir 1 -doRayleigh 1
rayleigh 0.3 0.0 $b1 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 -dof 1 accel
recorder Node -file disp.out -time -node 2 3 4 -dof 1 disp

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
