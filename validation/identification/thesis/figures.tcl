# The figures of the thesis that other inputs do not draw, by the law with its printed parameters.
#
#   hysteron run validation/identification/thesis/figures.tcl
#
# writes results/thesis/fig_*.svg. tcl-like-inputs/hdrb_tests.tcl draws Figs 2.7 to 2.14 and 4.1 to 4.32, hdrb_heating.tcl
# Figs 5.4 to 5.6 and 5.8, hdrb_pier.tcl Figs 5.14 to 5.17.
#
# Units: MPa, s, degC.
# Source: D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low
# temperatures, dissertation.

set models [file join [file dirname [info script]] ../../../models]
source $models/hdrb_tests.tcl
source $models/hdrb_identify.tcl
set out results/thesis
file mkdir $out
set hdrb::perStrain 40
set hdrb::perCycle 200
set hdrb::growth 1.5

proc law {compound temperature args} { return [list HDRRheology -compound $compound -temperature $temperature {*}$args] }

proc parameters {compound temperature} {
    global models
    set f [open $models/compounds/$compound.txt]
    set lines [split [read $f] \n]
    close $f
    foreach line $lines {
        if {[lindex $line 0] == $temperature && [string is double -strict [lindex $line 0]]} { return [lrange $line 1 end] }
    }
}

# Fig 3.2: at 8.75/s the dashpot is nearly locked, and the overstress is that of its springs.
set run [hdrb::run [list {ramp 1.75 8.75 cycle1} {ramp -1.75 8.75 cycle1} {ramp 0.0 8.75 cycle1}] [law HDR3 23]]
figure $out/fig_3_2.svg -title "HDR3, 23 degC, 8.75/s" -x "shear strain" -y "shear stress, MPa" \
    -line "stress" [dict get $run strain] [dict get $run stress] \
    -line "equilibrium" [dict get $run strain] [dict get $run equilibrium] \
    -line "overstress" [dict get $run strain] [dict get $run overstress]

# Figs 3.3 to 3.6: ends of the holds of MSR with the equilibrium found, and overstress against the rate of the dashpot in SR.
puts "Figs 3.5, 3.6: the dashpot by a simple relaxation, and Table 3.2"
puts "             a, MPa   (table)       n  (table)"
foreach compound {HDR2 HDR3} number {3 4} {
    set curves {}
    foreach temperature {-30 -10 23} {
        set truth [parameters $compound $temperature]
        set path [hdrb::path {protocol MSR amplitude 2.5 rate 5.5 hold 1200} -preload 0]
        lassign [hdrb::sample $path] times strains names
        set stresses [hdrb::stressOf $path $truth]
        lassign {} ends relaxed
        foreach name $names after [concat [lrange $names 1 end] end] g $strains s $stresses {
            if {$name eq "relax" && $after ne "relax"} { lappend ends $g; lappend relaxed $s }
        }
        lassign [hdrb::equilibrium $ends $relaxed] equilibrium
        figure $out/fig_3_${number}_$temperature.svg -title "$compound, $temperature degC" -x "shear strain" -y "shear stress, MPa" \
            -dots "ends of holds" $ends $relaxed -line "equilibrium model" $ends [hdrb::equilibriumStress $ends $equilibrium]
        set path [hdrb::path {protocol SR amplitude 1.75 rate 5.5 hold 1800} -preload 0]
        set start [hdrb::overstressStart $equilibrium $path [hdrb::stressOf $path $truth]]
        lassign [lrange $start 3 4] a n
        puts [format "%s, %3d  %8.3f  (%5.3f)  %6.3f  (%5.3f)" $compound $temperature $a [lindex $truth 8] $n [lindex $truth 9]]
        if {abs($a/[lindex $truth 8] - 1.0) > 0.35 || abs($n/[lindex $truth 9] - 1.0) > 0.35} { error "the dashpot is not found" }
        set run [hdrb::run $path [law $compound $temperature]]
        set hold [hdrb::select $run hold-loading]
        lassign {} rates stresses
        foreach t [lrange [dict get $hold time] 0 end-1] then [lrange [dict get $hold time] 1 end] \
            s [lrange [dict get $hold overstress] 0 end-1] next [lrange [dict get $hold overstress] 1 end] {
            set rate [expr {(0.5*($s + $next)/[lindex $truth 8])**(1.0/[lindex $truth 9])}]
            if {$rate > 1e-4} { lappend rates $rate; lappend stresses [expr {0.5*($s + $next)}] }
        }
        lappend curves -line "$temperature degC" $rates $stresses
    }
    figure $out/fig_3_[expr {$number + 2}].svg -title "$compound: overstress in a simple relaxation" -x "rate of the dashpot, 1/s" \
        -y "overstress, MPa" {*}$curves
}

