# A rigid structure on one bearing with a bilinear loop, shaken in one direction: how large are displacement and base
# shear for a characteristic strength and a period? plan.toml runs it for many of them and for recorded motions.
#
# Units: kN, m, s.

pset strength 0.05;   # characteristic strength over weight
pset period 2.5;      # of the stiffness after yielding, in s

# A batch gives a recorded motion; a sine stands for it otherwise.
if {![array exists motion]} {
    set motion(dt) 0.02
    set motion(a1) {}
    for {set i 0} {$i < 500} {incr i} { lappend motion(a1) [expr {2.0*sin(0.05*$i)}] }
}

set g 9.81
set weight 1000.0
set pi [expr {acos(-1.0)}]
set mass [expr {$weight/$g}]
set kd [expr {$mass*(2.0*$pi/$period)**2}]
set initial [expr {10.0*$kd}]
# The line after yielding meets the axis of forces at the characteristic strength.
set yield [expr {$strength*$weight/(1.0 - $kd/$initial)}]

model BasicBuilder -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1
mass 2 $mass
uniaxialMaterial Steel01 1 $yield $initial [expr {$kd/$initial}]
element zeroLength 1 1 2 -mat 1 -dir 1

timeSeries Path 1 -dt $motion(dt) -values $motion(a1)
pattern UniformExcitation 1 1 -accel 1
recorder Node -file displacement.out -time -node 2 -dof 1 disp
recorder Element -file shear.out -time -ele 1 material 1 stress

constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1e-10 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient

set displacement 0.0
set shear 0.0
set steps [expr {int([llength $motion(a1)]*$motion(dt)/0.01)}]
for {set i 0} {$i < $steps} {incr i} {
    if {[analyze 1 0.01] != 0} { error "no convergence at [getTime] s" }
    set displacement [expr {max($displacement, abs([nodeDisp 2 1]))}]
    set shear [expr {max($shear, abs([eleResponse 1 material 1 stress]))}]
}
set shear [expr {$shear/$weight}]
set residual [expr {abs([nodeDisp 2 1])}]
