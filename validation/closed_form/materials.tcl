# Uniaxial laws along a path, and sections.
source [file join [file dirname [info script]] sheets.tcl]

# Stress of a law at the end of a path of strains.
proc stress {law args} {
    wipe
    model basic -ndm 1 -ndf 1
    if {[llength [split $law \n]] > 1} {eval $law} else {eval "uniaxialMaterial $law"}
    testUniaxialMaterial 1
    foreach e $args {setStrain $e}
    getStress
}

# Strains from one value to another in steps.
proc path {from to {n 200}} {
    set out {}
    for {set i 1} {$i <= $n} {incr i} {lappend out [expr {$from + double($to - $from)*$i/$n}]}
    return $out
}

sheet "Elastic laws" {Elastic ENT ElasticPP ElasticPPGap ElasticMultiLinear} \
    {their definitions} {
    E = 200. ElasticPP yields at a strain of 0.01 and unloads with E. The gap of ElasticPPGap opens at 0.005 and its force is limited by 1.
} {
    check "Elastic in compression, another stiffness" [stress {Elastic 1 200.0 0.0 50.0} -0.02] -1.0 1e-14
    check "ENT in compression" [stress {ENT 1 200.0} -0.02] -4.0 1e-14
    check "ENT in tension" [stress {ENT 1 200.0} 0.02] 0.0 1e-14 1.0
    check "ElasticPP beyond yield and back" [stress {ElasticPP 1 200.0 0.01} 0.03 0.025] 1.0 1e-12
    check "ElasticPPGap, closed" [stress {ElasticPPGap 1 200.0 1.0 0.005} 0.008] 0.6 1e-12
    check "ElasticPPGap, yielded" [stress {ElasticPPGap 1 200.0 1.0 0.005} 0.02] 1.0 1e-12
    check "ElasticMultiLinear between two points" [stress {ElasticMultiLinear 1 -strain -1 0 1 3 -stress -2 0 2 3} 2.0] 2.5 1e-12
}

sheet "Bilinear steel" {Steel01 Hardening Hysteretic} \
    {Hill, The Mathematical Theory of Plasticity, 2} {
    E = 200, fy = 2, stiffness 4 after yield. From 0.03 back to -0.03 the stress falls by 2 fy before it yields again (kinematic hardening), and by twice
    the stress reached with isotropic hardening.
} {
    set peak [expr {2.0 + 4.0*(0.03 - 0.01)}]
    check "Steel01 in tension" [stress {Steel01 1 2.0 200.0 0.02} {*}[path 0 0.03]] $peak 1e-12
    check "Steel01 after reversal" [stress {Steel01 1 2.0 200.0 0.02} {*}[path 0 0.03] {*}[path 0.03 -0.03]] [expr {-(2.0 + 4.0*0.02)}] 1e-12
    # Hkin of a tangent Et: E Et / (E - Et).
    set H [expr {200.0*4.0/196.0}]
    check "Hardening, kinematic" [stress "Hardening 1 200.0 2.0 0.0 $H" {*}[path 0 0.03] {*}[path 0.03 -0.03]] [expr {-(2.0 + 4.0*0.02)}] 1e-10
    set back [expr {0.03 - 2.0*$peak/200.0}]
    check "Hardening, isotropic, after reversal" [stress "Hardening 1 200.0 2.0 $H 0.0" {*}[path 0 0.03] {*}[path 0.03 -0.03]] [expr {-($peak + 4.0*($back + 0.03))}] 1e-10
    check "Hysteretic between its second and third point" [stress {Hysteretic 1 2.0 0.01 3.0 0.03 3.5 0.05 -2.0 -0.01 -3.0 -0.03 -3.5 -0.05 1 1 0 0 0} {*}[path 0 0.04]] 3.25 1e-12
}

sheet "Curved steel" {Steel02} \
    {Menegotto and Pinto (1973), IABSE symposium, Lisbon; Filippou, Popov and Bertero (1983), EERC 83-19} {
    The first branch is s = b e + (1 - b) e / (1 + e^R)^(1/R) in multiples of the yield point, R = 18. After a reversal at plastic excursion xi
    R = R0 (1 - cR1 xi / (cR2 + xi)) between the reversal and the crossing of the asymptotes.
} {
    set e 2.5
    check "first branch" [stress {Steel02 1 2.0 200.0 0.02 18 0.925 0.15} {*}[path 0 0.025]] [expr {2.0*(0.02*$e + 0.98*$e/pow(1.0 + pow($e, 18.0), 1.0/18.0))}] 1e-12
    set top [stress {Steel02 1 2.0 200.0 0.02 18 0.925 0.15} {*}[path 0 0.025]]
    # Asymptotes: slope E from the reversal (0.025, top); slope b E through (-0.01, -2).
    set e0 [expr {(-2.0 + 4.0*0.01 - $top + 200.0*0.025)/(200.0 - 4.0)}]
    set s0 [expr {$top + 200.0*($e0 - 0.025)}]
    set xi [expr {abs((0.025 - 0.01)/0.01)}]; set R [expr {18.0*(1.0 - 0.925*$xi/(0.15 + $xi))}]
    set x [expr {(-0.005 - 0.025)/($e0 - 0.025)}]
    set y [expr {0.02*$x + 0.98*$x/pow(1.0 + pow($x, $R), 1.0/$R)}]
    check "after a reversal" [stress {Steel02 1 2.0 200.0 0.02 18 0.925 0.15} {*}[path 0 0.025] {*}[path 0.025 -0.005]] [expr {$top + $y*($s0 - $top)}] 1e-8
}

