# Beams and columns.
source [file join [file dirname [info script]] sheets.tcl]

set E 2.0e8; set A 0.02; set I 1.5e-4; set L 3.0

# A cantilever of n elements along x. `element` makes one of TAG between I and J.
proc cantilever {n element {transformation Linear}} {
    global E A I L
    wipe
    model basic -ndm 2 -ndf 3
    for {set i 0} {$i <= $n} {incr i} {node [expr {$i + 1}] [expr {$L*$i/$n}] 0.0}
    fix 1 1 1 1
    geomTransf $transformation 1
    section Elastic 7 $E $A $I
    timeSeries Linear 1
    for {set i 1} {$i <= $n} {incr i} {eval [string map [list TAG $i I $i J [expr {$i + 1}]] $element]}
}

set elements {
    elasticBeamColumn {element elasticBeamColumn TAG I J 0.02 2e8 1.5e-4 1}
    dispBeamColumn    {element dispBeamColumn TAG I J 5 7 1}
    forceBeamColumn   {element forceBeamColumn TAG I J 5 7 1}
}

sheet "Cantilever with a load at its end" {elasticBeamColumn dispBeamColumn forceBeamColumn "section Elastic" Linear} \
    {Gere and Goodno, Mechanics of Materials, deflections of beams} {
    A cantilever of length L carries a transverse force P at its end: deflection P L^3 / (3 E I), rotation P L^2 / (2 E I), moment P L.
} {
    foreach {name element} $elements {
        cantilever 1 $element
        pattern Plain 1 1 {load 2 0 12.0 0}
        statics
        check "deflection, $name" [nodeDisp 2 2] [expr {12.0*$L**3/(3.0*$E*$I)}] 1e-10
        check "rotation, $name" [nodeDisp 2 3] [expr {12.0*$L**2/(2.0*$E*$I)}] 1e-10
        reactions
        check "moment at the support, $name" [nodeReaction 1 3] [expr {-12.0*$L}] 1e-10
    }
}

sheet "Cantilever that deforms in shear" {ElasticTimoshenkoBeam} \
    {Gere and Goodno, Mechanics of Materials, deflections by shear} {
    The deflection at the end of a short cantilever is P L^3 / (3 E I) + P L / (G As).
} {
    model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 0.6 0; fix 1 1 1 1
    geomTransf Linear 1; timeSeries Linear 1
    element ElasticTimoshenkoBeam 1 1 2 2e8 8e7 0.02 1.5e-4 0.012 1
    pattern Plain 1 1 {load 2 0 12.0 0}
    statics
    check "deflection" [nodeDisp 2 2] [expr {12.0*0.6**3/(3.0*2e8*1.5e-4) + 12.0*0.6/(8e7*0.012)}] 1e-10
}

sheet "Loads between the ends" {elasticBeamColumn forceBeamColumn eleLoad} \
    {Gere and Goodno, Mechanics of Materials, statically indeterminate beams} {
    A beam with both ends fixed under a uniform load w has end moments w L^2 / 12. A propped cantilever with a force P at midspan has the reaction
    5 P / 16 at the prop. A cantilever under a uniform load deflects w L^4 / (8 E I).
} {
    foreach {name element} {elasticBeamColumn {element elasticBeamColumn 1 1 2 0.02 2e8 1.5e-4 1} forceBeamColumn {element forceBeamColumn 1 1 2 5 7 1}} {
        # Sections of a force-based beam do not see a kink between them.
        foreach {what end load result reference} {
            "end moment" {1 1 1} {eleLoad -ele 1 -type -beamUniform -9.0} {nodeReaction 1 3} {9.0*$L**2/12.0}
            "reaction of the prop" {0 1 0} {eleLoad -ele 1 -type -beamPoint -9.0 0.5} {nodeReaction 2 2} {9.0*5.0/16.0}
            "deflection under a uniform load" {0 0 0} {eleLoad -ele 1 -type -beamUniform -9.0} {nodeDisp 2 2} {-9.0*$L**4/(8.0*$E*$I)}
        } {
            if {$name eq "forceBeamColumn" && [string match *beamPoint* $load]} continue
            wipe
            model basic -ndm 2 -ndf 3
            node 1 0 0; node 2 $L 0; fix 1 1 1 1; fix 2 {*}$end
            geomTransf Linear 1; section Elastic 7 $E $A $I; timeSeries Linear 1
            eval $element
            pattern Plain 1 1 $load
            statics
            reactions
            check "$what, $name" [eval $result] [expr $reference] 1e-10
        }
    }
}

