# A high damping rubber bearing under a growing axial load: softening, and buckling, with the shear displacement.
#
#   One bearing of 600 mm diameter between the ground and a node that is pushed sideways in cycles of growing amplitude
#   under a constant axial load, once for each of three loads. KikuchiBearing gets the softening from the geometry: the
#   axial force runs along links that tilt as the sections of normal springs turn.
#
#              | P                    The rubber: X0.6 (Kikuchi and Aiken, 1997), normal springs that crack in tension
#              v                      (AxialSp), spread over the section by the pressure in a bonded layer (-lambda).
#         -----o----- -> u
#         ///////////  sections of 20 x 20 normal springs, above and below
#             | |      8 shear springs at mid-height
#         ///////////
#         -----o-----
#
# Units: N, m.
#
# Writes results/kikuchi_bearing/loop_*.out: displacement, shear force, axial displacement. Runs in OpenSees, too.

set out results/kikuchi_bearing
file mkdir $out

set D 0.60        ;# diameter
set tr 0.15       ;# total thickness of rubber: 25 layers of 6 mm
set height 0.30   ;# with the steel plates
set G 0.40e6      ;# shear modulus
set K 1.96e9      ;# bulk modulus
set area [expr {acos(-1.0)*$D*$D/4.0}]
set lambda [expr {$D/0.006*sqrt(3.0*$G/$K)}]

# A step of the protocol is this much of the thickness of rubber.
set step 0.05

proc bearingUnder {pressure} {
    global out D tr height area lambda step
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    node 1 0.0 0.0 0.0
    node 2 0.0 0.0 $height
    fix 1 1 1 1 1 1 1
    fix 2 0 1 0 1 1 1

    #                              compound area  thickness
    uniaxialMaterial KikuchiAikenHDR 1 X0.6 $area $tr
    # Stiffness in compression, cavitation, yield in compression; in tension, after cavitation, after yield; closing.
    uniaxialMaterial AxialSp 2 1.0e9 1.0e6 -100.0e6 0.10 0.10 0.5 0.0
    element KikuchiBearing 1 1 2 -shape round -size $D $tr -totalHeight $height \
        -nMSS 8 -matMSS 1 -limDisp [expr {0.5*$tr}] -nMNS 20 -matMNS 2 -lambda $lambda -orient 0 0 1 1 0 0

    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0.0 0.0 -1.0 0.0 0.0 0.0 }
    constraints Transformation
    numberer RCM
    system FullGeneral
    test NormDispIncr 1.0e-10 30
    algorithm Newton
    integrator LoadControl [expr {0.1*$pressure*$area}]
    analysis Static
    if {[analyze 10] != 0} { error "no balance under the axial load" }
    loadConst -time 0.0
    wipeAnalysis

    # Cycles to 50, 100, 150, 200 % of the thickness.
    set path 0.0
    set u 0.0
    foreach amplitude {0.5 1.0 1.5 2.0} {
        foreach target [list $amplitude [expr {-$amplitude}] 0.0] {
            while {abs($target - $u) > 0.5*$step} {
                set u [expr {$u + ($target > $u ? $step : -$step)}]
                lappend path [expr {$u*$tr}]
            }
        }
    }
    timeSeries Path 2 -dt 1.0 -values $path -useLast
    pattern Plain 2 2 { sp 2 1 1.0 }
    set name "$out/loop_[expr {int($pressure/1.0e6)}]MPa.out"
    recorder Node -file $name -precision 10 -time -node 2 -dof 1 3 disp
    recorder Element -file "$out/force_[expr {int($pressure/1.0e6)}]MPa.out" -precision 10 -time -ele 1 basicForce

    constraints Transformation
    numberer RCM
    system FullGeneral
    test NormDispIncr 1.0e-10 30
    algorithm Newton
    integrator LoadControl 1.0
    analysis Static
    set peak 0.0
    set down 0.0
    set n [expr {[llength $path] - 1}]
    for {set i 1} {$i <= $n} {incr i} {
        if {[analyze 1] != 0} { error "no balance at step $i under $pressure Pa" }
        set shear [lindex [eleForce 1] 6]
        if {$shear > $peak} { set peak $shear }
        if {[nodeDisp 2 3] < $down} { set down [nodeDisp 2 3] }
    }
    puts [format "%5.1f MPa: largest shear force %6.1f kN, sinks by %5.2f mm" \
        [expr {$pressure*1.0e-6}] [expr {$peak*1.0e-3}] [expr {-1000.0*$down}]]
    wipe
}

foreach pressure {2.0e6 8.0e6 15.0e6} { bearingUnder $pressure }
