# A bridge superstructure on a high damping rubber bearing in earthquakes: bilinear model beside rheology, at -30, -10 and
# 23 degC, with the temperature that rises in the rubber.
#
#   hysteron run hdrb_pier.tcl ?MOTION DT? ...        (files of accelerations in g; ground_motions has some)
#
#         o  mass of one span        seismic analysis of a pier after D. A. Nguyen, A rheology model of high damping
#         #  bearing                 rubber bearings for seismic analysis at room and low temperatures, dissertation,
#      ---o---  ground               section 5.4: system of Fig 5.9, bilinear parameters of Table 5.1.
#
# Units: N, m, s, kg, degC; stresses in MPa with areas in mm2, so that forces are in N and displacements in m.
#
# The thesis has the standard motions of the Japanese road bridge code (JRA, 2002), which are not public. These are fitted to the
# code's level 2 spectra of ground type II: type 1 are earthquakes at the plate boundary, type 2 inland ones. Thickness of the steel plates (4.5 mm) and densities are assumed. Writes pictures to results/hdrb_pier.

set here [file dirname [info script]]
source $here/../models/hdrb_tests.tcl
set out results/hdrb_pier
file mkdir $out

set motions [list jra_level2_type1 $here/ground_motions/jra_level2_type1_g.txt 0.02 \
    jra_level2_type2 $here/ground_motions/jra_level2_type2_g.txt 0.02]
if {[llength $argv] >= 2} {
    set motions {}
    foreach {file dt} $argv { lappend motions [file rootname [file tail $file]] $file $dt }
}

set mass 196928.0
set area [expr {650.0*650.0}]       ;# mm2
set height 0.08124                  ;# m, six layers of 13.54 mm
set layers 6
set plate 0.0045                    ;# m, assumed
set damping [expr {2.0*0.0005*$mass*2.0*acos(-1.0)/2.0}] ;# 0.05 % at a period of 2 s
set capacity [expr {1.15*1.732 + 7.85*0.432*($layers - 1)*$plate/$height}] ;# MJ/m3K, Eq 5.3

# Table 5.1: tau_cr, C1, C2 in MPa.
array set bilinear {-30 {1.921 32.58 1.761} -10 {1.435 19.2 1.335} 23 {1.215 17.29 1.136}}

# The bearing as material 1.
proc bearing {kind temperature} {
    global area height bilinear capacity
    switch $kind {
        bilinear {
            lassign $bilinear($temperature) tau c1 c2
            uniaxialMaterial ElasticPP 11 [expr {$area/$height*$c1}] [expr {$tau/$c1*$height}]
            uniaxialMaterial Elastic 12 [expr {$area/$height*$c2}]
            uniaxialMaterial Parallel 1 11 12
        }
        rheology {
            uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature $temperature -area $area -height $height
        }
        heated {
            uniaxialMaterial HDRRheology 1 -compound HDR3 -ambient $temperature -area $area -height $height \
                -heatCapacity $capacity -beyond hold
        }
    }
}

# One analysis: columns of time, displacement, force and temperature rise.
proc earthquake {kind temperature file dt} {
    global mass damping area height capacity bilinear
    wipe
    model basic -ndm 1 -ndf 1
    node 1 0.0
    node 2 0.0
    fix 1 1
    mass 2 $mass
    bearing $kind $temperature
    uniaxialMaterial Viscous 2 $damping 1.0
    element zeroLength 1 1 2 -mat 1 2 -dir 1 1
    timeSeries Path 1 -dt $dt -filePath $file -factor 9.80665
    pattern UniformExcitation 1 1 -accel 1
    constraints Plain
    numberer Plain
    system BandGeneral
    lassign $bilinear($temperature) tau
    # A thousandth of the thesis' tolerance: steps whose forces are near zero are in balance too.
    test NormUnbalance [expr {1e-6*$area*$tau}] 50
    algorithm Newton
    integrator Newmark 0.5 [expr {1.0/6.0}]
    analysis Transient
    set f [open $file]
    set duration [expr {$dt*[llength [read $f]]}]
    close $f
    set time 0.0
    set u 0.0
    set force 0.0
    set rise 0.0
    set volume [expr {$area*$height}] ;# J per MPa
    set work 0.0
    set steps [expr {int(round($duration/0.01))}]
    for {set i 1} {$i <= $steps} {incr i} {
        if {[analyze 1 0.01] != 0} { error "the analysis ended at [getTime] s" }
        set x [nodeDisp 2 1]
        set p [eleResponse 1 material 1 stress]
        # Eq 5.3: all of the work that the bearing takes heats rubber and steel. The rheology knows what is dissipated.
        set work [expr {$kind eq "bilinear" ? $work + 0.5*($p + [lindex $force end])*($x - [lindex $u end])
            : [eleResponse 1 material 1 heat]}]
        lappend time [expr {0.01*$i}]
        lappend u $x
        lappend force $p
        lappend rise [expr {$work/$volume/$capacity}]
    }
    return [list $time $u $force $rise]
}

proc peak {column} {
    set most 0.0
    foreach x $column { set most [expr {max($most, abs($x))}] }
    return $most
}

foreach {motion file dt} $motions {
    puts $motion
    puts "  degC  model      displacement  strain   force     D          temperature rise"
    set rises {}
    foreach temperature {-30 -10 23} {
        set loops {}
        foreach kind {bilinear rheology heated} {
            lassign [earthquake $kind $temperature $file $dt] time u force rise
            set most [peak $u]
            set d [expr {[lindex $rise end]*$capacity}]
            # Largest strain, largest force in kN, and rise of temperature, for those who source this file.
            set found($motion,$temperature,$kind) [list [expr {$most/$height}] [expr {[peak $force]/1000.0}] [lindex $rise end]]
            puts [format "  %4d  %-9s  %8.1f mm  %6.2f  %7.0f kN  %5.2f MJ/m3  %5.2f K" $temperature $kind \
                [expr {1000.0*$most}] [expr {$most/$height}] [expr {[peak $force]/1000.0}] $d [lindex $rise end]]
            if {$kind ne "heated"} {
                set mm {}
                set kn {}
                foreach x $u p $force { lappend mm [expr {1000.0*$x}]; lappend kn [expr {0.001*$p}] }
                lappend loops -line $kind $mm $kn
                lappend rises -line "$kind, $temperature degC" $time $rise
            }
        }
        figure $out/$motion-loops$temperature.svg -title "$motion, $temperature degC" -x "displacement, mm" -y "force, kN" {*}$loops
    }
    figure $out/$motion-temperature.svg -title "$motion: temperature rise in the bearing" -x "time, s" -y "rise, K" {*}$rises
}
