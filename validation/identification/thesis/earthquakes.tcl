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

puts ""
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
