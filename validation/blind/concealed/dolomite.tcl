# isolated bridge pier
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3
set Kd 3018079
set Qd 373885.1
set rE 1.017816
node 1 0.0 0.0
node 2 0.0 10
node 20 0.0 10
node 3 0.0 0.0
fix 3 1 1 1
mass 1 34080 34080 22720
fix 20 0 1 1
mass 2 113600 113600 0.0
mass 20 602700 602700 0.0
uniaxialMaterial Elastic 31 9.03375e+07
uniaxialMaterial Viscous 32 722700 1.0
uniaxialMaterial Elastic 33 4.3362e+09
uniaxialMaterial Viscous 34 3.6135e+07 1.0
uniaxialMaterial Elastic 35 1.80675e+09
element zeroLength 30 3 1 -mat 31 32 35 33 34 -dir 1 1 2 3 3
geomTransf Linear 1
element elasticBeamColumn 1 1 2 3 [expr $rE*3e+10] 0.4015 1
rayleigh 0.4 0.0 0.0 0.0
set ki [expr $Kd/0.08]
set uy [expr $Qd/((1.0-0.08)*$ki)]
uniaxialMaterial BoucWen 1 0.08 $ki 1.0 [expr 0.5/$uy] [expr 0.5/$uy] 1.0 0.0 0.0 0.0
element zeroLength 20 2 20 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 20 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 20 -dof 1 accel
recorder Element -file bearing.out -time -ele 20 deformation
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
