# Integrators, modes, damping and excitations.
source [file join [file dirname [info script]] sheets.tcl]

# A mass on a spring and a dashpot, released from 1: circular frequency `omega`, damping ratio `zeta`.
proc oscillator {omega zeta} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1.0; fix 1 1
    uniaxialMaterial Elastic 1 [expr {$omega**2}] [expr {2.0*$zeta*$omega}]
    element zeroLength 1 1 2 -mat 1 -dir 1
    setNodeDisp 2 1 1.0 -commit
    setNodeAccel 2 1 [expr {-($omega**2)}] -commit
}

sheet "Average and linear acceleration of Newmark" {Newmark} \
    {Hughes, The Finite Element Method, 9.1} {
    An undamped oscillator released from 1. With gamma = 1/2 the method turns it by the angle theta in each step,
    cos theta = 1 - W^2 / (2 (1 + beta W^2)), W = omega dt, without a loss: u_n = cos n theta.
} {
    foreach {name beta} {"average acceleration" 0.25 "linear acceleration" 0.16666666666666666} {
        oscillator 7.0 0.0
        dynamics Newmark 0.5 $beta
        analyze 50 0.05
        set W [expr {7.0*0.05}]
        check "displacement after 50 steps, $name" [nodeDisp 2 1] [expr {cos(50.0*acos(1.0 - $W**2/(2.0*(1.0 + $beta*$W**2))))}] 1e-10
    }
}

sheet "Order of the integrators" {Newmark HHT GeneralizedAlpha WilsonTheta Collocation TRBDF2 Houbolt ParkLMS3 BackwardEuler CentralDifference} \
    {Hughes, The Finite Element Method, 9; Bathe and Noh (2012), Computers and Structures 98-99, 1-6} {
    A damped oscillator (2 rad/s, 5 %) released from 1 is followed for two seconds with steps of 0.01 and 0.005. The order is the logarithm to the base 2 of the ratio of
    the errors at the end.
} {
    foreach {integrator order} {
        {Newmark 0.5 0.25} 2 {Newmark 0.6 0.3025} 1 {HHT 0.8} 2 {GeneralizedAlpha 1.0 0.8} 2 {WilsonTheta 1.4} 2 {Collocation 1.4} 2
        TRBDF2 2 Houbolt 2 ParkLMS3 2 BackwardEuler 2 {CentralDifference} 2
    } {
        set errors {}
        foreach n {200 400} {
            oscillator 2.0 0.05
            dynamics {*}$integrator
            if {$integrator eq "CentralDifference"} {algorithm Linear}
            analyze $n [expr {2.0/$n}]
            set wd [expr {2.0*sqrt(1.0 - 0.05**2)}]
            lappend errors [expr {[nodeDisp 2 1] - exp(-0.1*2.0)*(cos($wd*2.0) + 0.1/$wd*sin($wd*2.0))}]
        }
        order "order of $integrator" {*}$errors $order
    }
}

sheet "Steady motion of a damped oscillator" {Trig UniformExcitation} \
    {Chopra, Dynamics of Structures, 3.2 and 3.6} {
    An oscillator (5 rad/s, 10 %) on a ground that accelerates as sin 4 t. The largest deformation in the steady state is
    1 / omega^2 / sqrt((1 - r^2)^2 + (2 zeta r)^2), r = 4/5. Steps of 0.001.
} {
    model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1.0; fix 1 1
    uniaxialMaterial Elastic 1 25.0 1.0
    element zeroLength 1 1 2 -mat 1 -dir 1
    timeSeries Trig 1 0.0 100.0 [expr {2.0*acos(-1.0)/4.0}]
    pattern UniformExcitation 1 1 -accel 1
    dynamics Newmark 0.5 0.25
    analyze 30000 0.001
    set most 0.0
    for {set i 0} {$i < 1600} {incr i} {analyze 1 0.001; set most [expr {max($most, abs([nodeDisp 2 1]))}]}
    check "largest deformation" $most [expr {1.0/25.0/sqrt((1.0 - 0.64)**2 + (2.0*0.1*0.8)**2)}] 1e-5
}

