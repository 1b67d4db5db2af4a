# The laboratory programme of the high damping rubber bearings HDR2 and HDR3, by their rheology model.
#
#   All 24 rows of Table 2.2 for both compounds: simple and multi-step relaxation (SR, MSR), sinusoidal loading (Sin) and
#   cyclic shear at constant rates (CS), at -30, -10 and 23 degC, each after preloading and a day of rest. Then what the
#   thesis draws from them: overstress against the strain rate of the dashpot (Figs 3.5, 3.6), and what the rheology
#   gains over its predecessor, whose overstress spring is linear (Bhuiyan, Okui, Mitamura and Imai, 2009).
#
# Units: N, mm, s, degC; MPa, MJ/m3.
# Source: D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low
# temperatures, dissertation.
#
# Writes a table for each test, and pictures, to results/hdrb_tests in the current folder.

source [file join [file dirname [info script]] ../models/hdrb_tests.tcl]
set out results/hdrb_tests
file mkdir $out

# A table is enough with every fifth row of a ramp.
set hdrb::perStrain 60
set hdrb::perCycle 200

proc write {file run} {
    set f [open $file w]
    puts $f "time,strain,stress,equilibrium,overstress,segment"
    foreach t [dict get $run time] g [dict get $run strain] s [dict get $run stress] e [dict get $run equilibrium] \
        o [dict get $run overstress] name [dict get $run name] {
        puts $f [format "%.6f,%.5f,%.5f,%.5f,%.5f,%s" $t $g $s $e $o $name]
    }
    close $f
}

# Overstress and strain rate of the dashpot in a hold, as they are read from a test: the stress at the end of the hold
# counts as equilibrium, and the strain of the dashpot is that of the bearing less that of the elasto-plastic part.
proc dashpot {hold parameters} {
    lassign $parameters c1 c2 tau
    set end [lindex [dict get $hold stress] end]
    set sign [expr {[lindex [dict get $hold stress] 0] > $end ? 1.0 : -1.0}]
    set last {}
    set rates {}
    set stresses {}
    set previous 0.0
    foreach t [dict get $hold time] s [dict get $hold stress] {
        set x [expr {$sign*($s - $end)}]
        # Eq 3.9: the slider has moved where the stress is above what spring and slider bear together.
        set limit [expr {$tau*(1.0 + $c2/$c1)}]
        set b [expr {$x > $limit ? ($x - $tau)/$c2 : $x/($c1 + $c2)}]
        if {$last ne {} && $t > $previous} {
            set rate [expr {($last - $b)/($t - $previous)}]
            if {$rate > 1e-9} {
                lappend rates $rate
                lappend stresses [expr {0.5*($x + $wasX)}]
            }
        }
        set last $b
        set wasX $x
        set previous $t
    }
    return [list $rates $stresses]
}

puts [format "%-5s %2s %-12s %6s  %s" rubber no test degC "result"]
foreach compound {HDR2 HDR3} {
    set relaxation {}
    set peaks {}
    foreach row [hdrb::programme] {
        set run [hdrb::simulate $row $compound]
        dict with row {
            write $out/$compound-$name.csv $run
            switch $protocol {
                CS - Sin {
                    set cycle [hdrb::select $run cycle1]
                    lassign [hdrb::loop [dict get $cycle strain] [dict get $cycle stress]] d h g
                    lassign [hdrb::dissipation $run] each sum
                    set result [format "first cycle: D %.2f MJ/m3, h_eq %.3f, G_eq %.2f MPa; all eleven: %.1f MJ/m3" \
                        $d $h $g [lindex $sum end]]
                }
                SR {
                    set hold [hdrb::select $run hold-loading]
                    set stress [dict get $hold stress]
                    set left [lindex [dict get $hold overstress] end]
                    set whole [lindex [dict get $hold overstress] 0]
                    set result [format "%.3f MPa relax to %.3f; of the overstress %.1f %% is left" [lindex $stress 0] \
                        [lindex $stress end] [expr {100.0*$left/$whole}]]
                    if {$amplitude == 1.75} { lappend relaxation $temperature $hold }
                }
                MSR {
                    set test [hdrb::select $run step]
                    set top [lsearch -real [dict get $test strain] 2.5]
                    set result [format "%.3f MPa at 2.5" [lindex [dict get $test stress] $top]]
                    lappend peaks $temperature $test
                }
            }
            puts [format "%-5s %2d %-12s %6s  %s" $compound $number $name $temperature $result]
        }
    }
    # Figs 3.5, 3.6, by the parameters of the instantaneous response.
    set curves {}
    foreach {temperature hold} $relaxation {
        set file [file join [file dirname [info script]] ../models/compounds/$compound.txt]
        foreach line [split [read [set f [open $file]]] \n] {
            if {[lindex $line 0] eq $temperature} { lassign [lrange $line 6 10] c1 c2 tau a n }
        }
        close $f
        lassign [dashpot $hold [list $c1 $c2 $tau]] rates stresses
        set x {}
        set model {}
        foreach rate $rates {
            lappend x [expr {log10($rate)}]
            lappend model [expr {$a*$rate**$n}]
        }
        lappend curves -dots "$temperature degC, read from SR175" $x $stresses -line "a |rate|^n" $x $model
    }
    figure $out/$compound-dashpot.svg -title "$compound: overstress against the strain rate of the dashpot" \
        -x "log10 strain rate of the dashpot, 1/s" -y "overstress, MPa" {*}$curves
    set curves {}
    foreach {temperature run} $peaks {
        lappend curves -line "$temperature degC" [dict get $run strain] [dict get $run stress]
    }
    figure $out/$compound-MSR.svg -title "$compound: multi-step relaxation" -x "shear strain" -y "shear stress, MPa" {*}$curves
}

# The predecessor: one linear spring before the dashpot. A spring that is right for the first moment of loading is far too
# stiff at large strains, and one that is right at large strains misses the beginning: neither makes a good loop.
puts ""
puts "HDR3 at 23 degC, cyclic shear at 5.5/s: the linear overstress spring beside the elasto-plastic one"
set path [hdrb::path {protocol CS amplitude 1.75 rate 5.5 cycles 1} -preload 0]
set reference [hdrb::run $path {HDRRheology -compound HDR3 -temperature 23}]
set curves [list -line "elasto-plastic" [dict get $reference strain] [dict get $reference stress]]
foreach stiffness {10.852 4.0 1.059} {
    set run [hdrb::run $path [list HDRRheology -compound HDR3 -temperature 23 -linear $stiffness]]
    lassign [hdrb::loop [dict get $run strain] [dict get $run stress]] d h g
    set r2 [hdrb::r2 [dict get $reference stress] [dict get $run stress]]
    puts [format "  spring of %6.3f MPa: D %.2f MJ/m3, h_eq %.3f, G_eq %.2f MPa, R2 to the improved model %.3f" \
        $stiffness $d $h $g $r2]
    lappend curves -line "linear, $stiffness MPa" [dict get $run strain] [dict get $run stress]
}
figure $out/HDR3-predecessor.svg -title "HDR3, 23 degC, 5.5/s: linear and elasto-plastic overstress" \
    -x "shear strain" -y "shear stress, MPa" {*}$curves
