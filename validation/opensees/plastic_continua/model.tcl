# Plastic and cracking laws in elements of continua, tetrahedra, and walls of panels.
# Units: kN, m in continua; N, mm in walls.

# Four seconds of a path, by steps of 0.05.
proc push {name responses {tolerance 1e-9}} {
    constraints Penalty 1e12 1e12
    numberer RCM
    system UmfPack
    test NormUnbalance $tolerance 300
    algorithm Newton
    integrator LoadControl 0.05
    analysis Static
    set out [open $name.out w]
    for {set i 1} {$i <= 80} {incr i} {
        if {[analyze 1] != 0} { error "$name stopped in step $i" }
        if {$i % 4 == 0} {
            set line {}
            foreach r $responses { lappend line {*}[eval $r] }
            puts $out [join $line " "]
        }
    }
    close $out
    wipe
}

proc laws {} {
    nDMaterial J2Plasticity 1 166.7 76.9 0.25 0.35 12.0 3.0
    nDMaterial Simplified3DJ2 2 76.9 166.7 0.25 3. 2.
    nDMaterial PlaneStressSimplifiedJ2 3 76.9 166.7 0.25 3. 2.
    nDMaterial ElasticOrthotropic 4 200. 150. 120. 0.3 0.2 0.15 60. 50. 45. 1.
    nDMaterial ElasticIsotropic 5 20. 0.2
    nDMaterial Parallel3D 6 1 5 -weights 0.8 1.5
    nDMaterial InitStrain 7 1 0.0002 0.0001 -0.0001 0.0003 0. 0.0001
    nDMaterial PlaneStress 8 2
    nDMaterial J2Plasticity 9 166.7 76.9 0.25 0.35 12.0 3.0 5.0
}

# Plane elements of an irregular shape.
foreach {name element} {
    quad_stress {element quad 1 1 2 3 4 0.5 PlaneStress 1}
    quad_strain {element quad 1 1 2 3 4 0.5 PlaneStrain 1}
    quad_simplified {element quad 1 1 2 3 4 0.5 PlaneStress 3}
    quad_wrapped {element quad 1 1 2 3 4 0.5 PlaneStress 8}
    quad_orthotropic {element quad 1 1 2 3 4 0.5 PlaneStress 4}
    stabilised_quad {element SSPquad 1 1 2 3 4 1 PlaneStrain 0.5}
    triangles {element tri31 1 1 2 3 0.5 PlaneStress 1; element tri31 2 1 3 4 0.5 PlaneStress 1}
    nine_nodes {element quad9n 1 1 2 3 4 5 6 7 8 9 0.5 PlaneStrain 1}
    eight_nodes {element quad8n 1 1 2 3 4 5 6 7 8 0.5 PlaneStress 1}
    six_nodes {element tri6n 1 1 2 3 5 6 9 0.5 PlaneStress 1; element tri6n 2 1 3 4 9 7 8 0.5 PlaneStress 1}
} {
    model basic -ndm 2 -ndf 2
    laws
    node 1 0 0; node 2 2 0.1; node 3 2.2 1.5; node 4 0 1.2; node 5 1 0.05; node 6 2.1 0.8; node 7 1.1 1.4; node 8 0 0.6
    node 9 1.05 0.7
    eval $element
    fix 1 1 1; fix 4 1 1; fix 8 1 1
    if {$name ni {nine_nodes eight_nodes six_nodes}} { foreach n {5 6 7} { fix $n 1 1 } }
    if {$name ni {nine_nodes six_nodes}} { fix 9 1 1 }
    timeSeries Path 1 -dt 1.0 -values {0 1 -1 1.3 0}
    pattern Plain 1 1 { load 2 0.04 -0.01; load 3 0.05 0.01 }
    push $name {{nodeDisp 2} {nodeDisp 3} {lrange [eleResponse 1 stresses] 0 2}}
}

