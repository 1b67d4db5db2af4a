# A reinforced concrete portal that yields above isolators: how much of the drift is left for the columns.
#
#   One bay of 6 m, one storey of 3.5 m. Columns 0.4 m x 0.4 m of fibers (force-based, P-Delta), an elastic beam. The same
#   frame twice: on a fixed base, and on two bearings with a bilinear law of shear (springs in parallel with P). Pushed
#   sideways at the roof, then shaken by one component of the record of the Meloland overpass, free field, Imperial
#   Valley 1979 (see ground_motions/README.md).
#
#        3 o===========o 4      roof
#          |           |
#        1 o           o 2      column feet
#          #           #        bearings, or nothing
#
# Concrete after Mander, Priestley and Park (1988): the core is confined by the hoops, the cover is not.
# Units: kN, m, s, t.

set here [file dirname [info script]]
set g 9.81

# Builds the frame; isolated or not. Returns its first period.
proc portal {isolated} {
    wipe
    model BasicBuilder -ndm 2 -ndf 3
    node 1 0.0 0.0
    node 2 6.0 0.0
    node 3 0.0 3.5
    node 4 6.0 3.5

    # Unconfined cover, confined core (strength, its strain, what is left, the strain from where), and bars of 420 MPa.
    uniaxialMaterial Concrete01 1 -30.0e3 -0.002 -6.0e3 -0.006
    uniaxialMaterial Concrete02 2 -38.0e3 -0.004 -20.0e3 -0.020 0.1 2.5e3 1.2e6
    uniaxialMaterial Steel02 3 420.0e3 2.0e8 0.01 18.0 0.925 0.15

    # y is across the axis of bending: the section bends in the plane of the frame.
    section Fiber 1 {
        patch rect 2 16 1 -0.16 -0.16 0.16 0.16
        patch rect 1 20 1 -0.20 -0.20 0.20 -0.16
        patch rect 1 20 1 -0.20 0.16 0.20 0.20
        patch rect 1 2 1 -0.20 -0.16 -0.16 0.16
        patch rect 1 2 1 0.16 -0.16 0.20 0.16
        layer straight 3 3 3.14e-4 0.15 0.15 0.15 -0.15
        layer straight 3 2 3.14e-4 0.00 0.15 0.00 -0.15
        layer straight 3 3 3.14e-4 -0.15 0.15 -0.15 -0.15
    }
    geomTransf PDelta 1
    geomTransf Linear 2
    beamIntegration Lobatto 1 1 5
    element forceBeamColumn 1 1 3 1 1
    element forceBeamColumn 2 2 4 1 1
    element elasticBeamColumn 3 3 4 0.20 2.6e7 4.2e-3 2

    mass 3 20.0 20.0 0.0
    mass 4 20.0 20.0 0.0
    if {$isolated} {
        # Base slab of 30 t; bearings with 0.6 MN/m after yield and 25 kN of strength each.
        mass 1 15.0 15.0 0.0
        mass 2 15.0 15.0 0.0
        equalDOF 1 2 1
        node 11 0.0 0.0
        node 12 6.0 0.0
        fix 11 1 1 1
        fix 12 1 1 1
        fix 1 0 0 1
        fix 2 0 0 1
        uniaxialMaterial Steel01 11 27.3 6.6e3 0.091
        uniaxialMaterial Elastic 12 2.0e6
        element zeroLength 11 11 1 -mat 11 12 -dir 1 2
        element zeroLength 12 12 2 -mat 11 12 -dir 1 2
    } else {
        fix 1 1 1 1
        fix 2 1 1 1
    }

    # Weight first: it closes the cracks, and P-Delta needs it.
    timeSeries Linear 1
    pattern Plain 1 1 {
        load 3 0.0 -196.2 0.0
        load 4 0.0 -196.2 0.0
    }
    constraints Transformation
    numberer RCM
    system BandGeneral
    test NormDispIncr 1.0e-9 50
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} { error "no equilibrium under the weight" }
    loadConst -time 0.0
    return [expr {2.0*acos(-1.0)/sqrt([lindex [eigen 1] 0])}]
}

# ---------------------------------------------------------------- strength of the fixed frame
set period [portal 0]
puts [format "fixed base: first period %.3f s" $period]
pattern Plain 2 1 {
    load 3 1.0 0.0 0.0
    load 4 1.0 0.0 0.0
}
integrator DisplacementControl 3 1 0.001
set strength 0.0
for {set i 1} {$i <= 70} {incr i} {
    if {[analyze 1] != 0} { error "the push failed at step $i" }
    set shear [expr {2.0*[getTime]}]
    if {$shear > $strength} { set strength $shear; set at [nodeDisp 3 1] }
}
puts [format "  strength %.0f kN at a drift of %.2f %%" $strength [expr {100.0*$at/3.5}]]
puts [format "  curvature of the foot at a drift of 2 %%: %.4f 1/m" [lindex [eleResponse 1 section 1 deformation] 1]]

# ---------------------------------------------------------------- both frames under the earthquake
foreach {name isolated} {"fixed base" 0 isolated 1} {
    set period [portal $isolated]
    rayleigh 0.0 0.0 0.0 0.004
    timeSeries Path 5 -dt 0.005 -filePath [file join $here ground_motions meloland_1979_270_g.txt] -factor [expr {1.5*$g}]
    pattern UniformExcitation 5 1 -accel 5
    wipeAnalysis
    constraints Transformation
    numberer RCM
    system BandGeneral
    test NormDispIncr 1.0e-8 50
    algorithm KrylovNewton
    integrator Newmark 0.5 0.25
    analysis Transient
    set drift 0.0
    for {set i 1} {$i <= 2400} {incr i} {
        if {[analyze 1 0.005] != 0} { error "$name: no convergence at [getTime] s" }
        set d [expr {abs([nodeDisp 3 1] - [nodeDisp 1 1])/3.5}]
        if {$d > $drift} { set drift $d }
    }
    puts [format "%s: first period %.2f s, largest drift %.2f %%, left at the foot %.5f rad" \
        $name $period [expr {100.0*$drift}] [lindex [eleResponse 1 plasticDeformation] 1]]
}
