# The bearing that is concealed in the study, for OpenSees: KikuchiBearing with the compound X0.6 and softer axial springs than those of rigid
# plates bonded to their supports (validation/identification/rr_frb). Writes force_light.out and so on in the current folder.
# Units: N, m, s.
set size 0.21
set thickness 0.2
set pi [expr {acos(-1.0)}]
foreach {name axial} {light 40.0e3 middle 110.0e3 heavy 180.0e3 other 150.0e3} {
    wipe
    model basic -ndm 3 -ndf 6
    node 1 0.0 0.0 0.0
    node 2 0.0 0.0 0.21
    fix 1 1 1 1 1 1 1
    fix 2 0 1 0 1 1 1
    uniaxialMaterial KikuchiAikenHDR 1 X0.6 [expr {$size*$size}] $thickness -coGHU 1.0 0.8 1.0
    # Modulus of Eqs 2 and 3 of the paper, and its factor.
    uniaxialMaterial AxialSp 2 [expr {0.4*4.9219e8}] 0.55e6 -100.0e6 1.0 0.01 0.5 0.0
    element KikuchiBearing 1 1 2 -shape square -size $size $thickness -totalHeight 0.21 -nMSS 8 -matMSS 1 -limDisp 0.002 \
        -nMNS 30 -matMNS 2 -lambda 1.706 -doBalance 1e-5 1e-2 100 -orient 0 0 1 1 0 0
    timeSeries Linear 1
    pattern Plain 1 1 "load 2 0.0 0.0 [expr {-$axial}] 0.0 0.0 0.0"
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-7 100
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} { puts "no equilibrium: $name" }
    loadConst -time 0.0
    wipeAnalysis
    set values 0.0
    for {set i 1} {$i <= 400} {incr i} {
        set t [expr {0.04*$i}]
        # Two cycles at each of four amplitudes at 0.5 Hz; held out, a beat of two frequencies.
        set amplitude [lindex {0.03 0.06 0.09 0.12} [expr {min(3, ($i - 1)/100)}]]
        lappend values [expr {$name eq "other" ? 0.055*sin(2.0*$pi*0.4*$t) + 0.05*sin(2.0*$pi*0.55*$t) : $amplitude*sin($pi*$t)}]
    }
    timeSeries Path 2 -dt 0.04 -values $values
    pattern Plain 2 2 { sp 2 1 1.0 }
    recorder Element -file force_$name.out -time -ele 1 force
    recorder Node -file disp_$name.out -time -node 2 -dof 1 disp
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-7 100
    algorithm Newton
    integrator LoadControl 0.04
    analysis Static
    for {set i 1} {$i <= 400} {incr i} {
        if {[analyze 1] != 0} { puts "no convergence: $name at step $i"; break }
    }
    wipe
}