# Two bricks, and tetrahedra.
foreach {name element} {
    brick {element stdBrick 1 1 2 3 4 5 6 7 8 1; element stdBrick 2 2 9 10 3 6 11 12 7 1}
    brick_mean_dilatation {element bbarBrick 1 1 2 3 4 5 6 7 8 1; element bbarBrick 2 2 9 10 3 6 11 12 7 1}
    brick_stabilised {element SSPbrick 1 1 2 3 4 5 6 7 8 1; element SSPbrick 2 2 9 10 3 6 11 12 7 1}
    brick_simplified {element stdBrick 1 1 2 3 4 5 6 7 8 2; element stdBrick 2 2 9 10 3 6 11 12 7 2}
    brick_parallel {element stdBrick 1 1 2 3 4 5 6 7 8 6; element stdBrick 2 2 9 10 3 6 11 12 7 6}
    brick_initial_strain {element stdBrick 1 1 2 3 4 5 6 7 8 7; element stdBrick 2 2 9 10 3 6 11 12 7 7}
    brick_viscous {element stdBrick 1 1 2 3 4 5 6 7 8 9; element stdBrick 2 2 9 10 3 6 11 12 7 9}
} {
    model basic -ndm 3 -ndf 3
    laws
    node 1 0 0 0; node 2 2 0.1 0.05; node 3 2.2 1.5 -0.1; node 4 0 1.2 0.1; node 5 0.1 0 1; node 6 2 0 1.3
    node 7 2.1 1.4 1.2; node 8 -0.1 1.3 1.1; node 9 4 0 0.2; node 10 4.1 1.3 0; node 11 4 0.1 1.4; node 12 3.9 1.6 1.3
    eval $element
    foreach n {1 4 5 8} { fix $n 1 1 1 }
    timeSeries Path 1 -dt 1.0 -values {0 1 -1 0.85 0}
    pattern Plain 1 1 { load 9 0.075 -0.01 0.015; load 12 0.075 0.01 -0.02; load 11 0.09 0.01 0; load 10 0.09 0 0 }
    push $name {{nodeDisp 9} {nodeDisp 12} {nodeDisp 6} {lrange [eleResponse 1 stresses] 0 2}}
}
foreach {name ten} {tetrahedra_linear 0 tetrahedra_quadratic 1} {
    model basic -ndm 3 -ndf 3
    laws
    node 1 0 0 0; node 2 2 0.1 0.05; node 3 0.2 1.5 -0.1; node 4 0.3 0.2 1.1; node 5 1.5 1.4 1.2
    timeSeries Path 1 -dt 1.0 -values {0 1 -1 1.3 0}
    foreach n {1 2 3} { fix $n 1 1 1 }
    if {$ten} {
        fix 5 1 1 1
        set n 10
        foreach {a b} {1 2 2 3 1 3 1 4 3 4 2 4} {
            incr n
            set at {}
            foreach d {1 2 3} { lappend at [expr {0.5*([nodeCoord $a $d] + [nodeCoord $b $d])}] }
            node $n {*}$at
        }
        foreach n {11 12 13} { fix $n 1 1 1 }
        element TenNodeTetrahedron 1 1 2 3 4 11 12 13 14 15 16 1
        pattern Plain 1 1 { load 4 0.0006 -0.0004 0.0006; load 15 0.0004 0.0004 -0.0006 }
        push $name {{nodeDisp 4} {nodeDisp 15}}
    } else {
        element FourNodeTetrahedron 1 1 2 3 4 1 0.01 0 -0.02
        element FourNodeTetrahedron 2 2 5 3 4 1
        pattern Plain 1 1 { load 4 0.03 -0.02 0.03; load 5 0.02 0.02 -0.03 }
        push $name {{nodeDisp 4} {nodeDisp 5} {eleResponse 1 stresses}}
    }
}