sheet "Pulses" {Rectangular Trig} \
    {Chopra, Dynamics of Structures, 4.7} {
    A force on an undamped oscillator of period 1. A rectangular pulse of half a period doubles the static deflection. A half sine of half a period
    gives pi / 2 times as much. Steps of 0.0005.
} {
    foreach {name series reference} {
        "rectangular pulse" {timeSeries Rectangular 1 0.0 0.5} 2.0
        "half sine" {timeSeries Trig 1 0.0 0.5 1.0} {acos(-1.0)/2.0}
    } {
        wipe
        model basic -ndm 1 -ndf 1
        node 1 0; node 2 0 -mass 1.0; fix 1 1
        set k [expr {(2.0*acos(-1.0))**2}]
        uniaxialMaterial Elastic 1 $k; element zeroLength 1 1 2 -mat 1 -dir 1
        eval $series
        pattern Plain 1 1 "load 2 $k"
        dynamics Newmark 0.5 0.25
        set most 0.0
        for {set i 0} {$i < 4000} {incr i} {analyze 1 0.0005; set most [expr {max($most, abs([nodeDisp 2 1]))}]}
        check "largest deflection over the static one, $name" $most [expr $reference] 2e-3
    }
}

sheet "Modes of a chain" {eigen} \
    {Chopra, Dynamics of Structures, 10; Lord Rayleigh, The Theory of Sound, 120} {
    Six masses m on springs k, fixed at one end: omega_j = 2 sqrt(k / m) sin((2 j - 1) pi / 26).
} {
    model basic -ndm 1 -ndf 1
    uniaxialMaterial Elastic 1 300.0
    for {set i 0} {$i <= 6} {incr i} {node $i 0.0; if {$i} {mass $i 2.0; element zeroLength $i [expr {$i - 1}] $i -mat 1 -dir 1}}
    fix 0 1
    constraints Plain; numberer RCM; system UmfPack
    set lambda [eigen -fullGenLapack 6]
    for {set j 1} {$j <= 6} {incr j} {
        check "circular frequency $j" [expr {sqrt([lindex $lambda $j-1])}] [expr {2.0*sqrt(150.0)*sin((2.0*$j - 1.0)*acos(-1.0)/26.0)}] 1e-10
    }
}

sheet "Modes of a cantilever with a mass per length" {-mass -cMass elasticBeamColumn dispBeamColumn eigen} \
    {Chopra, Dynamics of Structures, 16.3} {
    omega_1 = 1.8751041^2 sqrt(E I / (m L^4)), omega_2 = 4.6940911^2 sqrt(E I / (m L^4)). Ten elements, consistent masses.
} {
    foreach {name element} {elasticBeamColumn {element elasticBeamColumn TAG I J 1000.0 2e8 1.5e-4 1 -mass 0.8 -cMass} dispBeamColumn {element dispBeamColumn TAG I J 5 7 1 -mass 0.8 -cMass}} {
        wipe
        model basic -ndm 2 -ndf 3
        for {set i 0} {$i <= 10} {incr i} {node [expr {$i + 1}] [expr {0.3*$i}] 0.0}
        fix 1 1 1 1; geomTransf Linear 1; section Elastic 7 2e8 1000.0 1.5e-4
        for {set i 1} {$i <= 10} {incr i} {eval [string map [list TAG $i I $i J [expr {$i + 1}]] $element]}
        set lambda [eigen 2]
        foreach j {1 2} root {1.875104068711961 4.694091132974175} {
            check "circular frequency $j, $name" [expr {sqrt([lindex $lambda $j-1])}] [expr {$root**2*sqrt(2e8*1.5e-4/(0.8*81.0))}] 2e-4
        }
    }
}

