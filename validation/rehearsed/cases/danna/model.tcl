# Isolated span on one pier, longitudinal
# units: kN, m, t, s
wipe
model basic -ndm 2 -ndf 3
pset Fy 350.0
pset b 0.1
pset rE 1.0    ;# pier rigidity / drawing value
node 1 0.0 0.0
node 2 0.0 8.0
node 3 0.0 8.0
fix 1 1 1 1
fix 3 0 1 1
mass 2 90.0 90.0 0.0
mass 3 700.0 700.0 0.0
geomTransf Linear 1
element elasticBeamColumn 1 1 2 2.6 [expr $rE*3.0e7] 0.9 1
uniaxialMaterial Steel01 1 $Fy 52000.0 $b
element zeroLength 2 2 3 -mat 1 -dir 1
rayleigh 0.12 0.0 0.003 0.0
timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 3 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel
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
