# Integrators that solve a step at another time than its end, with a support that is moved, loads on nodes and elements that vary, and
# mass along a beam: what OpenSees leaves of that time at the end of the step. kN, m, s.
proc frame {name integrator algorithm} {
    wipe
    model BasicBuilder -ndm 2 -ndf 3
    node 1 0 0; node 2 5 0; node 3 0 3 -mass 10 10 1; node 4 5 3 -mass 10 10 1
    fix 1 0 1 1; fix 2 1 1 1
    geomTransf Linear 1
    element elasticBeamColumn 1 1 3 0.1 2e7 1e-3 1
    element elasticBeamColumn 2 2 4 0.1 2e7 1e-3 1
    element elasticBeamColumn 3 3 4 0.1 2e7 1e-3 1 -mass 0.5
    rayleigh 0.1 0.001 0 0
    timeSeries Trig 1 0 2 0.5 -factor 0.01
    timeSeries Trig 2 0 2 0.3 -factor 10
    timeSeries Trig 3 0 2 0.5 -factor 0.125
    timeSeries Trig 4 0 2 0.5 -factor 1.5
    pattern MultipleSupport 1 {
        groundMotion 1 Plain -disp 1 -vel 3 -accel 4
        imposedMotion 1 1 1
    }
    pattern Plain 2 2 { load 3 1 2 0.5; eleLoad -ele 3 -type -beamUniform -1.0 }
    recorder Node -file ${name}_disp.out -time -node 1 3 4 -dof 1 2 3 disp
    recorder Node -file ${name}_accel.out -node 1 3 -dof 1 accel
    recorder Element -file ${name}_force.out -ele 1 2 3 force
    recorder Node -file ${name}_reaction.out -node 1 2 -dof 1 2 3 reaction
    constraints Transformation; numberer RCM; system FullGeneral; test NormDispIncr 1e-10 20 0
    algorithm $algorithm
    eval integrator $integrator
    analysis Transient
    return [analyze 60 0.01]
}
set done {}
foreach {name integrator algorithm} {
    hht {HHT 0.9} Newton
    generalized {GeneralizedAlpha 1.0 0.9} Newton
    collocation {Collocation 1.4} Newton
    wilson {WilsonTheta 1.4} Newton
    splitting {AlphaOS 0.9} Linear
    splitting_generalized {AlphaOSGeneralized 0.9 -updateElemDisp} Linear
    kolay_ricles {KRAlphaExplicit 0.9} Linear
} { lappend done [frame $name $integrator $algorithm] }
wipe
set file [open done.out w]; puts $file $done; close $file