# Fig 4.30: energy, damping and modulus of HDR3 by rate; measured cells of Table 4.1.
set measured {
    -30 {1.5 11.1 0.20 2.94 5.5 12.7 0.22 3.28 8.75 11.2 0.19 3.43}
    -10 {1.5 7.61 0.19 2.08 5.5 8.67 0.21 2.28 8.75 7.79 0.17 2.36}
    23 {1.5 5.87 0.16 1.93 5.5 6.28 0.16 2.02 8.75 6.72 0.17 2.08}
}
foreach {temperature row} $measured {
    lassign {} rates
    array set model {D {} h {} G {}}
    array set test {D {} h {} G {}}
    foreach {rate d h g} $row {
        set run [hdrb::run [list "ramp 1.75 $rate cycle1" "ramp -1.75 $rate cycle1" "ramp 0.0 $rate cycle1"] [law HDR3 $temperature]]
        lappend rates $rate
        foreach name {D h G} x [hdrb::loop [dict get $run strain] [dict get $run stress]] y [list $d $h $g] {
            lappend model($name) $x
            lappend test($name) $y
        }
    }
    foreach name {D h G} {
        lappend lines($name) -line "model, $temperature degC" $rates $model($name) -dots "test, $temperature degC" $rates $test($name)
    }
}
foreach name {D h G} label {"energy, MJ/m3" "equivalent damping" "modulus, MPa"} {
    figure $out/fig_4_30_$name.svg -title "HDR3, Table 4.1" -x "strain rate, 1/s" -y $label {*}$lines($name)
}

# Figs 5.3 and 5.7: loops of eleven cycles, and cycles by their inside temperature.
set path {}
for {set i 1} {$i <= 11} {incr i} { lappend path [list sine 1.75 0.5 1 cycle$i] }
set loops {}
foreach ambient {-30 -20 23} {
    set run [hdrb::run $path [list HDRRheology -compound HDR3 -ambient $ambient -beyond hold -heatCapacity [hdrb::heatCapacity A]]]
    figure $out/fig_5_3_$ambient.svg -title "HDR3, ambient $ambient degC" -x "shear strain" -y "shear stress, MPa" \
        -line "eleven cycles" [dict get $run strain] [dict get $run stress]
    foreach i {2 6 11} {
        set c [hdrb::select $run cycle$i]
        set t [dict get $c temperature]
        lappend loops [list [expr {0.5*([lindex $t 0] + [lindex $t end])}] $c]
    }
}
set curves {}
set before Inf
foreach loop [lsort -real -index 0 $loops] {
    lassign $loop t c
    lappend curves -line [format "%.0f degC inside" $t] [dict get $c strain] [dict get $c stress]
    set d [lindex [hdrb::loop [dict get $c strain] [dict get $c stress]] 0]
    # Fig 5.7: the area grows as the inside temperature falls. Beyond 23 degC parameters are constant.
    if {$t < 23.0 && $d > $before} { error "the loop at $t degC is larger than a colder one: $d after $before" }
    set before $d
}
figure $out/fig_5_7.svg -title "HDR3, cycles by inside temperature" -x "shear strain" -y "shear stress, MPa" {*}$curves
puts "[llength [glob $out/fig_*.svg]] figures in $out"
