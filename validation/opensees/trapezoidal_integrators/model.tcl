# Integrators that weight the forces of both ends of a step, and explicit differences: three storeys that yield, shaken and loaded, with
# Rayleigh damping. One file of displacements and one of accelerations for each integrator.
proc storeys {name integrator test algorithm} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0.0; node 2 0.0; node 3 0.0; node 4 0.0
    fix 1 1
    mass 2 6.0; mass 3 5.0; mass 4 4.0
    uniaxialMaterial BoucWen 1 0.1 4000.0 2.0 30. 30. 1.0 0. 0. 0.
    uniaxialMaterial Steel02 2 40. 3000. 0.03 18. 0.925 0.15
    uniaxialMaterial Elastic 3 2500.
    element zeroLength 1 1 2 -mat 1 -dir 1
    element zeroLength 2 2 3 -mat 2 -dir 1
    element zeroLength 3 3 4 -mat 3 -dir 1
    rayleigh 0.3 0.0 0.002 0.0
    timeSeries Trig 1 0.0 0.8 0.55 -factor 4.0
    timeSeries Trig 2 0.0 2.0 0.6
    pattern UniformExcitation 1 1 -accel 1
    pattern Plain 2 2 { load 3 5.0 }
    recorder Node -file ${name}_disp.out -precision 10 -time -node 2 3 4 -dof 1 disp
    recorder Node -file ${name}_accel.out -precision 10 -time -node 2 4 -dof 1 accel
    constraints Plain
    numberer Plain
    system FullGeneral
    eval test $test
    eval algorithm $algorithm
    eval integrator $integrator
    analysis Transient
    analyze 60 0.02
    wipe
}
set exact {NormDispIncr 1e-12 100}
storeys hht "HHT_TP 0.8" $exact Newton
storeys hht_three "HHT_TP 0.8 0.4 0.6" $exact Newton
storeys generalized "HHTGeneralized_TP 0.5" $exact Newton
storeys explicit "HHTExplicit_TP 0.9 0.6" $exact Linear
storeys generalized_explicit "HHTGeneralizedExplicit_TP 0.8 0.6" $exact Linear
storeys splitting "AlphaOS_TP 0.8" $exact Linear
storeys splitting_generalized "AlphaOSGeneralized_TP 0.6 -updateElemDisp" $exact Linear
storeys kolay_ricles "KRAlphaExplicit_TP 0.5" $exact Linear
storeys reduct "HHTHSIncrReduct_TP 0.5 0.7" $exact Newton
storeys limit "HHTHSIncrLimit_TP 0.5 0.0005" $exact Newton
storeys fixed "HHTHSFixedNumIter_TP 0.6 -polyOrder 3" {FixedNumIter 5} Newton
storeys leap_frog "ExplicitDifference" $exact Linear
storeys alternative "CentralDifferenceAlternative" $exact Linear
