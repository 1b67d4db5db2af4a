# Section 5.4 of the thesis: trends of Figs 5.13 to 5.17, and the rise of temperature in earthquakes beside that of tests.
#
#   hysteron run validation/identification/thesis/earthquakes.tcl
#
# The motions are fitted to the code's level 2 spectra, on which the motions of the thesis were fitted as well; phases differ.
# Units: strains, kN, K, degC.

set argv {}
source [file join [file dirname [info script]] ../../../tcl-like-inputs/hdrb_pier.tcl]

proc holds {what condition} {
    if {![uplevel 1 [list expr $condition]]} { error "not so: $what" }
    puts "holds: $what"
}

# Level 2 spectra on ground type II, m/s2 at 5 % damping (motions.py has their source), and an oscillator under a motion.
proc target {type t} {
    if {$type == 1} { return [expr {$t < 0.18 ? max(15.05*$t**(1.0/3.0), 7.0) : $t <= 1.6 ? 8.5 : 13.6/$t}] }
    return [expr {$t < 0.4 ? max(32.24*$t**(2.0/3.0), 7.0) : $t <= 1.2 ? 17.5 : 23.71/$t**(5.0/3.0)}]
}
proc oscillator {file dt period} {
    set w [expr {2.0*acos(-1.0)/$period}]
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0.0
    node 2 0.0
    fix 1 1
    mass 2 1.0
    uniaxialMaterial Elastic 1 [expr {$w*$w}] [expr {2.0*0.05*$w}]
    element zeroLength 1 1 2 -mat 1 -dir 1
    timeSeries Path 1 -dt $dt -filePath $file -factor 9.80665
    pattern UniformExcitation 1 1 -accel 1
    constraints Plain
    numberer Plain
    system BandGeneral
    algorithm Linear
    integrator Newmark 0.5 0.25
    analysis Transient
    set most 0.0
    for {set i 0} {$i < 6000} {incr i} {
        analyze 1 0.01
        set most [expr {max($most, abs([eleResponse 1 material 1 stress]))}]
    }
    return $most
}

puts ""
foreach {motion file dt} $motions type {1 2} {
    foreach period {0.5 1.0 2.0 3.0} {
        set ratio [expr {[oscillator $file $dt $period]/[target $type $period]}]
        holds "type $type has its spectrum at $period s" {abs($ratio - 1.0) < 0.1}
    }
}

foreach kind {bilinear rheology} {
    foreach type {1 2} {
        foreach temperature {-30 -10 23} {
            lassign $found(jra_level2_type$type,$temperature,$kind) strain force rise
            set strains($type,$temperature) $strain
            set warmed($type,$temperature) $rise
        }
    }
    puts "$kind:"
    holds "Figs 5.14 to 5.16: the bearing moves more at room temperature than in the cold" \
        {$strains(2,-30) < $strains(2,-10) && $strains(2,-10) < $strains(2,23)}
    holds "Fig 5.17: type II heats more than type I at each temperature" \
        {$warmed(2,-30) > $warmed(1,-30) && $warmed(2,-10) > $warmed(1,-10) && $warmed(2,23) > $warmed(1,23)}
    holds "Fig 5.17: the rise is larger at room temperature" {$warmed(2,-30) < $warmed(2,-10) && $warmed(2,-10) < $warmed(2,23)}
    holds "text: about 10 K at 23 degC and 5 K at -30 degC" {abs($warmed(2,23) - 10.0) < 1.5 && abs($warmed(2,-30) - 5.0) < 2.0}
    # The composite warms by 34.4 K from -30 degC and 27.8 K from 23 degC in eleven cycles (test sinusoidal_loading_heats_the_rubber).
    holds "text: much less than in a sinusoidal test in the cold" {$warmed(2,-30) < 0.2*34.4}
}