sheet "Concrete in compression" {Concrete01 Concrete02 Concrete04} \
    {Kent and Park (1971), Journal of the Structural Division 97, 1969-1990; Popovics (1973), Cement and Concrete Research 3, 583-599} {
    fc = 30 at 0.002, 6 left at 0.01. Kent and Park: a parabola, then a line. Popovics: fc x r / (r - 1 + x^r), r = E / (E - fc / ec).
} {
    foreach {name law} {Concrete01 {Concrete01 1 -30.0 -0.002 -6.0 -0.01} Concrete02 {Concrete02 1 -30.0 -0.002 -6.0 -0.01 0.1 3.0 1500.0}} {
        check "parabola, $name" [stress $law {*}[path 0 -0.0012]] [expr {-30.0*(2.0*0.6 - 0.36)}] 1e-12
        check "line, $name" [stress $law {*}[path 0 -0.006]] [expr {-30.0 + 24.0*0.5}] 1e-12
        check "residual, $name" [stress $law {*}[path 0 -0.02]] -6.0 1e-12
    }
    check "Concrete01 does not carry tension" [stress {Concrete01 1 -30.0 -0.002 -6.0 -0.01} 0.001] 0.0 1e-12 1.0
    check "Concrete02 cracks at ft and softens by Ets" [stress {Concrete02 1 -30.0 -0.002 -6.0 -0.01 0.1 3.0 1500.0} {*}[path 0 0.0008]] [expr {3.0 - 1500.0*(0.0008 - 3.0/30000.0)}] 1e-10
    set r [expr {25000.0/(25000.0 - 15000.0)}]
    check "Popovics' curve, Concrete04" [stress {Concrete04 1 -30.0 -0.002 -0.01 25000.0} {*}[path 0 -0.003]] [expr {-30.0*1.5*$r/($r - 1.0 + pow(1.5, $r))}] 1e-10
}

sheet "Smooth hysteresis by Bouc and Wen" {BoucWen} \
    {Wen (1976), Journal of the Engineering Mechanics Division 102, 249-263} {
    With n = 1 and beta + gamma = 50 the first loading has z = (1 - exp(-50 u)) / 50 and the force alpha k u + (1 - alpha) k z. Each step solves for z implicitly; 4000 steps.
} {
    set u 0.06
    check "force at 0.06" [stress {BoucWen 1 0.1 100.0 1 30.0 20.0 1.0 0.0 0.0 0.0} {*}[path 0 $u 4000]] [expr {0.1*100.0*$u + 0.9*100.0*(1.0 - exp(-50.0*$u))/50.0}] 5e-4
}

sheet "Abutment backfill" {HyperbolicGapMaterial} \
    {Duncan and Mokwa (2001), Journal of Geotechnical and Geoenvironmental Engineering 127, 248-257} {
    Beyond a gap of 0.02 the force is x / (1 / Kmax + Rf x / Fult) in compression, Kmax = 20300, Rf = 0.7, Fult = 326.
} {
    check "force at 0.05" [stress {HyperbolicGapMaterial 1 20300.0 20300.0 0.7 -326.0 -0.02} {*}[path 0 -0.05]] [expr {-0.03/(1.0/20300.0 + 0.7*0.03/326.0)}] 1e-10
    check "open" [stress {HyperbolicGapMaterial 1 20300.0 20300.0 0.7 -326.0 -0.02} {*}[path 0 -0.015]] 0.0 1e-12 1.0
}

sheet "Fatigue" {Fatigue} \
    {Uriz and Mahin (2008), PEER 2008/08; Coffin and Manson} {
    Cycles between strains of 0.02 and -0.02 with E0 = 0.191, m = -0.458: a law fails after (0.04 / 0.191)^(1 / m) = 30.4 cycles, counted by their range.
} {
    wipe
    model basic -ndm 1 -ndf 1
    uniaxialMaterial Elastic 2 1.0
    uniaxialMaterial Fatigue 1 2 -E0 0.191 -m -0.458
    testUniaxialMaterial 1
    set cycles 0
    for {set i 0} {$i < 400} {incr i} {
        foreach e {0.02 -0.02} {setStrain $e}
        if {abs([getStress]) < 1e-6} break
        incr cycles
    }
    check "cycles before it fails" $cycles [expr {pow(0.04/0.191, 1.0/-0.458)}] 0.04
}

