# Bearings and sliders.
source [file join [file dirname [info script]] sheets.tcl]

# A bearing with its axis along y between two points, under an axial load that stays, and a shear of its upper end that follows a path.
# `element` makes element 1 between nodes 1 and 2. Materials: 1 axial, 2 rotation. Returns a list of {displacement force}.
proc sheared {element axial path {steps 200} {height 0.0}} {
    wipe
    model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 0 $height; fix 1 1 1 1; fix 2 0 0 1
    uniaxialMaterial Elastic 1 1e7; uniaxialMaterial Elastic 2 1e7
    eval $element
    timeSeries Linear 1
    pattern Plain 1 1 "load 2 0 [expr {-$axial}] 0"
    constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-10 200; algorithm Newton
    integrator LoadControl 0.1; analysis Static
    if {[analyze 10] != 0} {error "no convergence"}
    loadConst -time 0.0
    set values 0.0; set last 0.0
    foreach x $path {
        for {set i 1} {$i <= $steps} {incr i} {lappend values [expr {$last + double($x - $last)*$i/$steps}]}
        set last $x
    }
    timeSeries Path 2 -dt 1.0 -values $values
    pattern Plain 2 2 {sp 2 1 1.0}
    integrator LoadControl 1.0
    set out {}
    for {set i 1} {$i < [llength $values]} {incr i} {
        if {[analyze 1] != 0} {error "no convergence"}
        reactions
        lappend out [list [nodeDisp 2 1] [expr {-[nodeReaction 1 1]}]]
    }
    return $out
}

# Energy of the last two strokes, which are a whole cycle.
proc energy_of_last_cycle {history {steps 200}} {
    set sum 0.0
    lassign [lindex $history end-[expr {4*$steps}]] u0 f0
    foreach point [lrange $history end-[expr {4*$steps - 1}] end] {
        lassign $point u1 f1
        set sum [expr {$sum + 0.5*($f0 + $f1)*($u1 - $u0)}]; set u0 $u1; set f0 $f1
    }
    return $sum
}

set cycles {0.2 0.0 -0.2 0.0 0.2 0.0 -0.2 0.0}
set orient {-P 1 -Mz 2 -orient 0 1 0 -1 0 0}

sheet "Bilinear loops of rubber bearings" {elastomericBearingPlasticity elastomericBearingBoucWen} \
    {Naeim and Kelly, Design of Seismic Isolated Structures, 4} {
    Characteristic strength Q = 60, stiffness 5000 before and K = 500 after yield, cycles of D = 0.2: energy 4 Q (D - Dy), Dy = Q / 4500; force K D + Q at D.
    A sharp corner of Bouc and Wen has the exponent 20.
} {
    set Dy [expr {60.0/4500.0}]
    foreach {name element tolerance} {
        elastomericBearingPlasticity {element elastomericBearingPlasticity 1 1 2 5000.0 60.0 0.1 0.0 1.0 {*}$::orient} 2e-3
        elastomericBearingBoucWen {element elastomericBearingBoucWen 1 1 2 5000.0 60.0 0.1 0.0 1.0 20.0 0.5 0.5 {*}$::orient} 5e-3
    } {
        set h [sheared $element 0.0 $cycles]
        check "force at 0.2, $name" [lindex $h 199 1] [expr {60.0 + 500.0*0.2}] 1e-6
        check "energy of a cycle, $name" [energy_of_last_cycle $h] [expr {4.0*60.0*(0.2 - $Dy)}] $tolerance
    }
}

