# Columns of one element that feels its own deflection, pushed to and fro under axial load: an elastic one, one of fibers and
# one of fibers that shears in the plane, and one of fibers in space, pushed along both axes.
# N, mm
proc fibers {} {
    uniaxialMaterial Steel02 1 300. 2.e5 0.02 18. 0.925 0.15
    uniaxialMaterial Elastic 2 2.0e7
}
proc push {node dof steps} {
    foreach step $steps {
        integrator DisplacementControl $node $dof $step
        analyze 12
    }
}
proc analysis_of {} {
    constraints Plain
    numberer Plain
    system FullGeneral
    test NormDispIncr 1e-10 50
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
}
proc plane {name element transf sections} {
    wipe
    model basic -ndm 2 -ndf 3
    node 1 0 0; node 2 0. 3000.
    fix 1 1 1 1
    eval $sections
    geomTransf $transf 1
    beamIntegration Lobatto 1 1 5
    element $element 1 1 2 1 1
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0. -3e5 0. }
    recorder Node -file ${name}_disp.out -precision 10 -time -node 2 -dof 1 2 3 disp
    recorder Element -file ${name}_force.out -precision 10 -ele 1 force
    recorder Element -file ${name}_section.out -precision 10 -ele 1 section 1 force
    analysis_of
    analyze 10
    loadConst -time 0.
    pattern Plain 2 1 { load 2 1000. 0. 0. }
    push 2 1 {3. -5. 4.}
    wipe
}
plane elastic forceBeamColumnCBDI PDelta { section Elastic 1 200000. 6000. 2.0e7 }
plane fibers forceBeamColumnCBDI PDelta { fibers; section Fiber 1 { patch rect 1 16 1 -100. -15. 100. 15. } }
plane shear forceBeamColumnCSBDI Corotational { fibers; section Fiber 2 { patch rect 1 16 1 -100. -15. 100. 15. }
    section Aggregator 1 2 Vy -section 2 }
wipe
model basic -ndm 3 -ndf 6
node 1 0 0 0; node 2 0. 0. 3000.
fix 1 1 1 1 1 1 1
fibers
section Fiber 1 -GJ 1e11 { patch rect 1 10 6 -100. -60. 100. 60. }
geomTransf PDelta 1 1. 0. 0.
beamIntegration Lobatto 1 1 5
element forceBeamColumnCBDI 1 1 2 1 1
timeSeries Linear 1
pattern Plain 1 1 { load 2 0. 0. -6e5 0. 0. 0. }
recorder Node -file space_disp.out -precision 10 -time -node 2 -dof 1 2 3 4 5 6 disp
recorder Node -file space_reaction.out -precision 10 -node 1 -dof 1 2 4 5 reaction
analysis_of
# The forces of the element are known to its own tolerance only.
test NormDispIncr 1e-7 50
analyze 10
loadConst -time 0.
pattern Plain 2 1 { load 2 1000. 700. 0. 0. 0. 0. }
push 2 1 {3. -5. 4.}