# Force history of a material under an imposed harmonic or ramp: returns the dissipated energy of the last cycle.
proc energy_of_cycle {law omega amplitude {n 2000}} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0; node 2 0 -mass 1e-9; fix 1 1
    eval "uniaxialMaterial $law"
    element zeroLength 1 1 2 -mat 1 -dir 1
    set T [expr {2.0*acos(-1.0)/$omega}]
    timeSeries Trig 1 0 100 $T -factor $amplitude
    pattern MultipleSupport 1 {groundMotion 1 Plain -disp 1; imposedMotion 2 1 1}
    dynamics Newmark 0.5 0.25
    set dt [expr {$T/$n}]
    analyze [expr {2*$n}] $dt
    set sum 0.0; set u0 [nodeDisp 2 1]; set f0 [lindex [eleResponse 1 force] 1]
    for {set i 0} {$i < $n} {incr i} {
        analyze 1 $dt
        set u1 [nodeDisp 2 1]; set f1 [lindex [eleResponse 1 force] 1]
        set sum [expr {$sum + 0.5*($f0 + $f1)*($u1 - $u0)}]; set u0 $u1; set f0 $f1
    }
    return $sum
}

sheet "Dashpots in harmonic motion" {Viscous Maxwell ViscousDamper} \
    {Constantinou and Symans (1992), NCEER-92-0032} {
    Energy of a cycle of amplitude X: pi c omega X^2 for a linear dashpot; 4 * 2^a G(1 + a/2)^2 / G(2 + a) c omega^a X^(1 + a) for the power a, with the gamma function G: a = 1/2 here,
    factor 3.4960767; pi c omega X^2 / (1 + (c omega / k)^2) for a linear dashpot behind a spring k.
} {
    set w 3.0; set X 0.2; set pi [expr {acos(-1.0)}]
    check "linear dashpot" [energy_of_cycle {Viscous 1 5.0 1.0} $w $X] [expr {$pi*5.0*$w*$X**2}] 5e-4
    check "power of one half" [energy_of_cycle {Viscous 1 5.0 0.5} $w $X] [expr {3.4960767390561446*5.0*sqrt($w)*pow($X, 1.5)}] 1e-3
    check "Maxwell" [energy_of_cycle {Maxwell 1 40.0 5.0 1.0 1.0} $w $X] [expr {$pi*5.0*$w*$X**2/(1.0 + (5.0*$w/40.0)**2)}] 5e-3
    check "ViscousDamper" [energy_of_cycle {ViscousDamper 1 40.0 5.0 1.0} $w $X] [expr {$pi*5.0*$w*$X**2/(1.0 + (5.0*$w/40.0)**2)}] 1e-3
}

sheet "Self-centring brace" {SelfCentering} \
    {Christopoulos, Tremblay, Kim and Lacerte (2008), Journal of Structural Engineering 134, 96-107} {
    k1 = 100, k2 = 5, activation at 2, beta = 0.8. Loading follows k2 from the point (0.02, 2) of the elastic line, unloading follows k2 to the point (0.004, 0.4) of it, (1 - beta) times the activation.
} {
    check "force in loading" [stress {SelfCentering 1 100.0 5.0 2.0 0.8} {*}[path 0 0.1]] [expr {2.0 + 5.0*0.08}] 1e-10
    check "force in unloading" [stress {SelfCentering 1 100.0 5.0 2.0 0.8} {*}[path 0 0.1] {*}[path 0.1 0.05]] [expr {0.4 + 5.0*(0.05 - 0.004)}] 1e-10
    check "no force is left" [stress {SelfCentering 1 100.0 5.0 2.0 0.8} {*}[path 0 0.1] {*}[path 0.1 0.0]] 0.0 1e-10 1.0
}

sheet "Section of fibers" {"section Fiber" zeroLengthSection patch} \
    {Horne, Plastic Theory of Structures, 1} {
    A rectangle of 0.2 by 0.4 in 400 layers of an elastic, plastic steel of 300e3: moment E I phi while elastic, M = Mp (1 - (N / Np)^2), Mp = fy b h^2 / 4, under an axial force N of 0.4 Np.
} {
    foreach {what axial phi reference tolerance} {
        "elastic" 0.0 0.002 {2e8*0.2*0.4**3/12.0*0.002} 1e-5
        "plastic" 0.0 2.0 {300e3*0.2*0.4**2/4.0} 1e-3
        "plastic under axial force" 0.4 2.0 {300e3*0.2*0.4**2/4.0*(1.0 - 0.16)} 1e-3
    } {
        wipe
        model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 0; fix 1 1 1 1; fix 2 0 1 0
        uniaxialMaterial ElasticPP 1 2e8 0.0015
        section Fiber 1 {patch rect 1 400 1 -0.2 -0.1 0.2 0.1}
        element zeroLengthSection 1 1 2 1
        timeSeries Linear 1; timeSeries Constant 2
        pattern Plain 1 2 "load 2 [expr {-$axial*300e3*0.08}] 0 0"
        statics
        loadConst -time 0.0
        pattern Plain 2 1 {load 2 0 0 1.0}
        integrator DisplacementControl 2 3 [expr {$phi/200.0}]
        test NormDispIncr 1e-10 200
        if {[analyze 200] != 0} {error "no convergence"}
        check "moment, $what" [getTime] [expr $reference] $tolerance
    }
}
