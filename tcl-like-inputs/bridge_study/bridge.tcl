# A three-span bridge on lead-rubber bearings, for an isolation study (study.toml beside it).
#
#   Spans of 30, 40 and 30 m. A deck of elastic beams stands on two bearings on each abutment and each pier (Bouc-Wen shear).
#   The piers are single columns with fibers (Concrete01, Steel02), P-Delta. Gaps of 0.15 m separate the deck from the
#   backwalls, behind which the backfill resists (HyperbolicGapMaterial). The motion travels along the bridge: each support
#   moves by the record later than the one before it (MultipleSupport). The study sets the array "isolate"; without it the
#   script runs by itself with nominal bearings and the record of the Meloland overpass of 1979.
#
#     |=======o=========o=======|     deck, z = 8.6 m       z  y
#     #       #         #       #     bearings              | /
#     A       |         |       A     piers of 7 m          |/__ x
#             A         A             supports 1 to 4
#
# Units: kN, m, s, t.

set here [file dirname [file normalize [info script]]]
set g 9.81
foreach {name value} {bound nominal Q,ABUT 1.0 K,ABUT 1.0 Q,PIER 1.0 K,PIER 1.0 ex 0.0 ey 0.0 dt 0.01 points 3000} {
    if {![info exists isolate($name)]} { set isolate($name) $value }
}
set velocity 800.0 ;# of the waves along the bridge, m/s; 0 for the same motion everywhere

wipe
model BasicBuilder -ndm 3 -ndf 6
set supports {0.0 30.0 70.0 100.0}
set low 1.0 ;# foundation of the piers
set pier 7.0
set bearing 0.3
set eccentric 1.0 ;# deck axis above the bearings
set seat [expr {$low + $pier}]
set deck [expr {$seat + $bearing + $eccentric}]
set half 4.0 ;# half of the distance of two bearings

# ---------------------------------------------------------------- deck: nodes every 10 m, 14 t/m
set perMeter 14.0
set count 10
for {set k 0} {$k <= $count} {incr k} {
    set x [expr {10.0*$k}]
    node [expr {100 + $k}] $x 0.0 $deck
    set m [expr {$perMeter*10.0*($k == 0 || $k == $count ? 0.5 : 1.0)}]
    mass [expr {100 + $k}] $m $m $m [expr {$m*6.0}] [expr {$m*0.5}] [expr {$m*6.0}]
}
geomTransf Linear 1 0 0 1
for {set k 0} {$k < $count} {incr k} {
    element elasticBeamColumn [expr {100 + $k}] [expr {100 + $k}] [expr {101 + $k}] 5.0 3.2e7 1.3e7 6.0 3.0 40.0 1
}

# ---------------------------------------------------------------- piers: round columns of 1.6 m with fibers
uniaxialMaterial Concrete01 11 -4.2e4 -0.005 -3.4e4 -0.02
uniaxialMaterial Concrete01 12 -3.2e4 -0.002 -0.5e4 -0.006
uniaxialMaterial Steel02 13 4.6e5 2.0e8 0.01 18.0 0.925 0.15
section Fiber 1 -GJ 1.0e7 {
    patch circ 11 12 4 0.0 0.0 0.0 0.72 0.0 360.0
    patch circ 12 12 1 0.0 0.0 0.72 0.80 0.0 360.0
    layer circ 13 24 0.0008 0.0 0.0 0.72
}
geomTransf PDelta 2 1 0 0
set columns {}
foreach s {1 2} {
    set x [lindex $supports $s]
    node [expr {10 + $s}] $x 0.0 $low
    node [expr {20 + $s}] $x 0.0 $seat
    # The cap beam.
    mass [expr {20 + $s}] 30.0 30.0 30.0 40.0 10.0 40.0
    element forceBeamColumn $s [expr {10 + $s}] [expr {20 + $s}] 5 1 2 -iter 30 1.0e-10
    lappend columns $s
}

# ---------------------------------------------------------------- bearings: two on each support
uniaxialMaterial Elastic 1 1.5e6
uniaxialMaterial Elastic 2 200.0
set tag 200
set fixed {}
foreach s {0 1 2 3} {
    set x [lindex $supports $s]
    set name [expr {$s == 0 || $s == 3 ? "ABUT" : "PIER"}]
    set Qd [expr {($name eq "ABUT" ? 40.0 : 90.0)*$isolate(Q,$name)}]
    set Kd [expr {($name eq "ABUT" ? 700.0 : 1300.0)*$isolate(K,$name)}]
    set k [expr {int($x/10.0)}]
    foreach side {-1 1} {
        incr tag
        set lower [expr {$tag + 100}]
        set upper [expr {$tag + 200}]
        set y [expr {$side*$half}]
        node $lower $x $y $seat
        node $upper $x $y [expr {$seat + $bearing}]
        rigidLink beam [expr {100 + $k}] $upper
        if {$name eq "ABUT"} {
            lappend fixed $lower
        } else {
            rigidLink beam [expr {20 + $s}] $lower
        }
        element elastomericBearingBoucWen $tag $lower $upper [expr {10.0*$Kd}] $Qd 0.1 0.0 1.0 1.0 0.5 0.5 \
            -P 1 -T 2 -My 2 -Mz 2 -orient 0 0 1 1 0 0
    }
}