# Concrete: a brick in imposed deformations.
foreach {name options} {
    concrete_implicit {-cdf 0.5 -eta 0.01 -Kc 0.7}
    concrete_tangent {-tangent}
    concrete_extrapolated {-implex -implexAlpha 0.5 -cdf 0.3}
    concrete_scaled {-autoRegularization 1.5 -rho 1.}
} {
    model basic -ndm 3 -ndf 3
    nDMaterial ASDConcrete3D 1 30000. 0.2 -Te 0 0.0001 0.00015 0.0005 0.002 -Ts 0 3. 3.2 0.6 0.01 -Td 0 0 0.1 0.7 0.99 \
        -Ce 0 0.0005 0.001 0.0015 0.002 0.004 0.01 -Cs 0 15. 25. 29. 30. 15. 3. -Cd 0 0 0.05 0.12 0.2 0.6 0.9 {*}$options
    node 1 0 0 0; node 2 1 0 0; node 3 1 1 0; node 4 0 1 0; node 5 0 0 1; node 6 1 0 1; node 7 1 1 1; node 8 0 1 1
    element stdBrick 1 1 2 3 4 5 6 7 8 1
    fix 1 1 1 1; fix 4 1 0 1; fix 5 1 1 0; fix 8 1 0 0; fix 2 0 1 1; fix 3 0 0 1; fix 6 0 1 0
    timeSeries Path 1 -dt 1.0 -values {0 0.0003 -0.0012 0.0006 -0.002}
    pattern Plain 1 1 { foreach n {2 3 6 7} { sp $n 1 1.0 }; sp 8 2 0.2; sp 7 3 0.1 }
    push $name {{nodeDisp 7} {lrange [eleResponse 1 stresses] 0 0} {eleResponse 1 material 1 damage}} 1e-6
}

# Walls of panels, pushed to and fro.
foreach {name space element} {
    wall_panels 0 {SFI_MVLEM %t 5 0.4}
    wall_shear_strain 0 {E_SFI %t 5 0.4}
    wall_panels_space 1 {SFI_MVLEM_3D %t 5}
    wall_shear_strain_space 1 {E_SFI_MVLEM_3D %t 5}
    wall_lines_space 1 {MVLEM_3D %t 5}
} {
    if {$space} {
        model basic -ndm 3 -ndf 6
        node 1 0 0 0; node 2 1200 0 0; node 3 1200 0 600; node 4 0 0 600; node 5 1200 0 1200; node 6 0 0 1200
        fix 1 1 1 1 1 1 1; fix 2 1 1 1 1 1 1
        set nodes {{1 2 3 4} {4 3 5 6}}
    } else {
        model basic -ndm 2 -ndf 3
        node 1 0 0; node 2 0 600; node 5 0 1200
        fix 1 1 1 1
        set nodes {{1 2} {2 5}}
    }
    uniaxialMaterial SteelMPF 1 450 430 200000 0.012 0.011 20 0.925 0.15
    uniaxialMaterial SteelMPF 2 440 420 200000 0.012 0.011 20 0.925 0.15
    uniaxialMaterial ConcreteCM 3 -42 -0.0024 35000 7 1.035 2.1 0.00008 1.2 10000
    uniaxialMaterial Elastic 4 900000.
    nDMaterial FSAM 6 0.0 1 2 3 0.0027 0.0082 1.0 0.005
    nDMaterial FSAM 7 0.0 1 2 3 0.005 0.03 0.3 0.01
    set tag 0
    foreach n $nodes {
        incr tag
        set words [string map [list %t "$tag $n"] $element]
        lappend words -thick 150 150 150 150 150 -width 150 250 400 250 150
        if {$name eq "wall_lines_space"} {
            lappend words -rho 0.03 0.008 0.008 0.008 0.03 -matConcrete 3 3 3 3 3 -matSteel 2 2 2 2 2 -matShear 4 -CoR 0.45
        } else {
            lappend words -mat 7 6 6 6 7
        }
        element {*}$words
    }
    timeSeries Linear 1
    if {$space} {
        pattern Plain 1 1 { load 5 0 0 -200000 0 0 0; load 6 0 0 -200000 0 0 0 }
    } else {
        pattern Plain 1 1 { load 5 0 -400000 0 }
    }
    constraints Plain
    numberer RCM
    system UmfPack
    test NormDispIncr 1e-9 300
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} { error "$name does not carry its weight" }
    loadConst -time 0
    if {$space} {
        pattern Plain 2 1 { load 5 1.0 0.02 0 5. 3. 2.; load 6 1.0 0.01 0 0 0 0; load 3 0 -0.01 0 1 2 3 }
    } else {
        pattern Plain 2 1 { load 5 1.0 0 0 }
    }
    set out [open $name.out w]
    set at 0.0
    foreach peak {0.25 -0.2} {
        set step [expr {($peak - $at)/60}]
        set at $peak
        integrator DisplacementControl 5 1 $step
        for {set i 1} {$i <= 60} {incr i} {
            if {[analyze 1] != 0} { error "$name stopped at $peak in step $i" }
            if {$i % 5 == 0} { puts $out "[getTime] [nodeDisp 5] [eleResponse 1 Curvature]" }
        }
    }
    close $out
    wipe
}

