# A rubber pad in shear, driven by an actuator: the model of a study.
#
#   hysteron calibrate tcl-like-inputs/pad_study/study.toml
#
# Units: kN, mm, s.  Bouc-Wen with k0 the initial stiffness, Qd the characteristic strength, alpha the stiffness after
# yield over k0 (Wen, 1976; OpenSees' uniaxialMaterial BoucWen with beta = gamma = 1/2 over the yield displacement).
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

# The study gives these three their values; without a study they are as written here.
pset k0    2.0
pset Qd    20.0
pset alpha 0.15

# And each run its actuator motion.
if {![info exists motion]} {set motion growing.dat}
if {![info exists dt]}     {set dt 0.02}
if {![info exists npts]}   {set npts 501}

set uy [expr {$Qd/((1.0-$alpha)*$k0)}]
uniaxialMaterial BoucWen 1 $alpha $k0 1.0 [expr {0.5/$uy}] [expr {0.5/$uy}] 1.0 0.0 0.0 0.0
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $dt -filePath $motion -useLast
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl $dt
analysis Static
if {[analyze [expr {$npts-1}]] != 0} {error "no convergence at [getTime]"}
