# Kikuchi's bearing in OpenSees' scheme, whose answer goes on with every call, where more than Newton's method asks: line searches,
# algorithms with the "initial" stiffness, which is the current one in OpenSees, Rayleigh damping by that and by the committed one, which
# stays that of the beginning. Units: kN, m, s.
proc bearing {damping} {
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    set m [expr {1000.0/9.81}]
    node 1 0 0 0
    fix 1 1 1 1 1 1 1
    node 2 0 0 0.3 -mass $m $m $m 1 1 1
    fix 2 0 0 0 1 1 1
    uniaxialMaterial KikuchiAikenHDR 10 X0.6 0.17 0.15
    uniaxialMaterial AxialSp 21 6e5 1e3 -1e5 0.1 0.01 0.5
    element KikuchiBearing 1 1 2 -shape round -size 0.46 0.15 -totalHeight 0.3 -nMSS 8 -matMSS 10 -limDisp 0.01 -nMNS 8 -matMNS 21 -orient 0 0 1 1 0 0
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0 0 -1000. 0 0 0 }
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
    rayleigh {*}$damping
}

proc shake {algorithm integrator} {
    timeSeries Trig 2 0.0 1.2 0.5 -factor 1.5
    pattern UniformExcitation 2 1 -accel 2
    pattern UniformExcitation 3 2 -accel 2 -fact 0.6
    constraints Plain
    numberer RCM
    system FullGeneral
    test NormDispIncr 1e-9 100 0
    algorithm {*}$algorithm
    integrator {*}$integrator
    analysis Transient
    return [analyze 100 0.01]
}

set done {}
set case 0
foreach {damping algorithm integrator} {
    {0.1 0.0 0.002 0.0} {NewtonLineSearch} {Newmark 0.5 0.25}
    {0.1 0.0 0.0 0.002} {NewtonLineSearch -type Bisection} {HHT 0.9}
    {0.1 0.0 0.0 0.002} {ModifiedNewton -initial} {TRBDF2}
    {0.1 0.0 0.002 0.0} {Newton -initialThenCurrent} {Newmark 0.6 0.3025}
    {0.1 0.001 0.0 0.0} {NewtonLineSearch -type Secant} {TRBDF2}
    {0.1 0.0 0.002 0.0} {NewtonLineSearch -type RegulaFalsi} {Newmark 0.5 0.25}
} {
    incr case
    bearing $damping
    recorder Node -file disp$case.out -time -node 2 -dof 1 2 3 disp
    recorder Element -file force$case.out -ele 1 force
    lappend done [shake $algorithm $integrator]
}
wipe
set file [open done.out w]
puts $file $done
close $file
