# A house of two storeys on four recycled-rubber bearings with fibre reinforcement (RR-FRB): response histories.
#
#     hysteron run house.tcl <$device <$scale>>
#
#   $device is one of the models of models/: boucwen, hdr, kikuchi (Tables 6 to 8 of the paper that models/rr_frb.tcl cites) or rheology.
#   $scale multiplies the record of the Meloland overpass of 1979 along x and across y. A bearing carries 170 kN, as in the tests. They
#   go to a shear strain of 60 %; a response beyond it is refused, since no model has been identified there.
#
#         102  roof, 6.0 m
#          |
#         101  floor, 3.0 m
#          |                     y
#     #---100---#  slab          | x
#     o         o  bearings      +--
#
# Units: N, m, s, kg.

set here [file dirname [file normalize [info script]]]
set models [file join $here .. .. models]
set device [expr {$argc > 0 ? [lindex $argv 0] : "boucwen"}]
set scale [expr {$argc > 1 ? [lindex $argv 1] : 0.15}]
if {$device ni {boucwen hdr kikuchi rheology}} { error "unknown device $device: expected boucwen, hdr, kikuchi or rheology" }
source [file join $models rr_frb_$device.tcl]

set g 9.81
set weight [expr {4*170.0e3}]
set mass [expr {$weight/$g/3.0}] ;# of the slab, the floor and the roof
set side 6.0

model BasicBuilder -ndm 3 -ndf 6
foreach {node z} {100 0.21 101 3.21 102 6.21} {
    node $node 0.0 0.0 $z
    set turn [expr {$mass*$side**2/12.0}]
    mass $node $mass $mass $mass $turn $turn [expr {2.0*$turn}]
}
set pairs {}
set tag 0
foreach x {-3.0 3.0} {
    foreach y {-3.0 3.0} {
        incr tag
        node $tag $x $y 0.0
        fix $tag 1 1 1 1 1 1
        node [expr {10 + $tag}] $x $y 0.21
        rigidLink beam 100 [expr {10 + $tag}]
        rr_frb_$device $tag $tag [expr {10 + $tag}]
        lappend pairs $tag $tag [expr {10 + $tag}]
    }
}
# Walls of masonry: 0.13 s on a fixed base.
geomTransf Linear 1 1 0 0
foreach s {0 1} { element elasticBeamColumn [expr {100 + $s}] [expr {100 + $s}] [expr {101 + $s}] 6.0 2.0e9 0.8e9 6.0 3.0 3.0 1 }

timeSeries Linear 1
pattern Plain 1 1 { foreach node {100 101 102} { load $node 0.0 0.0 [expr {-$mass*$g}] 0.0 0.0 0.0 } }
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "gravity failed" }
loadConst -time 0.0
wipeAnalysis

set motions [file join $here .. ground_motions]
timeSeries Path 2 -dt 0.01 -filePath [file join $motions meloland_1979_270_g.txt] -factor [expr {$scale*$g}]
timeSeries Path 3 -dt 0.01 -filePath [file join $motions meloland_1979_360_g.txt] -factor [expr {$scale*$g}]
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3
region 1 -ele 100 101 -rayleigh 0.0 0.0 0.002 0.0
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-7 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient

file mkdir results/rr_frb_house
recorder Node -file results/rr_frb_house/slab.out -time -node 100 -dof 1 2 disp
recorder Element -file results/rr_frb_house/bearing1.out -time -ele 1 globalForce
set strain 0.0
set drift 0.0
for {set s 0} {$s < 1000} {incr s} {
    if {[analyze 1 0.02] != 0} { error "no convergence at [getTime] s" }
    rr_frb::within_tests $pairs
    foreach {tag lower upper} $pairs {
        set u [expr {hypot([nodeDisp $upper 1], [nodeDisp $upper 2])/$rr_frb::thickness}]
        if {$u > $strain} { set strain $u }
    }
    foreach {low high} {100 101 101 102} {
        foreach d {1 2} {
            set x [expr {abs([nodeDisp $high $d] - [nodeDisp $low $d])/3.0}]
            if {$x > $drift} { set drift $x }
        }
    }
}
puts [format "%s: largest shear strain of the bearings %.3f, storey drift ratio %.6f" $device $strain $drift]