sheet "Rayleigh damping" {rayleigh} \
    {Chopra, Dynamics of Structures, 11.4} {
    Factors a of the mass and b of the stiffness damp a mode by a / (2 omega) + b omega / 2. The logarithmic decrement over five periods, 2 pi zeta / sqrt(1 - zeta^2) each.
} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1.0; fix 1 1
    uniaxialMaterial Elastic 1 16.0
    element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
    rayleigh 0.2 0.01 0.0 0.0
    setNodeDisp 2 1 1.0 -commit
    setNodeAccel 2 1 -16.0 -commit
    set zeta [expr {0.2/8.0 + 0.01*2.0}]; set T [expr {2.0*acos(-1.0)/(4.0*sqrt(1.0 - $zeta**2))}]
    dynamics Newmark 0.5 0.25
    analyze 5000 [expr {$T/1000.0}]
    check "amplitude after five periods" [nodeDisp 2 1] [expr {exp(-5.0*2.0*acos(-1.0)*$zeta/sqrt(1.0 - $zeta**2))}] 1e-4
}

sheet "Damping by modes" {modalDamping} \
    {Chopra, Dynamics of Structures, 11.4} {
    A chain of two masses is released in the shape of its second mode, which damps by 4 %: after five damped periods the shape has shrunk by exp(-10 pi zeta / sqrt(1 - zeta^2)).
} {
    wipe
    model basic -ndm 1 -ndf 1
    uniaxialMaterial Elastic 1 100.0
    foreach i {0 1 2} {node $i 0.0}
    mass 1 1.0; mass 2 1.0; fix 0 1
    element zeroLength 1 0 1 -mat 1 -dir 1; element zeroLength 2 1 2 -mat 1 -dir 1
    eigen -fullGenLapack 2
    modalDamping 0.04
    set golden [expr {(sqrt(5.0) - 1.0)/2.0}]; set w [expr {10.0/$golden}]
    setNodeDisp 1 1 1.0 -commit; setNodeDisp 2 1 [expr {-$golden}] -commit
    setNodeAccel 1 1 [expr {-($w**2)}] -commit; setNodeAccel 2 1 [expr {$w**2*$golden}] -commit
    set T [expr {2.0*acos(-1.0)/($w*sqrt(1.0 - 0.04**2))}]
    dynamics Newmark 0.5 0.25
    analyze 5000 [expr {$T/1000.0}]
    check "first mass" [nodeDisp 1 1] [expr {exp(-10.0*acos(-1.0)*0.04/sqrt(1.0 - 0.04**2))}] 1e-3
}

sheet "Supports that move" {MultipleSupport groundMotion imposedMotion} \
    {superposition} {
    A mass between two equal springs whose ends move by the same ground displacement moves as under a uniform excitation by its acceleration. The ground displacement is
    (1 - cos 3 t), its acceleration 9 cos 3 t, after 2000 steps of 0.001. The reference is the exact motion of the mass relative to the ground,
    -9 (cos 3 t - cos w t) / (w^2 - 9), w^2 = 40.
} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1.0; node 3 0
    fix 1 1; fix 3 1
    uniaxialMaterial Elastic 1 20.0
    element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 3 2 -mat 1 -dir 1
    set values {}
    for {set i 0} {$i <= 2500} {incr i} {lappend values [expr {1.0 - cos(3.0*0.001*$i)}]}
    timeSeries Path 1 -dt 0.001 -values $values
    pattern MultipleSupport 1 {
        groundMotion 1 Plain -disp 1
        imposedMotion 1 1 1
        imposedMotion 3 1 1
    }
    dynamics Newmark 0.5 0.25
    analyze 2000 0.001
    set w [expr {sqrt(40.0)}]
    check "relative displacement" [expr {[nodeDisp 2 1] - [nodeDisp 1 1]}] [expr {-9.0*(cos(6.0) - cos($w*2.0))/(40.0 - 9.0)}] 1e-3
}
