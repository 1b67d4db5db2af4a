# What OpenSees keeps of a step: a triple pendulum whose friction goes on from the speed of the last call, heated lead and shear springs
# with damping by the committed stiffness (renewed of the one, that of the beginning of the other), and a flag that remembers the state
# within the step that HHT asks it at. Four isolators beside each other; then the triple pendulum once more with two calls a step (TRBDF2).
# Units: kN, m, s.
set weight 1000.0
set m [expr {$weight/9.81}]
set up {-orient 0 0 1 1 0 0}

proc setting {} {
    global weight
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    uniaxialMaterial Elastic 1 2.0e6
    uniaxialMaterial Elastic 2 1.0e5
    uniaxialMaterial KikuchiAikenHDR 10 X0.6 0.17 0.15
    uniaxialMaterial SelfCentering 11 5000. 100. 50. 0.6 0 0 0
    frictionModel Coulomb 1 0.09
    frictionModel VelDependent 2 0.03 0.06 25.
}

proc stands {base top height} {
    global m
    node $base $base 0 0
    fix $base 1 1 1 1 1 1
    node $top $base 0 $height -mass $m $m $m 1 1 1
    fix $top 0 0 0 1 1 1
}

proc weigh {tops} {
    global weight
    timeSeries Linear 1
    pattern Plain 1 1 { foreach top $tops { load $top 0 0 -$weight 0 0 0 } }
    constraints Transformation
    numberer RCM
    system UmfPack
    test NormDispIncr 1e-12 100 0
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    analyze 10
    loadConst -time 0.0
    wipeAnalysis
}

proc shake {integrator steps} {
    timeSeries Trig 2 0.0 1.5 0.6 -factor 2.5
    pattern UniformExcitation 2 1 -accel 2
    pattern UniformExcitation 3 2 -accel 2 -fact 0.6
    constraints Transformation
    numberer RCM
    system UmfPack
    test NormDispIncr 2e-6 50 0
    algorithm Newton
    integrator {*}$integrator
    analysis Transient
    return [analyze $steps 0.01]
}

setting
stands 1 2 0.0
stands 3 4 0.3
stands 5 6 0.3
stands 7 8 0.3
set pendulum "TripleFrictionPendulum 1 1 2 1 2 2 1 2 2 2 0.3 1. 1. 0.1 0.3 0.3 $weight 0.002 2.0e6 0.1 1e-8"
element {*}$pendulum
element LeadRubberX 2 3 4 60. 0.12 700. 2e6 0.1 0.6 0.003 0.008 20 0 0 1 1 0 0 10. 0.7 1. 0.4 0. 0. 0. 11.2 130. 0.05 1.41e-5 1 0 0 1 1
element multipleShearSpring 3 5 6 8 -mat 10 {*}$up
element twoNodeLink 13 5 6 -mat 1 -dir 1 {*}$up
element twoNodeLink 4 7 8 -mat 1 2 11 -dir 1 2 3 {*}$up
element twoNodeLink 14 7 8 -mat 11 -dir 2 {*}$up
weigh {2 4 6 8}
rayleigh 0.1 0.0 0.0 0.002
recorder Node -file disp.out -time -node 2 4 6 8 -dof 1 2 disp
recorder Element -file force.out -ele 1 2 3 4 force
set hht [shake {HHT 0.9} 150]

setting
stands 1 2 0.0
element {*}$pendulum
weigh {2}
recorder Node -file disp_trbdf2.out -time -node 2 -dof 1 2 disp
recorder Element -file force_trbdf2.out -ele 1 force
set trbdf2 [shake TRBDF2 150]
wipe
set file [open done.out w]
puts $file "$hht $trbdf2"
close $file