sheet "Sliders" {flatSliderBearing singleFPBearing Coulomb} \
    {Constantinou, Whittaker, Kalpakidis, Fenz and Warn (2007), MCEER-07-0012} {
    Under a load of 1000 a flat slider with friction 0.05 loses 4 mu N D in a cycle. A shallow pendulum of radius 10 adds the stiffness N / R.
} {
    foreach {name element stiffness} {
        flatSliderBearing {element flatSliderBearing 1 1 2 1 1e6 {*}$::orient} 0.0
        singleFPBearing {element singleFPBearing 1 1 2 1 10.0 1e6 {*}$::orient} 100.0
    } {
        set h [sheared "frictionModel Coulomb 1 0.05; $element" 1000.0 $cycles]
        check "force at 0.2, $name" [lindex $h 199 1] [expr {50.0 + $stiffness*0.2}] 5e-3
        check "energy of a cycle, $name" [energy_of_last_cycle $h] [expr {4.0*50.0*0.2}] 5e-3
    }
}

sheet "Period of a pendulum" {singleFPBearing} \
    {Zayas, Low and Mahin (1987), UCB/EERC-87/01} {
    A rigid mass on a frictionless pendulum of radius R = 1.5 has the period 2 pi sqrt(R / g), whatever the mass. Released from 0.02, it stands there again after a period.
} {
    set T [expr {2.0*acos(-1.0)*sqrt(1.5/9.81)}]
    foreach m {10.0 80.0} {
        wipe
        model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 0 -mass $m 1e-6 1e-6; fix 1 1 1 1; fix 2 0 0 1
        uniaxialMaterial Elastic 1 1e8; uniaxialMaterial Elastic 2 1e8
        frictionModel Coulomb 1 1e-6
        element singleFPBearing 1 1 2 1 1.5 1e4 {*}$orient
        timeSeries Linear 1; pattern Plain 1 1 "load 2 0 [expr {-$m*9.81}] 0"
        pattern Plain 2 1 {sp 2 1 0.02}
        constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-12 100; algorithm Newton
        integrator LoadControl 0.1; analysis Static; analyze 10
        loadConst -time 0.0
        remove loadPattern 2
        wipeAnalysis
        dynamics Newmark 0.5 0.25
        analyze 1000 [expr {$T/1000.0}]
        check "displacement after a period, mass $m" [nodeDisp 2 1] 0.02 2e-3
    }
}

sheet "Vertical stiffness of layered rubber" {ElastomericX LeadRubberX} \
    {Constantinou, Whittaker, Kalpakidis, Fenz and Warn (2007), MCEER-07-0012; Kumar, Whittaker and Constantinou (2014), Earthquake Engineering and Structural Dynamics 43, 2043-2064} {
    A bearing of 20 layers of 10 mm (G = 0.4 MPa, K = 2000 MPa, 600 mm without a hole): Kv = A Ec / Tr, 1 / Ec = 1 / (6 G S^2) + 4 / (3 K), S = D / (4 t).
    It is measured under a small load.
} {
    foreach {name make} {
        ElastomericX {element ElastomericX 1 1 2 60e3 0.1 0.4e6 2e9 0.0 0.6 0.003 0.01 20 0 0 1 -1 0 0}
        LeadRubberX {element LeadRubberX 1 1 2 60e3 0.1 0.4e6 2e9 0.0 0.6 0.003 0.01 20 0 0 1 -1 0 0}
    } {
        wipe
        model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 0 0 0.257; fix 1 1 1 1 1 1 1; fix 2 1 1 0 1 1 1
        eval $make
        timeSeries Linear 1; pattern Plain 1 1 {load 2 0 0 -1000.0 0 0 0}
        statics
        set Ec [expr {1.0/(1.0/(6.0*0.4e6*(0.6/0.04)**2) + 4.0/(3.0*2e9))}]
        check "shortening, $name" [nodeDisp 2 3] [expr {-1000.0*0.2/($Ec*acos(-1.0)*0.09)}] 1e-3
    }
}

