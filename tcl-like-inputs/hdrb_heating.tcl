# Self-heating of a high damping rubber bearing under sinusoidal loading, at three ambient temperatures.
#
#   Eleven cycles at 1.75 and 0.5 Hz on specimens of type A, as in chapter 5 of the thesis: inside temperature and cumulative
#   dissipated energy (Fig 5.4), what rubber alone, rubber with steel and heat flow make of it (Eqs 5.2, 5.3, Fig 5.5), that
#   loops are those of the inside temperature and not of the ambient one (Fig 5.6), and modulus and damping against
#   the inside temperature (Fig 5.8).
#
# Units: N, mm, s, degC; MPa, MJ/m3.
# Source: D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low
# temperatures, dissertation. Thermal conductivities (0.25 and 50 W/mK), densities and the film coefficient (10 W/m2K) are
# assumed.
#
# Writes pictures to results/hdrb_heating in the current folder.

source [file join [file dirname [info script]] ../models/hdrb_tests.tcl]
set out results/hdrb_heating
file mkdir $out
set hdrb::perCycle 200

set path {}
for {set i 1} {$i <= 11} {incr i} { lappend path [list sine 1.75 0.5 1 cycle$i] }

set alone [hdrb::heatCapacity A 0]
set composite [hdrb::heatCapacity A 1]
# Conduction through six layers of 5 mm, plates of 2.3 mm and end plates of 20 mm.
set flow {-conduction 6 5.0 2.3 20.0 0.25 1.9918 50.0 3.3912 0.00001}

set curves {}
set moduli {}
foreach ambient {-30 -20 23} {
    foreach {name heating} [list rubber "-heatCapacity $alone" composite "-heatCapacity $composite" conduction $flow] {
        set material [list HDRRheology -compound HDR3 -ambient $ambient -beyond hold {*}$heating]
        set run [hdrb::run $path $material 57600.0 30.0]
        lassign [hdrb::dissipation $run] each sum
        puts [format "%4d degC, %-10s  inside at the end %6.1f degC, dissipated %6.1f MJ/m3 (first cycle %.1f, last %.1f)" \
            $ambient $name [lindex [dict get $run temperature] end] [lindex $sum end] [lindex $each 0] [lindex $each end]]
        set runs($ambient,$name) $run
        lappend curves -line "$ambient degC, $name" [dict get $run time] [dict get $run temperature]
    }
}
figure $out/temperature.svg -title "HDR3, eleven cycles at 1.75 and 0.5 Hz" -x "time, s" -y "mean inside temperature, degC" {*}$curves

# Cycles with their inside temperature, modulus and damping.
proc cycles {run} {
    set all {}
    for {set i 1} {$i <= 11} {incr i} {
        set c [hdrb::select $run cycle$i]
        set t [dict get $c temperature]
        lappend all [list $i [expr {0.5*([lindex $t 0] + [lindex $t end])}] {*}[hdrb::loop [dict get $c strain] [dict get $c stress]]]
    }
    return $all
}

# The same inside temperature from two ambient ones, second cycles and later: the first begins with virgin sliders.
puts ""
set best {1e9}
foreach a [lrange [cycles $runs(-30,composite)] 1 end] {
    foreach b [lrange [cycles $runs(-20,composite)] 1 end] {
        set apart [expr {abs([lindex $a 1] - [lindex $b 1])}]
        if {$apart < [lindex $best 0]} { set best [list $apart $a $b] }
    }
}
lassign $best apart a b
puts [format "cycle %d at -30 degC is at %.1f degC inside, cycle %d at -20 degC at %.1f:" [lindex $a 0] [lindex $a 1] [lindex $b 0] [lindex $b 1]]
puts [format "  D %.2f and %.2f MJ/m3, h_eq %.3f and %.3f, G_eq %.3f and %.3f MPa" [lindex $a 2] [lindex $b 2] [lindex $a 3] \
    [lindex $b 3] [lindex $a 4] [lindex $b 4]]
set one [hdrb::select $runs(-30,composite) cycle[lindex $a 0]]
set other [hdrb::select $runs(-20,composite) cycle[lindex $b 0]]
puts [format "  R2 of one loop to the other %.5f" [hdrb::r2 [dict get $one stress] [dict get $other stress]]]
figure $out/same_inside.svg -title "loops at the same inside temperature" -x "shear strain" -y "shear stress, MPa" \
    -line "ambient -30 degC" [dict get $one strain] [dict get $one stress] \
    -line "ambient -20 degC" [dict get $other strain] [dict get $other stress]

puts ""
puts "inside degC   G_eq, MPa   h_eq"
set inside {}
foreach ambient {-30 -20 23} {
    foreach c [lrange [cycles $runs($ambient,rubber)] 1 end] {
        lassign $c i t d h g
        lappend inside [list $t $g $h]
    }
}
set inside [lsort -real -index 0 $inside]
foreach row $inside { lassign $row t g h; puts [format "%8.1f  %10.3f  %9.3f" $t $g $h] }
figure $out/modulus_damping.svg -title "modulus and damping against the inside temperature" -x "inside temperature, degC" \
    -y "G_eq, MPa; 10 h_eq" -dots "G_eq" [lmap r $inside { lindex $r 0 }] [lmap r $inside { lindex $r 1 }] \
    -dots "10 h_eq" [lmap r $inside { lindex $r 0 }] [lmap r $inside { expr {10.0*[lindex $r 2]} }]
