# Which phenomena the models of a bearing capture: experiments on the RR-FRB of models/, one for each row of Table 4 of the paper.
# Words: boucwen, hdr, kikuchi or rheology. Units: N, m. Prints a line for each experiment: its name and numbers, which README.md explains.
set kind [lindex $argv 0]
source [file join [file dirname [info script]] .. .. .. models rr_frb_$kind.tcl]

# Move the upper plate of a new bearing through points (x y z), each reached in n steps; z is left free where the load is to be
# carried. Rows of displacements and forces (x y z) and the moment about y of both ends, one a step, from the load on.
proc drive {load directions points n} {
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    node 1 0.0 0.0 0.0
    node 2 0.0 0.0 0.0
    # OpenSees wants an equation, also where everything is imposed.
    node 3 0.0 0.0 0.0
    fix 3 0 1 1 1 1 1
    uniaxialMaterial Elastic 1 1.0
    element zeroLength 2 1 3 -mat 1 -dir 1
    {*}$::device
    fix 1 1 1 1 1 1 1
    fix 2 [expr {1 ni $directions}] [expr {2 ni $directions}] 0 1 1 1
    constraints Transformation
    numberer Plain
    system FullGeneral
    test NormDispIncr 1e-8 100
    algorithm Newton
    if {$load != 0.0} {
        timeSeries Linear 1
        pattern Plain 1 1 "load 2 0.0 0.0 [expr {-$load}] 0.0 0.0 0.0"
        integrator LoadControl 0.02
        analysis Static
        if {[analyze 50] != 0} { error "no equilibrium under the axial load" }
        loadConst -time 0.0
    }
    set at {0.0 0.0 0.0}
    set paths {0.0 0.0 0.0}
    foreach point $points {
        for {set i 1} {$i <= $n} {incr i} {
            set paths [lmap path $paths a $at b $point { concat $path [expr {$a + ($b - $a)*$i/double($n)}] }]
        }
        set at $point
    }
    foreach d $directions {
        timeSeries Path [expr {10 + $d}] -dt 1.0 -values [lindex $paths [expr {$d - 1}]] -useLast
        pattern Plain [expr {10 + $d}] [expr {10 + $d}] "sp 2 $d 1.0"
    }
    integrator LoadControl 1.0
    analysis Static
    set rows {}
    set steps [expr {[llength [lindex $paths 0]] - 1}]
    for {set i 1} {$i <= $steps} {incr i} {
        if {[analyze 1] != 0} break
        set f [eleResponse 1 force]
        lappend rows [list [nodeDisp 2 1] [nodeDisp 2 2] [nodeDisp 2 3] {*}[lrange $f 6 8] [expr {[lindex $f 4] + [lindex $f 10]}]]
    }
    return $rows
}

# Column of rows: ux uy uz Fx Fy Fz My from 0.
proc column {rows c} { lmap r $rows { lindex $r $c } }
proc largest {values} { tcl::mathfunc::max {*}$values }
proc smallest {values} { tcl::mathfunc::min {*}$values }
set device [list rr_frb_$kind 1 1 2]
proc show {name args} { puts "$name [join [lmap x $args { format %.4f $x }]]" }

set load 100.0e3
set u 0.06

# Sheared along x, then along y: how much of the force along x is lost.
set rows [drive $load {1 2} [list [list $u 0 0] [list $u $u 0]] 60]
show bidirectional [expr {1.0 - [lindex $rows 119 3]/[lindex $rows 59 3]}]

# Lateral force under a small and a large axial load, and axial stiffness at rest and sheared.
set f [lmap p {10e3 170e3} { lindex [drive $p {1} [list [list $u 0 0]] 60] end 3 }]
set k {}
foreach x {0.0 0.12} {
    set rows [drive 0.0 {1 3} [list [list $x 0 0] [list $x 0 -1e-5]] 60]
    lappend k [expr {[lindex $rows 119 5] - [lindex $rows 59 5]}]
}
show lateral_by_axial [expr {1.0 - [lindex $f 1]/[lindex $f 0]}]
show axial_by_lateral [expr {1.0 - [lindex $k 1]/[lindex $k 0]}]

# Pulled twice to 5 % of tensile strain: stiffness at the end over that at the beginning, and what the second pull has lost at the
# displacement at which the first began to soften.
set rows [drive 0.0 {3} {{0 0 0.01} {0 0 0} {0 0 0.01}} 400]
set first [column [lrange $rows 0 399] 5]
set second [column [lrange $rows 800 1199] 5]
show cavitation [expr {([lindex $first 399] - [lindex $first 398])/[lindex $first 0]}]
set knee 0
while {[lindex $first $knee+1] - [lindex $first $knee] > 0.5*[lindex $first 0]} { incr knee }
show degradation [expr {1.0 - [lindex $second $knee]/[lindex $first $knee]}]

# Cycles before and after two larger ones: how much of the range of the force is lost. The HDR element softens so with chi_1, chi_2 and chi_4
# three hundred times those identified, and chi_3 below 1.
set device [list rr_frb_$kind]
if {$kind eq "hdr"} { lappend device 1 1 2 {0 0 1} {1 0 0} {3.6 25.8 0.5 0.075} } else { lappend device 1 1 2 }
set points {}
foreach amplitude {0.02 0.02 0.02 0.06 0.06 0.02 0.02 0.02} { lappend points [list $amplitude 0 0] [list -$amplitude 0 0] }
set rows [drive $load {1} $points 60]
set ranges [lmap cycle {2 7} {
    set f [column [lrange $rows [expr {120*$cycle}] [expr {120*$cycle + 119}]] 3]
    expr {[largest $f] - [smallest $f]}
}]
show mullins [expr {1.0 - [lindex $ranges 1]/[lindex $ranges 0]}]
set device [list rr_frb_$kind 1 1 2]

# Compressed until it gives way, at rest and sheared by half of its width: how much of the axial strength is lost.
set strength {}
foreach x {0.0 0.105} {
    set rows [drive 0.0 {1 3} [list [list $x 0 0] [list $x 0 -0.06]] 600]
    lappend strength [expr {-[smallest [column $rows 5]]}]
}
show critical_load [expr {1.0 - [lindex $strength 1]/[lindex $strength 0]}]

# Sheared far under a small and a large axial load: tangents at the end over that at the beginning, the moments of the ends over load
# times displacement, and how much of the tangent the load has taken.
set tangents {}
foreach p {10e3 170e3} {
    set rows [drive $p {1} {{0.15 0 0}} 150]
    set f [column $rows 3]
    lappend tangents [expr {([lindex $f end] - [lindex $f end-1])/[lindex $f 0]}]
}
show post_buckling [expr {[lindex $tangents 0] - [lindex $tangents 1]}] {*}$tangents
show end_moments [expr {[lindex $rows end 6]/($p*[lindex $rows end 0])}]
