# An isolated building of eight storeys with a nonlinear frame and a moat wall, for an isolation study (study.toml beside it).
#
#   One frame of three bays of 6 m: reinforced concrete columns and beams with fibers (Concrete01, Steel02), P-Delta, on four
#   lead-rubber bearings (Bouc-Wen shear). The base slab has a gap of 0.45 m to a moat wall on each side (ImpactMaterial).
#   The study sets the array "isolate"; without it the script runs by itself with nominal bearings and the record of the
#   Meloland overpass of 1979. fixed_base.tcl is the same frame without bearings.
#
#         o---o---o---o  level 9, roof
#         |   |   |   |       ...
#         o---o---o---o  level 2
#         |   |   |   |          y
#     |   o===o===o===o   |  level 1, base slab    | x
#     |   #   #   #   #   |  bearings, moat walls  +--
#
# Units: kN, m, s, t. The masses, loads and bearings are those of a strip of 6 m.

set here [file dirname [file normalize [info script]]]
set g 9.81
foreach {name value} {bound nominal Q,LRB 1.0 K,LRB 1.0 ex 0.0 ey 0.0 dt 0.01 points 3000} {
    if {![info exists isolate($name)]} { set isolate($name) $value }
}
if {![info exists fixedBase]} { set fixedBase 0 }

wipe
model BasicBuilder -ndm 2 -ndf 3
set bays 3
set bay 6.0
set levels 9 ;# base slab, seven floors and the roof
set storey 3.5
set bearing 0.35
set mass 108.0 ;# of a floor: 10 kN/m2 on 6 m x 18 m
set gap 0.45

# Tag of the node at a level and a column line; level 0 is the ground.
proc nodeAt {level line} { return [expr {10*$level + $line}] }

proc height {level} {
    global storey bearing
    if {$level == 0} { return 0.0 }
    return [expr {$bearing + $storey*($level - 1)}]
}

# ---------------------------------------------------------------- nodes and masses, by their share of the bays
for {set l 0} {$l <= $levels} {incr l} {
    for {set i 0} {$i <= $bays} {incr i} {
        node [nodeAt $l $i] [expr {$bay*$i}] [height $l]
        set share [expr {($i == 0 || $i == $bays ? 0.5 : 1.0)/$bays}]
        set m [expr {$share*$mass}]
        if {$l > 0} { mass [nodeAt $l $i] $m $m 1.0e-6 }
    }
}
for {set i 0} {$i <= $bays} {incr i} {
    if {$fixedBase} { fix [nodeAt 1 $i] 1 1 1 }
    fix [nodeAt 0 $i] 1 1 1
}

# ---------------------------------------------------------------- bearings
if {!$fixedBase} {
    set Qd [expr {120.0*$isolate(Q,LRB)}]
    set Kd [expr {1220.0*$isolate(K,LRB)}]
    uniaxialMaterial Elastic 1 2.5e6
    uniaxialMaterial Elastic 2 1.0e3
    for {set i 0} {$i <= $bays} {incr i} {
        element elastomericBearingBoucWen [expr {$i + 1}] [nodeAt 0 $i] [nodeAt 1 $i] [expr {10.0*$Kd}] $Qd 0.1 0.0 1.0 \
            1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0
    }
    # Moat walls: node 8 stands at the left, node 9 at the right. A wall of concrete backed by soil.
    node 8 0.0 [height 1]
    node 9 [expr {$bay*$bays}] [height 1]
    fix 8 1 1 1
    fix 9 1 1 1
    uniaxialMaterial ImpactMaterial 3 2.0e5 1.0e5 -0.01 [expr {-$gap}]
    element zeroLength 11 8 [nodeAt 1 0] -mat 3 -dir 1
    element zeroLength 12 [nodeAt 1 $bays] 9 -mat 3 -dir 1
}

