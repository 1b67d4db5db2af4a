# Trusses, springs and constraints.
source [file join [file dirname [info script]] sheets.tcl]

sheet "Two bars" {Truss Elastic} \
    {statics} {
    Two bars of stiffness E A, each at 60 degrees from the vertical, carry a force P: deflection P l / (2 E A cos^2 60), force P in each.
} {
    model basic -ndm 2 -ndf 2
    node 1 [expr {-sqrt(3.0)}] 1; node 2 [expr {sqrt(3.0)}] 1; node 3 0 0
    fix 1 1 1; fix 2 1 1
    uniaxialMaterial Elastic 1 2e8; timeSeries Linear 1
    element Truss 1 1 3 0.001 1; element Truss 2 2 3 0.001 1
    pattern Plain 1 1 {load 3 0 -50.0}
    statics
    check "deflection" [nodeDisp 3 2] [expr {-50.0*2.0/(2.0*2e8*0.001*0.25)}] 1e-12
    check "force of a bar" [lindex [eleResponse 1 axialForce] 0] 50.0 1e-12
}

sheet "Snap-through of a shallow truss" {CorotTruss DisplacementControl} \
    {von Mises (1923), Zeitschrift fuer angewandte Mathematik und Mechanik 3, 406-422} {
    Two bars over a half span b = 10 rise by h = 1. With the strain (l - l0) / l0 the load at a deflection w is 2 E A (l0 - l) / l0 * (h - w) / l,
    l^2 = b^2 + (h - w)^2. It is followed beyond both limit points.
} {
    model basic -ndm 2 -ndf 2
    node 1 -10 0; node 2 10 0; node 3 0 1
    fix 1 1 1; fix 2 1 1; fix 3 1 0
    uniaxialMaterial Elastic 1 1e6; timeSeries Linear 1
    element CorotTruss 1 1 3 0.01 1; element CorotTruss 2 2 3 0.01 1
    pattern Plain 1 1 {load 3 0 -1.0}
    constraints Plain; numberer RCM; system UmfPack; test NormDispIncr 1e-12 50; algorithm Newton
    integrator DisplacementControl 3 2 -0.05; analysis Static
    foreach steps {8 12 12 10} {
        analyze $steps
        set w [expr {-[nodeDisp 3 2]}]; set l0 [expr {sqrt(101.0)}]; set l [expr {sqrt(100.0 + (1.0 - $w)**2)}]
        check "load at a deflection of [format %.1f $w]" [getTime] [expr {2.0*1e4*($l0 - $l)/$l0*(1.0 - $w)/$l}] 1e-9 1.0
    }
}

sheet "Springs in parallel and in series" {zeroLength Parallel Series Elastic} \
    {statics} {
    Springs of 100 and 300 side by side have 400, one behind the other 75, as elements and as materials.
} {
    foreach {how make stiffness} {
        "elements side by side" {element zeroLength 1 1 3 -mat 1 -dir 1; element zeroLength 2 1 3 -mat 2 -dir 1; fix 2 1} 400
        "elements in series" {element zeroLength 1 1 2 -mat 1 -dir 1; element zeroLength 2 2 3 -mat 2 -dir 1} 75
        "materials side by side" {uniaxialMaterial Parallel 3 1 2; element zeroLength 1 1 3 -mat 3 -dir 1; fix 2 1} 400
        "materials in series" {uniaxialMaterial Series 3 1 2; element zeroLength 1 1 3 -mat 3 -dir 1; fix 2 1} 75
    } {
        wipe
        model basic -ndm 1 -ndf 1
        node 1 0; node 2 0; node 3 0; fix 1 1
        uniaxialMaterial Elastic 1 100.0; uniaxialMaterial Elastic 2 300.0; timeSeries Linear 1
        eval $make
        pattern Plain 1 1 {load 3 30.0}
        statics
        check $how [nodeDisp 3 1] [expr {30.0/$stiffness}] 1e-12
    }
}

sheet "Link with a length" {twoNodeLink} \
    {equilibrium} {
    A link of length 2 with a shear spring of 500 and both ends held against rotation is sheared by a force of 10. The moments of its ends are shares
    of force times length: half each, or as -shearDist says.
} {
    foreach {what options first} {"halves" {} 0.5 "a third at the first end" {-shearDist 0.3333333333333333} 0.3333333333333333} {
        wipe
        model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 2; fix 1 1 1 1; fix 2 0 0 1
        uniaxialMaterial Elastic 1 1e5; uniaxialMaterial Elastic 2 500.0; uniaxialMaterial Elastic 3 1e6; timeSeries Linear 1
        element twoNodeLink 1 1 2 -mat 1 2 3 -dir 1 2 3 {*}$options
        pattern Plain 1 1 {load 2 10.0 0 0}
        statics
        reactions
        check "deflection, $what" [nodeDisp 2 1] 0.02 1e-12
        check "moment at the first end, $what" [nodeReaction 1 3] [expr {20.0*$first}] 1e-9
        check "moment at the second end, $what" [nodeReaction 2 3] [expr {20.0*(1.0 - $first)}] 1e-9
    }
}

sheet "Rigid floor" {rigidDiaphragm Transformation Lagrange Penalty} \
    {statics} {
    Four springs at the corners of a floor of 6 by 4, two of 100 in x and two of 100 and 300 in y, are pushed by a force of 30 in y at the centre. The floor
    turns about the centre of stiffness, 1.5 from the centre: deflection 30 / 400, rotation 45 / (300 * 1.5^2 + 100 * 4.5^2 + 2 * 100 * 2^2).
} {
    foreach {handler tolerance} {Transformation 1e-10 Lagrange 1e-10 {Penalty 1e9 1e9} 1e-5} {
        wipe
        model basic -ndm 3 -ndf 6
        uniaxialMaterial Elastic 1 100.0; uniaxialMaterial Elastic 3 300.0; timeSeries Linear 1
        foreach {n x y} {1 -3 0 2 3 0 3 0 -2 4 0 2} {
            node $n $x $y 0; node 1$n $x $y 0; fix $n 1 1 1 1 1 1; fix 1$n 0 0 1 1 1 0
        }
        node 20 0 0 0; fix 20 0 0 1 1 1 0
        rigidDiaphragm 3 20 11 12 13 14
        element zeroLength 1 1 11 -mat 1 -dir 2; element zeroLength 2 2 12 -mat 3 -dir 2
        element zeroLength 3 3 13 -mat 1 -dir 1; element zeroLength 4 4 14 -mat 1 -dir 1
        pattern Plain 1 1 {load 20 0 30.0 0 0 0 0}
        constraints {*}$handler; numberer RCM; system UmfPack; test NormDispIncr 1e-10 20; algorithm Newton
        integrator LoadControl 1; analysis Static; analyze 1
        set turn [expr {-45.0/(300.0*1.5**2 + 100.0*4.5**2 + 2.0*100.0*4.0)}]
        check "rotation, [lindex $handler 0]" [nodeDisp 20 6] $turn $tolerance
        check "deflection of the centre, [lindex $handler 0]" [nodeDisp 20 2] [expr {30.0/400.0 - 1.5*$turn}] $tolerance
    }
}
