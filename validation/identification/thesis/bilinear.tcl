# Table 5.1 by the stated least squares, and chapter 4's argument: a bilinear model of tests at 0.5 Hz beside the rheology at
# the frequencies of isolated bridges.
#
#   hysteron run validation/identification/thesis/bilinear.tcl
#
# The bilinear model (Eqs 5.17 to 5.20) is fitted to the first cycle of the sinusoidal tests of HDR3. The recordings are not
# public; the rheology with Tables 3.1 and 3.2, which were identified from these cycles, stands for them. 0.06 and 0.2 Hz are
# the natural frequencies of a bridge with sliding bearings (Imakirigawa bridge, Matsuda et al., 2013).
#
# Units: MPa, s, degC; strains without unit.

source [file join [file dirname [info script]] ../../../models/hdrb_tests.tcl]
source [file join [file dirname [info script]] ../../../models/hdrb_identify.tcl]
set hdrb::perCycle 200

# Table 5.1: C1, C2, tau_cr.
array set printed {-30 {32.58 1.761 1.921} -10 {19.2 1.335 1.435} 23 {17.29 1.136 1.215}}

# Stress of the bilinear model along strains.
proc bilinear {strains p} {
    lassign $p c1 c2 tau
    return [hdrb::equilibriumStress $strains [list $c1 $c2 0.0 $tau 1.0]]
}

proc cycle {temperature hz} {
    return [hdrb::run [list [list sine 1.75 $hz 1 cycle1]] [list HDRRheology -compound HDR3 -temperature $temperature]]
}

puts "Table 5.1     C1, MPa           C2, MPa           tau_cr, MPa        R2"
puts "degC        fitted  printed   fitted  printed   fitted  printed"
foreach temperature {-30 -10 23} {
    set test [cycle $temperature [expr {$temperature == 23 ? 1.0 : 0.5}]]
    set strains [dict get $test strain]
    lassign [hdrb::leastSquares [list bilinear $strains] {20.0 1.0 1.0} [dict get $test stress]] p r2 half
    set line [format "%4d      " $temperature]
    foreach x $p y $printed($temperature) {
        append line [format " %7.3f %8.3f " $x $y]
        lappend apart [expr {abs($x/$y - 1.0)}]
    }
    puts [append line [format " %.4f" $r2]]
    set fitted($temperature) $p
}
puts [format "largest difference: C1 %.0f %%, C2 %.0f %%, tau_cr %.0f %%" {*}[lmap i {0 1 2} {
    expr {100.0*max([lindex $apart $i], [lindex $apart $i+3], [lindex $apart $i+6])}
}]]

# A bilinear model has one loop at all rates.
puts ""
puts "loop at 1.75, rheology over the bilinear model of 0.5 Hz, %"
puts "degC      Hz        D    h_eq    G_eq"
foreach temperature {-30 -10 23} {
    set at [hdrb::path {protocol Sin amplitude 1.75 hz 0.5 cycles 1} -preload 0]
    lassign [hdrb::sample $at] times strains names
    set test [cycle $temperature 0.5]
    lassign [hdrb::leastSquares [list bilinear $strains] $fitted($temperature) [dict get $test stress]] p
    set one [hdrb::loop $strains [bilinear $strains $p]]
    foreach hz {0.06 0.2 0.5} {
        set test [cycle $temperature $hz]
        set other [hdrb::loop [dict get $test strain] [dict get $test stress]]
        set ratios [lmap a $other b $one { expr {100.0*($a/$b - 1.0)} }]
        puts [format "%4d  %6.2f  %+6.1f  %+6.1f  %+6.1f" $temperature $hz {*}$ratios]
        set off($temperature,$hz) $ratios
    }
}
# What was fitted at 0.5 Hz holds there, and not at a tenth of the rate.
foreach temperature {-30 -10 23} {
    if {abs([lindex $off($temperature,0.5) 0]) > 5.0 || abs([lindex $off($temperature,0.06) 0]) < 10.0} {
        error "at $temperature degC the bilinear model of 0.5 Hz does for 0.06 Hz"
    }
}

# A bridge of that natural frequency (Eq 5.4, unit area and height of rubber) under three cycles of the ground at it.
proc bridge {law hz mass acceleration} {
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0.0
    node 2 0.0
    fix 1 1
    mass 2 $mass
    {*}$law
    element zeroLength 1 1 2 -mat 1 -dir 1
    set dt [expr {0.005/$hz}]
    timeSeries Trig 1 0.0 [expr {3.0/$hz}] [expr {1.0/$hz}]
    pattern UniformExcitation 1 1 -accel 1 -fact $acceleration
    constraints Plain
    numberer Plain
    system BandGeneral
    test NormUnbalance 1e-8 50
    algorithm Newton
    integrator Newmark 0.5 0.25
    analysis Transient
    set most 0.0
    for {set i 0} {$i < 600} {incr i} {
        if {[analyze 1 $dt] != 0} { error "the analysis ended at [getTime] s" }
        set most [expr {max($most, abs([nodeDisp 2 1]))}]
    }
    return $most
}

proc bilinearLaw {p} {
    lassign $p c1 c2 tau
    uniaxialMaterial ElasticPP 11 $c1 [expr {$tau/$c1}]
    uniaxialMaterial Elastic 12 $c2
    uniaxialMaterial Parallel 1 11 12
}

puts ""
puts "bridge, largest shear strain"
puts "degC      Hz  bilinear of 0.5 Hz  rheology"
foreach temperature {-30 -10 23} {
    lassign $fitted($temperature) c1 c2 tau
    foreach hz {0.06 0.2 0.5} {
        # Natural frequency by the secant at 1.75, and accelerations that bring the bilinear model there in three cycles.
        set mass [expr {($c2 + $tau/1.75)/(2.0*acos(-1.0)*$hz)**2}]
        set a [expr {1.5*$tau/$mass}]
        set one [bridge [list bilinearLaw $fitted($temperature)] $hz $mass $a]
        set other [bridge [list uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature $temperature] $hz $mass $a]
        puts [format "%4d  %6.2f  %10.3f          %8.3f  %+5.1f %%" $temperature $hz $one $other [expr {100.0*($other/$one - 1.0)}]]
        set missed($hz) [expr {abs($other/$one - 1.0)}]
    }
    # The parameters of 23 degC are those of 1 Hz.
    if {$missed(0.06) < 0.2 || $missed(0.06) < 2.0*$missed(0.5)} { error "the rate does not matter to the bridge at $temperature degC" }
}