# ---------------------------------------------------------------- sections: core, cover and steel
uniaxialMaterial Concrete01 11 -4.0e4 -0.004 -3.2e4 -0.02
uniaxialMaterial Concrete01 12 -3.0e4 -0.002 -0.6e4 -0.006
uniaxialMaterial Steel02 13 4.5e5 2.0e8 0.01 18.0 0.925 0.15
# A section of width b and depth h with bars of an area in total, half of it at the top and half at the bottom.
proc rectangular {tag b h bars} {
    set c 0.05
    set y [expr {0.5*$h}]
    set z [expr {0.5*$b}]
    set yc [expr {$y - $c}]
    set zc [expr {$z - $c}]
    section Fiber $tag {
        patch rect 11 10 1 [expr {-$yc}] [expr {-$zc}] $yc $zc
        patch rect 12 10 1 [expr {-$yc}] $zc $yc $z
        patch rect 12 10 1 [expr {-$yc}] [expr {-$z}] $yc [expr {-$zc}]
        patch rect 12 1 1 $yc [expr {-$z}] $y $z
        patch rect 12 1 1 [expr {-$y}] [expr {-$z}] [expr {-$yc}] $z
        layer straight 13 2 [expr {0.25*$bars}] $yc [expr {-$zc}] $yc $zc
        layer straight 13 2 [expr {0.25*$bars}] [expr {-$yc}] [expr {-$zc}] [expr {-$yc}] $zc
    }
}
rectangular 1 0.65 0.65 0.0110 ;# columns of storeys 1 to 4
rectangular 2 0.55 0.55 0.0080 ;# columns of storeys 5 to 8
rectangular 3 0.40 0.65 0.0050 ;# beams

# ---------------------------------------------------------------- members
geomTransf PDelta 1
geomTransf Linear 2
beamIntegration Lobatto 1 1 4
beamIntegration Lobatto 2 2 4
beamIntegration Lobatto 3 3 4
set members {}
for {set l 1} {$l < $levels} {incr l} {
    for {set i 0} {$i <= $bays} {incr i} {
        set tag [expr {100 + 10*$l + $i}]
        element forceBeamColumn $tag [nodeAt $l $i] [nodeAt [expr {$l + 1}] $i] 1 [expr {$l <= 4 ? 1 : 2}]
        lappend members $tag
    }
}
set beams {}
for {set l 1} {$l <= $levels} {incr l} {
    for {set i 0} {$i < $bays} {incr i} {
        set tag [expr {300 + 10*$l + $i}]
        if {$l == 1} {
            if {!$fixedBase} { element elasticBeamColumn $tag [nodeAt 1 $i] [nodeAt 1 [expr {$i + 1}]] 1.2 3.0e7 0.5 2 }
        } else {
            element forceBeamColumn $tag [nodeAt $l $i] [nodeAt $l [expr {$i + 1}]] 2 3
            lappend members $tag
            lappend beams $tag
        }
    }
}

# ---------------------------------------------------------------- gravity: a uniform load on the beams, nodes on the slab
set line [expr {$mass*$g/($bay*$bays)}]
timeSeries Linear 1
pattern Plain 1 1 {
    foreach tag $beams { eleLoad -ele $tag -type -beamUniform [expr {-$line}] }
    for {set i 0} {$i <= $bays} {incr i} {
        set share [expr {($i == 0 || $i == $bays ? 0.5 : 1.0)*$bay}]
        load [nodeAt 1 $i] 0.0 [expr {-$line*$share}] 0.0
    }
}
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "gravity failed" }
loadConst -time 0.0
wipeAnalysis

# ---------------------------------------------------------------- earthquake
if {[info exists isolate(ax)]} {
    timeSeries Path 2 -dt $isolate(dt) -values $isolate(ax)
} else {
    timeSeries Path 2 -dt 0.01 -filePath [file join $here .. ground_motions meloland_1979_270_g.txt] -factor $g
}
pattern UniformExcitation 2 1 -accel 2
# Damping of the frame alone, none on the bearings: 2 % at 0.5 s, by its initial stiffness.
region 1 -ele {*}$members -rayleigh 0.0 0.0 [expr {2.0*0.02*0.5/6.283185}] 0.0
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-7 60
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient

set peaks {}
proc watch {} {
    global levels storey peaks
    set slab [nodeDisp [nodeAt 1 0] 1]
    set drift 0.0
    for {set l 1} {$l < $levels} {incr l} {
        set d [expr {abs([nodeDisp [nodeAt [expr {$l + 1}] 0] 1] - [nodeDisp [nodeAt $l 0] 1])/$storey}]
        if {$d > $drift} { set drift $d }
    }
    lappend peaks [list [expr {abs($slab)}] $drift]
}
set steps [expr {int($isolate(points)/2)}]
for {set s 0} {$s < $steps} {incr s} {
    if {[analyze 1 [expr {2*$isolate(dt)}]] != 0} { error "no convergence at [getTime] s" }
    watch
}
foreach {k text} {0 "base slab: largest displacement, m" 1 "largest storey drift ratio"} {
    set top 0.0
    foreach p $peaks { if {[lindex $p $k] > $top} { set top [lindex $p $k] } }
    puts [format "%s: %.5f" $text $top]
}
