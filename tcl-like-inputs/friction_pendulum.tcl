# A heavy mass on a triple friction pendulum: slow cycles of growing amplitude under its weight, which show the regimes of
# sliding, then an earthquake in both horizontal directions.
#
#   The bearing is that of models/triple_pendulum_kim_2023.tcl. First only the inner surfaces slide, with the
#   stiffness W/(2 L1); then one outer surface after the other, W/(L1 + L2) and W/(L2 + L3); at the end of the inner path
#   the bearing stiffens again (Fenz and Constantinou, 2008).
#
# Units: N, m, s, kg.

set here [file dirname [info script]]
source [file join $here .. models triple_pendulum_kim_2023.tcl]
set g 9.81
set weight 13345.0e3
set pi [expr {acos(-1.0)}]

proc isolated {} {
    global weight g
    wipe
    model BasicBuilder -ndm 3 -ndf 6
    node 1 0 0 0
    node 2 0 0 0
    fix 1 1 1 1 1 1 1
    fix 2 0 0 0 1 1 1
    set m [expr {$weight/$g}]
    mass 2 $m $m $m 0 0 0
    triplePendulum 1 1 2 1 $weight
    timeSeries Linear 1
    pattern Plain 1 1 { load 2 0 0 [expr {-$::weight}] 0 0 0 }
    system FullGeneral
    numberer Plain
    constraints Transformation
    test NormUnbalance 1.0 50
    algorithm Newton
    integrator LoadControl 0.1
    analysis Static
    if {[analyze 10] != 0} { error "no equilibrium under the weight" }
    loadConst -time 0.0
    wipeAnalysis
}

# Cycles: the shear over the weight at the peaks.
isolated
set steps 100
foreach amplitude {0.02 0.2 0.6 1.0} {
    for {set k 1} {$k <= $steps} {incr k} {
        lappend path [expr {$amplitude*sin(2.0*$pi*$k/$steps)}]
    }
}
timeSeries Path 2 -dt 1.0 -values [linsert $path 0 0.0]
pattern Plain 2 2 { sp 2 1 1.0 }
system FullGeneral
numberer Plain
constraints Transformation
test NormUnbalance 1.0 50
algorithm Newton
integrator LoadControl 1.0
analysis Static
puts "amplitude (m)   shear over weight   secant stiffness (MN/m)"
foreach amplitude {0.02 0.2 0.6 1.0} {
    if {[analyze [expr {$steps/4}]] != 0} { error "the cycles fail" }
    set shear [lindex [eleResponse 1 basicForce] 1]
    puts [format "%10.2f %18.4f %20.2f" $amplitude [expr {$shear/$weight}] [expr {$shear/$amplitude/1e6}]]
    if {[analyze [expr {3*$steps/4}]] != 0} { error "the cycles fail" }
}

# Earthquake: Meloland overpass, free field, Imperial Valley 1979 (see ground_motions/README.md).
isolated
timeSeries Path 3 -dt 0.01 -filePath [file join $here ground_motions meloland_1979_270_g.txt] -factor $g
timeSeries Path 4 -dt 0.01 -filePath [file join $here ground_motions meloland_1979_360_g.txt] -factor $g
pattern UniformExcitation 3 1 -accel 3
pattern UniformExcitation 4 2 -accel 4
system FullGeneral
numberer Plain
constraints Transformation
test NormUnbalance 10.0 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set peak 0.0
set force 0.0
for {set k 0} {$k < 2000} {incr k} {
    if {[analyze 1 0.01] != 0} { error "the earthquake fails at [getTime]" }
    set peak [expr {max($peak, hypot([nodeDisp 2 1], [nodeDisp 2 2]))}]
    lassign [eleResponse 1 basicForce] normal x y
    set force [expr {max($force, hypot($x, $y)/$weight)}]
}
puts [format "earthquake: peak displacement %.3f m, peak shear %.3f of the weight, left behind %.3f m" \
    $peak $force [expr {hypot([nodeDisp 2 1], [nodeDisp 2 2])}]]
