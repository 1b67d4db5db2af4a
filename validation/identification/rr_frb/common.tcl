# What the three models share: the bearing of the paper's Table 5 under 170 kN, its top held against rotation and driven along x.
# Units: N, m, s. D 0.21, H 0.21, T_r 0.2, t_r 0.005, 40 layers, G_r 1.1e6, K_bulk 2e9.
set Gr 1.1e6
set Kbulk 2.0e9
set D  0.21
set H  0.21
set Tr 0.2
set A  [expr {$D*$D}]

proc bearing_nodes {} {
    global H
    node 1 0.0 0.0 0.0
    node 2 0.0 0.0 $H
    fix 1 1 1 1 1 1 1
    fix 2 0 1 0 1 1 1
    mass 2 100.0 100.0 100.0 1.0 1.0 1.0
}

# Vertical load, then the actuator's path in column u.
proc bearing_test {motion dt npts} {
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0.0 0.0 -170000.0 0.0 0.0 0.0 }
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-9 50
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} {error "no equilibrium under the vertical load"}
    loadConst -time 0.0
    wipeAnalysis

    timeSeries Path 2 -dt $dt -filePath $motion -useLast
    pattern Plain 2 2 { sp 2 1 1.0 }
    recorder Element -file force.out -time -ele 1 force
    recorder Node -file disp.out -time -node 2 -dof 1 disp
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-8 50
    algorithm Newton
    integrator LoadControl $dt
    analysis Static
    for {set i 1} {$i < $npts} {incr i} {
        # Where the bearing buckles under its load, Newton's method may go to and fro.
        if {[analyze 1] != 0} {
            test NormDispIncr 1.0e-8 500
            algorithm KrylovNewton
            if {[analyze 1] != 0} {
                algorithm NewtonLineSearch -type Bisection
                if {[analyze 1] != 0} {error "no convergence at [getTime]"}
            }
            test NormDispIncr 1.0e-8 50
            algorithm Newton
        }
    }
}
