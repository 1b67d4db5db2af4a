# An oscillator of Steel02 under a decaying sine, four periods, 4000 steps each: `analyze 1` in a loop with two procedures that ask
# for results, and a file of them. Prints period and largest displacement. Units: N, m, s for a mass of 1 kg.
proc record {file} {
    puts $file "[getTime] [nodeDisp 2 1] [nodeVel 2 1] [lindex [eleResponse 1 force] 2]"
}
proc track {node} { 
    global peak
    set d [expr {abs([nodeDisp $node 1])}]
    if {$d > $peak} { set peak $d }
}
set pi 3.14159265
foreach T {0.2 0.5 1.0 2.0} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0.0
    node 2 0.0
    fix 1 1
    set m 1.0
    set k [expr 4*$pi*$pi/$T/$T*$m]
    mass 2 $m
    uniaxialMaterial Steel02 1 [expr 0.1*9.81*$m] $k 0.02 18 0.925 0.15
    element zeroLength 1 1 2 -mat 1 -dir 1
    set vals {}
    for {set i 0} {$i < 2000} {incr i} { lappend vals [expr 3.0*sin(0.05*$i)*exp(-0.0005*$i)] }
    timeSeries Path 1 -dt 0.01 -values $vals
    pattern UniformExcitation 1 1 -accel 1
    rayleigh [expr 2*0.05*2*$pi/$T] 0 0 0
    constraints Plain
    numberer Plain
    system BandGeneral
    test NormDispIncr 1e-8 20
    algorithm Newton
    integrator Newmark 0.5 0.25
    analysis Transient
    set peak 0.0
    set f [open oscillator_$T.out w]
    set tCurrent [getTime]
    set ok 0
    while {$ok == 0 && $tCurrent < 20.0} {
        set ok [analyze 1 0.005]
        if {$ok != 0} {
            test NormDispIncr 1e-6 100
            algorithm ModifiedNewton
            set ok [analyze 1 0.005]
            algorithm Newton
        }
        set tCurrent [getTime]
        track 2
        record $f
    }
    close $f
    puts "$T $peak"
}
