# Wall of five MVLEM elements: gravity, cyclic pushes, then shaking of its density's mass and of a mass on top; a cantilever of
# bbarBrick elements near incompressibility beside stdBrick. Units: kN, m, s.
proc wall {density} {
    model basic -ndm 2 -ndf 3
    for {set i 0} {$i <= 5} {incr i} { node [expr $i + 1] 0. [expr 0.6 * $i] }
    fix 1 1 1 1
    uniaxialMaterial Steel02 1 420e3 200e6 0.01 18. 0.925 0.15
    uniaxialMaterial Concrete02 2 -35e3 -0.0022 -10e3 -0.01 0.1 2.5e3 1.5e6
    uniaxialMaterial Concrete01 3 -45e3 -0.004 -30e3 -0.02
    uniaxialMaterial ElasticPP 4 8e5 0.0006
    for {set i 1} {$i <= 5} {incr i} {
        element MVLEM $i $density $i [expr $i + 1] 6 0.4 -thick 0.2 0.15 0.15 0.15 0.15 0.25 -width 0.2 0.2 0.25 0.25 0.2 0.2 \
            -rho 0.025 0.004 0.004 0.004 0.004 0.02 -matConcrete 3 2 2 2 2 3 -matSteel 1 1 1 1 1 1 -matShear 4
    }
}
wipe
wall 2.4
recorder Node -file disp.out -time -node 3 6 -dof 1 2 3 disp
recorder Element -file force.out -time -ele 1 5 globalForce
recorder Element -file curvature.out -ele 1 curvature
recorder Element -file strain.out -ele 1 fiber_strain
recorder Element -file concrete.out -ele 1 fiber_stress_concrete
recorder Element -file steel.out -ele 1 fiber_stress_steel
recorder Element -file shear.out -ele 1 3 shear_force_deformation
pattern Plain 1 Linear { load 6 0. -600. 0. }
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 100
algorithm Newton
integrator LoadControl 0.25
analysis Static
analyze 4
loadConst -time 0.
pattern Plain 2 Linear { load 6 1. 0. 0. }
foreach {step count} {0.0005 30 -0.0005 60 0.0005 80} {
    integrator DisplacementControl 6 1 $step
    puts "[analyze $count]"
}
remove recorders
loadConst -time 0.
mass 6 60. 60. 0.
set motion {}
for {set i 0} {$i < 300} {incr i} { lappend motion [expr 4. * sin(0.21 * $i) * exp(-0.01 * $i)] }
timeSeries Path 3 -dt 0.01 -values $motion
pattern UniformExcitation 3 1 -accel 3
rayleigh 0.4 0. 0.002 0.
recorder Node -file shaken.out -time -node 6 -dof 1 2 disp
recorder Node -file reaction.out -time -node 1 -dof 1 2 3 reaction
wipeAnalysis
constraints Plain
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 100
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
puts "[analyze 300 0.01]"
wipe
foreach {name nu} {bbarBrick 0.4999 bbarBrick 0.3 stdBrick 0.3} {
    model basic -ndm 3 -ndf 3
    nDMaterial ElasticIsotropic 1 2e5 $nu 2.4
    block3D 4 1 2 1 1 $name 1 {
        1 0. 0. 0.
        2 4. 0.1 0.
        3 4. 0.6 0.
        4 0. 0.5 0.
        5 0. 0. 1.
        6 4. 0.1 1.
        7 4.1 0.6 1.
        8 0. 0.5 1.
    }
    fixX 0. 1 1 1
    pattern Plain 1 Linear { load 5 0. 1. -3.; load 30 0. 0. -3. }
    recorder Node -file brick_${name}_$nu.out -nodeRange 1 30 -dof 1 2 3 disp
    recorder Element -file stress_${name}_$nu.out -ele 1 2 stresses
    constraints Plain
    numberer Plain
    system BandGeneral
    algorithm Linear
    integrator LoadControl 1.
    analysis Static
    puts "[analyze 1] [eigen 3]"
    wipe
}