# bbarQuad with elasticity and plasticity, and laws around others: a plane strip pulled in cycles, and its modes.
proc cyclesOf {node dof parts} {
    constraints Plain
    numberer RCM
    system UmfPack
    test NormDispIncr 1e-10 60
    algorithm Newton
    analysis Static
    foreach {step count} $parts {
        integrator DisplacementControl $node $dof $step
        puts "[analyze $count]"
    }
}
model basic -ndm 2 -ndf 2
nDMaterial J2Plasticity 1 1.6e5 8e4 300. 330. 20. 20000.
nDMaterial ElasticIsotropic 2 2e5 0.49 7.8e-9
foreach {n x y} {1 0. 0. 2 10. 0. 3 22. 0. 4 0. 8. 5 9. 7. 6 20. 9. 7 0. 15. 8 11. 16. 9 20. 15.} { node $n $x $y }
element bbarQuad 1 1 2 5 4 2. 1
element bbarQuad 2 2 3 6 5 2. 1
element bbarQuad 3 4 5 8 7 2. 2
element bbarQuad 4 5 6 9 8 2. 2
fix 1 1 1
fix 4 1 0
fix 7 1 0
set file [open bbar_modes.out w]
puts $file [eigen -fullGenLapack 3]
close $file
recorder Node -file bbar_disp.out -precision 10 -time -node 3 6 8 9 -dof 1 2 disp
recorder Element -file bbar_force.out -precision 10 -ele 1 3 force
recorder Element -file bbar_point.out -precision 10 -ele 1 material 2 stress
recorder Element -file bbar_strain.out -precision 10 -ele 3 material 4 strain
pattern Plain 1 Linear { load 3 1. 0.; load 6 1. 0.2; load 9 1. 0.1 }
cyclesOf 9 1 {0.002 45}
wipe
# InitStress and Series3D in bricks.
model basic -ndm 3 -ndf 3
foreach {n x y z} {1 0 0 0 2 1 0 0 3 1 1 0 4 0 1 0 5 0 0 1 6 1.1 0 1 7 1 1 1.1 8 0 1 1} { node $n $x $y $z }
foreach {n x y z} {11 3 0 0 12 4 0 0 13 4 1 0 14 3 1 0 15 3 0 1 16 4.1 0 1 17 4 1 1.1 18 3 1 1} { node $n $x $y $z }
nDMaterial J2Plasticity 1 1.6e5 8e4 300. 400. 20. 500.
nDMaterial ElasticIsotropic3D 2 9e4 0.2
nDMaterial Series3D 3 1 2 -weights 0.6 0.5 -maxIter 50 -relTol 1e-10 -absTol 1e-10
nDMaterial ElasticIsotropic3D 4 9e4 0.2
nDMaterial InitStress 5 4 -120.
element stdBrick 1 1 2 3 4 5 6 7 8 3
element stdBrick 2 11 12 13 14 15 16 17 18 5
foreach n {1 2 3 4 11 12 13 14} { fix $n 1 1 1 }
recorder Node -file wrapped_disp.out -precision 10 -time -node 5 7 15 17 -dof 1 2 3 disp
recorder Element -file wrapped_stress.out -precision 10 -ele 1 2 material 3 stress
pattern Plain 1 Linear {
    foreach n {5 6 7 8 15 16 17 18} { load $n 0.5 0. 1. }
}
constraints Plain
numberer RCM
system UmfPack
test NormDispIncr 1e-11 60
algorithm Newton
analysis Static
foreach {step count} {4. 20 -4. 40 4. 30} {
    integrator LoadControl $step
    puts "[analyze $count]"
}
wipe
# NDFiber sections: cantilevers in the plane and in space, with shear.
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 0. 300.
node 3 500. 0.
node 4 500. 300.
fix 1 1 1 1
fix 3 1 1 1
nDMaterial J2BeamFiber 1 2e5 0.3 300. 0. 4000.
nDMaterial J2Plasticity 2 1.6e5 8e4 300. 400. 20. 500.
nDMaterial BeamFiber2d 3 2
section NDFiber 1 { patch rect 1 8 1 -50. -30. 50. 30.; fiber 60. 0. 200. 1 }
section NDFiber 2 -alpha 0.8 { patch rect 3 8 1 -50. -30. 50. 30. }
geomTransf Linear 1
element forceBeamColumn 1 1 2 4 1 1 -iter 30 1e-12
element forceBeamColumn 2 3 4 4 2 1 -iter 30 1e-12
recorder Node -file ndfiber_plane_disp.out -precision 10 -time -node 2 4 -dof 1 2 3 disp
recorder Element -file ndfiber_plane_force.out -precision 10 -ele 1 2 section 1 force
recorder Element -file ndfiber_plane_fiber.out -precision 10 -ele 1 2 section 1 fiber 0. 0. stress
pattern Plain 1 Linear { load 2 1. -0.5 0.; load 4 0.6 0. 0. }
cyclesOf 2 1 {0.25 40 -0.25 80 0.25 40}
wipe
model basic -ndm 3 -ndf 6
node 1 0. 0. 0.
node 2 0. 0. 300.
fix 1 1 1 1 1 1 1
nDMaterial J2BeamFiber 1 2e5 0.3 300. 2000. 4000.
nDMaterial J2Plasticity 2 1.6e5 8e4 300. 400. 20. 500.
nDMaterial BeamFiber 3 2
section NDFiber 1 -alpha 0.85 { patch rect 1 6 6 -50. -30. 50. 30.; fiber 55. 35. 200. 3; fiber -55. 35. 200. 3 }
geomTransf Linear 1 1 0 0
element forceBeamColumn 1 1 2 4 1 1 -iter 30 1e-12
recorder Node -file ndfiber_space_disp.out -precision 10 -time -node 2 -dof 1 2 3 4 5 6 disp
recorder Element -file ndfiber_space_force.out -precision 10 -ele 1 section 1 force
pattern Plain 1 Linear { load 2 1. 0.4 -0.5 0. 0. 30. }
cyclesOf 2 1 {0.25 30 -0.25 60 0.25 30}
wipe

# A fibre section of plane stress in beams with shear.
model basic -ndm 2 -ndf 3
node 1 0. 0.
node 2 0. 300.
node 3 500. 0.
node 4 500. 300.
fix 1 1 1 1
fix 3 1 1 1
nDMaterial J2Plasticity 2 1.6e5 8e4 300. 400. 20. 500.
nDMaterial BeamFiber2dPS 3 2
section NDFiber 1 -noCentroid { patch rect 3 6 1 -50. -30. 50. 30. }
geomTransf PDelta 1
element forceBeamColumn 1 1 2 3 1 1 -iter 30 1e-12
element dispBeamColumn 2 3 4 3 1 1
recorder Node -file ndfiber_stress_disp.out -precision 10 -time -node 2 4 -dof 1 2 3 disp
recorder Element -file ndfiber_stress_force.out -precision 10 -ele 1 2 section 1 force
pattern Plain 1 Linear { load 2 1. -0.5 0.; load 4 0.6 0. 0. }
cyclesOf 2 1 {0.25 30 -0.25 60 0.25 30}
wipe