sheet "Two directions share one circle" {elastomericBearingPlasticity} \
    {Park, Wen and Ang (1986), Earthquake Engineering and Structural Dynamics 14, 543-557} {
    A bearing of strength Q = 60 without hardening is moved along 30 degrees far beyond yield: forces Q cos 30 and Q sin 30. Along a circle the yield force follows the velocity: after many turns its
    size stays Q.
} {
    model basic -ndm 3 -ndf 6
    node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
    uniaxialMaterial Elastic 1 1e7
    element elastomericBearingPlasticity 1 1 2 5000.0 60.0 1e-9 0.0 1.0 -P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0
    timeSeries Linear 1
    pattern Plain 1 1 "sp 2 1 [expr {0.3*cos(acos(-1.0)/6.0)}]; sp 2 2 [expr {0.3*sin(acos(-1.0)/6.0)}]"
    statics 100 Transformation
    reactions
    check "force along x" [nodeReaction 2 1] [expr {60.0*cos(acos(-1.0)/6.0)}] 1e-6
    check "force along y" [nodeReaction 2 2] [expr {60.0*sin(acos(-1.0)/6.0)}] 1e-6
    wipe
    model basic -ndm 3 -ndf 6
    node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
    uniaxialMaterial Elastic 1 1e7
    element elastomericBearingPlasticity 1 1 2 5000.0 60.0 1e-9 0.0 1.0 -P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0
    set xs {}; set ys {}
    for {set i 0} {$i <= 800} {incr i} {lappend xs [expr {0.2*sin(0.02*$i*acos(-1.0))}]; lappend ys [expr {0.2*(1.0 - cos(0.02*$i*acos(-1.0)))}]}
    timeSeries Path 1 -dt 1.0 -values $xs; timeSeries Path 2 -dt 1.0 -values $ys
    pattern Plain 1 1 {sp 2 1 1.0}; pattern Plain 2 2 {sp 2 2 1.0}
    constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-10 100; algorithm Newton
    integrator LoadControl 1.0; analysis Static
    analyze 800
    reactions
    check "size of the force on the circle" [expr {hypot([nodeReaction 2 1], [nodeReaction 2 2])}] 60.0 1e-6
}

sheet "Triple pendulum through three regimes" {TripleFrictionPendulum} \
    {Fenz and Constantinou (2008), Earthquake Engineering and Structural Dynamics 37, 163-183} {
    W = 1000, inner surfaces mu1 = 0.02 and L1 = 0.3, outer ones mu2 = 0.05 and mu3 = 0.09 with L2 = L3 = 1.5. The force begins at mu1 W with the slope W / (2 L1), goes on from mu2 W with W / (L1 + L2), and
    from mu3 W with W / (L2 + L3).
} {
    model basic -ndm 3 -ndf 6
    node 1 0 0 0; node 2 0 0 0; fix 1 1 1 1 1 1 1; fix 2 0 0 0 1 1 1
    frictionModel Coulomb 1 0.02; frictionModel Coulomb 2 0.05; frictionModel Coulomb 3 0.09
    uniaxialMaterial Elastic 1 1e6; uniaxialMaterial Elastic 2 1e3
    element TripleFrictionPendulum 1 1 2 1 2 3 1 2 2 2 0.3 1.5 1.5 0.15 0.4 0.4 1000.0 1e-5 1e6 0.1 1e-6
    timeSeries Linear 1; timeSeries Linear 2
    pattern Plain 1 1 {load 2 0 0 -1000.0 0 0 0}
    constraints Transformation; numberer RCM; system UmfPack; test NormDispIncr 1e-9 200; algorithm Newton
    integrator LoadControl 0.1; analysis Static; analyze 10
    loadConst -time 0.0
    pattern Plain 2 2 {sp 2 1 1.0}
    integrator LoadControl 0.001
    foreach {steps u reference} {
        10 0.010 {20.0 + 0.010*1000.0/0.6}
        40 0.050 {50.0 + (0.050 - 0.018)*1000.0/1.8}
        150 0.200 {90.0 + (0.200 - 0.018 - 0.072)*1000.0/3.0}
    } {
        analyze $steps
        reactions
        check "force at $u" [expr {-[nodeReaction 1 1]}] [expr $reference] 2e-2
    }
}