sheet "Cantilever in space" {elasticBeamColumn dispBeamColumn forceBeamColumn} \
    {Gere and Goodno, Mechanics of Materials} {
    A cantilever along a skew axis is bent in two planes and twisted. Deflections along its principal axes are P L^3 / (3 E I), the twist is T L / (G J).
} {
    foreach {name element} {
        elasticBeamColumn {element elasticBeamColumn 1 1 2 0.02 2e8 8e7 1e-4 2e-4 3e-4 1}
        dispBeamColumn {element dispBeamColumn 1 1 2 5 7 1}
        forceBeamColumn {element forceBeamColumn 1 1 2 5 7 1}
    } {
        wipe
        model basic -ndm 3 -ndf 6
        # Axis (2 1 2)/3, local z (1 -2 0) / sqrt 5 up to its sign.
        node 1 0 0 0; node 2 2 1 2; fix 1 1 1 1 1 1 1
        geomTransf Linear 1 1 -2 0
        section Elastic 7 2e8 0.02 3e-4 2e-4 8e7 1e-4
        timeSeries Linear 1
        eval $element
        set z [lmap x {1 -2 0} {expr {$x/sqrt(5.0)}}]
        lassign [lmap x {2 1 2} {expr {$x/3.0}}] x1 x2 x3
        lassign $z z1 z2 z3
        set y [list [expr {$z2*$x3 - $z3*$x2}] [expr {$z3*$x1 - $z1*$x3}] [expr {$z1*$x2 - $z2*$x1}]]
        pattern Plain 1 1 "load 2 [lmap c $y {expr {6.0*$c}}] [lmap c [list $x1 $x2 $x3] {expr {4.0*$c}}]"
        pattern Plain 2 1 "load 2 [lmap c $z {expr {5.0*$c}}] 0 0 0"
        statics
        proc along {axis dofs} {set s 0.0; foreach c $axis d $dofs {set s [expr {$s + $c*[nodeDisp 2 $d]}]}; return $s}
        check "deflection along z, bent about y, $name" [along $z {1 2 3}] [expr {5.0*27.0/(3.0*2e8*2e-4)}] 1e-10
        check "deflection along y, bent about z, $name" [along $y {1 2 3}] [expr {6.0*27.0/(3.0*2e8*3e-4)}] 1e-10
        check "twist, $name" [along [list $x1 $x2 $x3] {4 5 6}] [expr {4.0*3.0/(8e7*1e-4)}] 1e-10
    }
}

sheet "Column under axial load" {PDelta Corotational elasticBeamColumn} \
    {Timoshenko and Gere, Theory of Elastic Stability, 1.11} {
    A cantilever under an axial force P of a third of its Euler load and a transverse force H deflects H L^3 / (3 E I) * 3 (tan u - u) / u^3, u = L sqrt(P / E I).
    Twenty elements stand for the beam-column.
} {
    set P [expr {acos(-1.0)**2*$E*$I/(12.0*$L**2)}]
    set u [expr {$L*sqrt($P/($E*$I))}]
    foreach transformation {PDelta Corotational} {
        cantilever 20 {element elasticBeamColumn TAG I J 20.0 2e8 1.5e-4 1} $transformation
        pattern Plain 1 1 "load 21 -$P 0.001 0"
        statics
        check "deflection, $transformation" [nodeDisp 21 2] [expr {0.001*$L**3/(3.0*$E*$I)*3.0*(tan($u) - $u)/$u**3}] 5e-4
    }
}

sheet "Cantilever rolled into a circle" {Corotational elasticBeamColumn} \
    {Euler; Simo and Vu-Quoc (1986), Computer Methods in Applied Mechanics and Engineering 58, 79-116} {
    An end moment M bends a cantilever to a circle of radius E I / M: to the half of it for M = pi E I / L. Chords of 40 elements stand for the arc.
} {
    cantilever 40 {element elasticBeamColumn TAG I J 0.02 2e8 1.5e-4 1} Corotational
    set M [expr {acos(-1.0)*$E*$I/$L}]
    pattern Plain 1 1 "load 41 0 0 $M"
    statics 40
    check "rotation of the end" [nodeDisp 41 3] [expr {acos(-1.0)}] 1e-8
    check "height of the end" [nodeDisp 41 2] [expr {2.0*$L/acos(-1.0)}] 1e-3
    check "way of the end along the axis" [nodeDisp 41 1] [expr {-$L}] 1e-3
}

sheet "Rigid ends" {-jntOffset elasticBeamColumn} \
    {statics} {
    A beam with rigid ends of 0.4 and 0.6 between fixed supports, one of which settles by d. The flexible part has the length a = 2: moments at its ends
    6 E I d / a^2 + shear times the rigid end, shear 12 E I d / a^3.
} {
    model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 3 0; fix 1 1 1 1; fix 2 1 0 1
    geomTransf Linear 1 -jntOffset 0.4 0 -0.6 0; timeSeries Linear 1
    element elasticBeamColumn 1 1 2 $A $E $I 1
    pattern Plain 1 1 {sp 2 2 0.01}
    statics 1 Transformation
    reactions
    set V [expr {12.0*$E*$I*0.01/8.0}]
    check "shear" [nodeReaction 2 2] $V 1e-8
    check "moment at the first support" [nodeReaction 1 3] [expr {-$V*(1.0 + 0.4)}] 1e-8
    check "moment at the second support" [nodeReaction 2 3] [expr {-$V*(1.0 + 0.6)}] 1e-8
}