# ---------------------------------------------------------------- backfill: compression behind a gap, softened by a compressible layer
uniaxialMaterial HyperbolicGapMaterial 21 2.0e4 2.0e4 0.7 -4500.0 -0.15
node 501 [lindex $supports 0] 0.0 $deck
node 502 [lindex $supports 3] 0.0 $deck
lappend fixed 501 502
element zeroLength 501 501 100 -mat 21 -dir 1
element zeroLength 502 110 502 -mat 21 -dir 1

# ---------------------------------------------------------------- supports: held by single-point constraints, then moved
set moved [list 11 12 {*}$fixed]
foreach n $moved { fix $n 1 1 1 1 1 1 }

# ---------------------------------------------------------------- gravity
timeSeries Linear 1
pattern Plain 1 1 {
    for {set k 0} {$k <= $count} {incr k} {
        set w [expr {-$perMeter*10.0*($k == 0 || $k == $count ? 0.5 : 1.0)*$g}]
        load [expr {100 + $k}] 0.0 0.0 $w 0.0 0.0 0.0
    }
    foreach n {21 22} { load $n 0.0 0.0 [expr {-30.0*$g}] 0.0 0.0 0.0 }
}
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl 0.2
analysis Static
if {[analyze 5] != 0} { error "gravity failed" }
loadConst -time 0.0
wipeAnalysis

# ---------------------------------------------------------------- earthquake: the record arrives at a support x/velocity later
proc numbers {file factor} {
    set channel [open $file]
    set out {}
    foreach a [read $channel] { lappend out [expr {$a*$factor}] }
    close $channel
    return $out
}
# Displacements of an acceleration that is linear between samples, after some steps of rest.
proc displacements {a dt rest} {
    set out [lrepeat [expr {$rest + 1}] 0.0]
    set v 0.0
    set u 0.0
    foreach a0 [lrange $a 0 end-1] a1 [lrange $a 1 end] {
        set u [expr {$u + $dt*$v + $dt*$dt*(2.0*$a0 + $a1)/6.0}]
        set v [expr {$v + 0.5*$dt*($a0 + $a1)}]
        lappend out $u
    }
    return $out
}
if {[info exists isolate(ax)]} {
    set motion(1) $isolate(ax)
    set motion(2) $isolate(ay)
} else {
    set folder [file join $here .. ground_motions]
    set motion(1) [numbers [file join $folder meloland_1979_270_g.txt] $g]
    set motion(2) [numbers [file join $folder meloland_1979_360_g.txt] $g]
    set isolate(points) [llength $motion(1)]
}
set dt $isolate(dt)
set late 0
foreach s {0 1 2 3} {
    set rest [expr {$velocity > 0.0 ? int(round([lindex $supports $s]/$velocity/$dt)) : 0}]
    if {$rest > $late} { set late $rest }
    foreach d {1 2} {
        timeSeries Path [expr {10*($s + 1) + $d}] -dt $dt -values [displacements $motion($d) $dt $rest] -useLast
    }
}
# Nodes of a support by their place along the bridge.
proc supportOf {n} {
    global supports
    return [lsearch $supports [lindex [nodeCoord $n] 0]]
}
pattern MultipleSupport 2 {
    foreach s {0 1 2 3} {
        foreach d {1 2} {
            set id [expr {10*($s + 1) + $d}]
            groundMotion $id Plain -disp $id
        }
    }
    foreach n $moved {
        set s [supportOf $n]
        foreach d {1 2} {
            remove sp $n $d
            imposedMotion $n $d [expr {10*($s + 1) + $d}]
        }
    }
}
region 1 -ele 100 101 102 103 104 105 106 107 108 109 {*}$columns -rayleigh 0.0 0.0 0.002 0.0
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-7 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set steps [expr {int(($isolate(points) + $late)/2)}]
if {[analyze $steps [expr {2*$dt}]] != 0} { error "no convergence at [getTime] s" }
proc left {tag d} { return [expr {[nodeDisp [expr {$tag + 200}] $d] - [nodeDisp [expr {$tag + 100}] $d]}] }
foreach {tag text} {201 "abutment" 203 "pier"} {
    puts [format "bearing on the %s at the end: %.4f %.4f m" $text [left $tag 1] [left $tag 2]]
}
