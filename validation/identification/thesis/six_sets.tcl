# Identification of all six sets of Tables 3.1 and 3.2: HDR2 and HDR3 at -30, -10 and 23 degC.
#
#   hysteron run validation/identification/thesis/six_sets.tcl
#
# The law with the printed parameters makes the tests of Table 2.2 (MSR, SR, one cycle of Sin, one of CS at 1.5/s), and noise is
# added. Starting values come from these tests alone. The two stages of the thesis and the joint fit are printed beside
# each other: the error of each parameter, its 95 % interval, and the parameters that the tests do not determine.
#
# Units: MPa, s, degC.
# Source: D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low
# temperatures, dissertation (sections 3.3 and 3.4, Fig 3.7, Eqs 3.14 to 3.17).

source [file join [file dirname [info script]] ../../../models/hdrb_tests.tcl]
source [file join [file dirname [info script]] ../../../models/hdrb_identify.tcl]
set hdrb::perStrain 20
set hdrb::perCycle 80
set hdrb::growth 2.0
set noise 0.01

expr {srand(20261)}
proc normal {} { return [expr {sqrt(-2.0*log(rand() + 1e-300))*cos(2.0*acos(-1.0)*rand())}] }

proc parameters {compound} {
    set f [open [file join [file dirname [info script]] ../../../models/compounds/$compound.txt]]
    set rows {}
    foreach line [split [read $f] \n] {
        if {[string is double -strict [lindex $line 0]]} { lappend rows [lindex $line 0] [lrange $line 1 end] }
    }
    close $f
    return $rows
}

proc row {label cells} {
    set line [format "%-24s" $label]
    foreach x $cells { append line [format " %8s" $x] }
    puts [string trimright $line]
}

proc percent {x} { return [expr {$x eq "" ? "fixed" : $x > 9.99 ? "-" : [format %.1f [expr {100.0*$x}]]}] }

set inside 0
set worst 0.0
foreach test {MSR SR Sin CS} { set widest($test) [lrepeat 10 0.0] }
row "set, %" $hdrb::names
foreach compound {HDR2 HDR3} {
    foreach {temperature truth} [parameters $compound] {
        set hz [expr {$temperature == 23 ? 1.0 : 0.5}]
        array set path [list \
            MSR [hdrb::path {protocol MSR amplitude 2.5 rate 5.5 hold 1200} -preload 0] \
            SR [hdrb::path {protocol SR amplitude 1.75 rate 5.5 hold 1800} -preload 0] \
            Sin [hdrb::path "protocol Sin amplitude 1.75 hz $hz cycles 1" -preload 0] \
            CS [hdrb::path {protocol CS amplitude 1.75 rate 1.5 cycles 1} -preload 0]]
        foreach test {MSR SR Sin CS} {
            set exact [hdrb::stressOf $path($test) $truth]
            set data($test) [lmap s $exact { expr {$s + $noise*[normal]} }]
            # What the test tells by itself at the parameters that made it.
            set half [hdrb::intervals [hdrb::sensitivities [list hdrb::stressOf $path($test)] $truth $exact] $noise]
            set widest($test) [lmap a $widest($test) b $half { expr {max($a, $b)} }]
        }
        # Stage 1: the end points of the holds.
        lassign [hdrb::sample $path(MSR)] times strains names
        set ends {}
        set stresses {}
        foreach name $names after [concat [lrange $names 1 end] end] g $strains s $data(MSR) {
            if {$name eq "relax" && $after ne "relax"} { lappend ends $g; lappend stresses $s }
        }
        lassign [hdrb::equilibrium $ends $stresses] equilibrium r2equilibrium half1
        set open [hdrb::undetermined {C1eq C2eq C3eq tauCrEq m} $half1]
        # The slider yields within the first step of 0.5: its spring leaves no trace at the end of a hold.
        if {"C1eq" ni $open} { error "C1eq is said to be determined by relaxed ends" }
        # Stage 2: the search of Fig 3.7, with what stage 1 has left open.
        set start [concat $equilibrium [hdrb::overstressStart $equilibrium $path(SR) $data(SR)]]
        lassign [hdrb::stepSearch $start $path(Sin) $data(Sin) -free $open] staged r2 evaluations half2
        set half {}
        foreach a [concat $half1 {{} {} {} {} {}}] b $half2 { lappend half [expr {$b eq "" ? $a : $b}] }
        # All tests at once, from the same start.
        set runs {}
        foreach test {MSR SR Sin CS} { lappend runs $path($test) $data($test) 1.0 }
        lassign [hdrb::joint $start $runs] joint r2joint halfJoint deviation
        set name "$compound, $temperature degC"
        row "$name: start" [lmap x $start p $truth { format %+.1f [expr {100.0*($x/$p - 1.0)}] }]
        row "  two stages" [lmap x $staged p $truth { format %+.1f [expr {100.0*($x/$p - 1.0)}] }]
        row "    interval +-" [lmap h $half { percent $h }]
        row "  joint" [lmap x $joint p $truth { format %+.1f [expr {100.0*($x/$p - 1.0)}] }]
        row "    interval +-" [lmap h $halfJoint { percent $h }]
        puts "  stage 1 does not determine: [expr {[llength $open] ? [join $open {, }] : {-}}]"
        set unsure [hdrb::undetermined $hdrb::names [lmap h $half { expr {$h eq "" ? 0.0 : $h} }]]
        puts "  two stages do not determine: [expr {[llength $unsure] ? [join $unsure {, }] : {-}}]"
        set biased {}
        foreach parameter $hdrb::names x $staged p $truth h $half {
            if {$h ne "" && abs(log($x/$p)) > $h} { lappend biased $parameter }
        }
        puts "  two stages err beyond their intervals: [expr {[llength $biased] ? [join $biased {, }] : {-}}]"
        puts [format "  R2 %.5f of equilibrium, %.5f of overstress (%d simulations), %.5f of all; %.4f MPa remain" \
            $r2equilibrium $r2 $evaluations $r2joint $deviation]
        foreach x $joint p $truth h $halfJoint {
            if {$h > 0.1} { error "$name: the joint fit does not determine a parameter to 10 %" }
            incr inside [expr {abs(log($x/$p)) <= $h}]
            set worst [expr {max($worst, abs($x/$p - 1.0))}]
        }
    }
}
puts ""
row "a test by itself, +- %" $hdrb::names
foreach test {MSR SR Sin CS} { row "  $test, widest of six" [lmap h $widest($test) { percent $h }] }
puts [format "joint fits: %d of 60 parameters inside their 95 %% intervals, largest error %.1f %%" $inside [expr {100.0*$worst}]]
# 57 are expected; fewer than 53 have a probability of 2 %.
if {$inside < 53} { error "the intervals of the joint fits do not hold" }
