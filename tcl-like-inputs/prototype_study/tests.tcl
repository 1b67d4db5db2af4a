# Prototype tests of a lead-rubber bearing for hysteron prototype, made by a model and not measured.
#
#   A bearing of 0.65 m whose lead core heats (LeadRubberX) is moved in shear under a constant load: three cycles at half,
#   the whole and 1.25 times the design displacement of 0.30 m with a period of 2.5 s, then ten cycles at the design
#   displacement. Each cycle finds a warmer core and a lower strength. Writes test1.csv to test4.csv to results/prototype.
#
#   hysteron run tests.tcl
#   hysteron prototype results/prototype/test*.csv -t time -u disp -f force --units kN m --code asce7-16 --design 0.30
#       --aging-max 1.0 1.1 --spec-min 0.85 0.85 --spec-max 1.15 1.15 --weight 2000 --out results/prototype
#
# Units: kN, m, s, t. Constants of lead and steel: Kalpakidis and Constantinou (2009), J. Struct. Eng. 135(12), 1440-1449,
# with masses in t and heat in kJ.

set out results/prototype
file mkdir $out
set period 2.5
set perCycle 160

proc bearingTest {file amplitude cycles} {
    global out period perCycle
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    node 1 0.0 0.0 0.0
    node 2 0.0 0.0 0.3
    fix 1 1 1 1 1 1 1
    fix 2 0 1 0 1 1 1
    mass 2 1.0e-3 0.0 1.0e-3 0.0 0.0 0.0
    element LeadRubberX 1 1 2 130.0 0.10 450.0 2.0e6 0.12 0.65 0.003 0.008 25 0 0 1 1 0 0 \
        10.0 0.75 1.0 0.5 0.0 0.0 0.005 11.2 130.0 0.050 1.41e-5 0 0 0 0 1
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0.0 0.0 -2000.0 0.0 0.0 0.0 }
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-10 50
    algorithm Newton
    integrator LoadControl 1.0
    analysis Static
    if {[analyze 1] != 0} { error "the load failed" }
    loadConst -time 0.0
    wipeAnalysis
    # The movement of the upper plate with its velocity, which heats the core.
    set dt [expr {$period/$perCycle}]
    set w [expr {2.0*3.14159265358979/$period}]
    set disp {}
    set vel {}
    for {set i 0} {$i <= $perCycle*$cycles} {incr i} {
        lappend disp [expr {$amplitude*sin($w*$dt*$i)}]
        lappend vel [expr {$amplitude*$w*cos($w*$dt*$i)}]
    }
    timeSeries Path 2 -dt $dt -values $disp
    timeSeries Path 3 -dt $dt -values $vel
    pattern MultipleSupport 2 {
        groundMotion 1 Plain -disp 2 -vel 3
        imposedMotion 2 1 1
    }
    constraints Transformation
    numberer Plain
    system BandGeneral
    test NormDispIncr 1.0e-10 50
    algorithm Newton
    integrator Newmark 0.5 0.25
    analysis Transient
    set channel [open [file join $out $file] w]
    puts $channel "time,disp,force"
    for {set i 1} {$i <= $perCycle*$cycles} {incr i} {
        if {[analyze 1 $dt] != 0} { error "no convergence at [getTime] s" }
        set force [lindex [eleResponse 1 force] 6]
        puts $channel [format "%.5f,%.7f,%.5f" [getTime] [nodeDisp 2 1] $force]
    }
    close $channel
    puts [format "%s: %d cycles of %.3f m, force at the end %.2f kN" $file $cycles $amplitude $force]
}
bearingTest test1.csv 0.15 3
bearingTest test2.csv 0.30 3
bearingTest test3.csv 0.375 3
bearingTest test4.csv 0.30 10
