# A base-isolated building under a near-fault earthquake.
#
#   Four storeys of 3 x 3 bays of 6 m, reinforced concrete frames, rigid diaphragms, on sixteen elastomeric bearings
#   (Bouc-Wen shear, P-Delta). Gravity first, then both horizontal components of the record of the Meloland
#   overpass, free field, Imperial Valley 1979 (see ground_motions/README.md).
#
#           o---o---o---o  level 5, roof
#           |   |   |   |
#           o---o---o---o  level 4
#           |   |   |   |          z
#           o---o---o---o  level 3 |  y
#           |   |   |   |          | /
#           o---o---o---o  level 2 |/___ x
#           |   |   |   |
#           o---o---o---o  level 1, base slab
#           #   #   #   #  bearings
#           o   o   o   o  level 0, ground
#
# Units: kN, m, s, t.
#
# Writes tables and pictures to results/isolated_building in the current folder. Only the pictures are not OpenSees'.

set here [file dirname [info script]]
set out results/isolated_building
file mkdir $out

wipe
model BasicBuilder -ndm 3 -ndf 6

# ---------------------------------------------------------------- geometry
set bays 3
set storeys 4
set bay 6.0
set storey 3.5
set bearing 0.30 ;# height of a bearing
set g 9.81

# Tag of the node at a level, column line i in x and j in y; the master of a diaphragm.
proc nodeAt {level i j} { return [expr {1000*$level + 10*$i + $j + 1}] }
proc master {level} { return [expr {1000*$level + 999}] }
proc height {level} {
    global bearing storey
    if {$level == 0} { return 0.0 }
    return [expr {$bearing + $storey*($level - 1)}]
}

set lines {}
for {set i 0} {$i <= $bays} {incr i} {
    for {set j 0} {$j <= $bays} {incr j} { lappend lines [list $i $j] }
}
set levels [expr {$storeys + 1}]

foreach line $lines {
    lassign $line i j
    for {set l 0} {$l <= $levels} {incr l} {
        node [nodeAt $l $i $j] [expr {$bay*$i}] [expr {$bay*$j}] [height $l]
    }
    fix [nodeAt 0 $i $j] 1 1 1 1 1 1
}

# ---------------------------------------------------------------- floors: mass at the master, 5 % off centre in plan
set side [expr {$bay*$bays}]
set floorMass 260.0
set polar [expr {$floorMass*2.0*$side**2/12.0}]
for {set l 1} {$l <= $levels} {incr l} {
    set m [master $l]
    node $m [expr {0.55*$side}] [expr {0.45*$side}] [height $l]
    fix $m 0 0 1 1 1 0
    mass $m $floorMass $floorMass 0.0 0.0 0.0 $polar
    set slaves {}
    foreach line $lines { lappend slaves [nodeAt $l {*}$line] }
    eval rigidDiaphragm 3 $m $slaves
    foreach s $slaves { mass $s 0.0 0.0 [expr {$floorMass/16.0}] 0.0 0.0 0.0 }
}

# ---------------------------------------------------------------- bearings
# Characteristic strength 10 % of the weight, period of the post-yield stiffness 2.2 s.
set weight [expr {$levels*$floorMass*$g}]
set Qd [expr {0.10*$weight/16.0}]
set Kd [expr {4.0*acos(-1.0)**2*($weight/$g)/2.2**2/16.0}]
set alpha 0.10
uniaxialMaterial Elastic 1 1.2e6 ;# axial
uniaxialMaterial Elastic 2 500.0 ;# torsion
uniaxialMaterial Elastic 3 2.0e4 ;# rotation
set tag 0
foreach line $lines {
    incr tag
    element elastomericBearingBoucWen $tag [nodeAt 0 {*}$line] [nodeAt 1 {*}$line] \
        [expr {$Kd/$alpha}] $Qd $alpha 0.0 2.0 1.0 0.5 0.5 \
        -P 1 -T 2 -My 3 -Mz 3 -orient 0 0 1 1 0 0
}

# ---------------------------------------------------------------- frames: columns 0.60 x 0.60, beams 0.30 x 0.60
geomTransf PDelta 1 1 0 0
geomTransf Linear 2 0 0 1
set E 3.0e7
set G 1.25e7
set tag 1000
foreach line $lines {
    lassign $line i j
    for {set l 1} {$l < $levels} {incr l} {
        incr tag
        element elasticBeamColumn $tag [nodeAt $l $i $j] [nodeAt [expr {$l + 1}] $i $j] 0.36 $E $G 0.0182 0.0108 0.0108 1
    }
    for {set l 1} {$l <= $levels} {incr l} {
        # The beams of the base slab are three times as stiff.
        set Iz [expr {$l == 1 ? 0.0162 : 0.0054}]
        foreach {di dj} {1 0  0 1} {
            if {$i + $di <= $bays && $j + $dj <= $bays} {
                incr tag
                element elasticBeamColumn $tag [nodeAt $l $i $j] [nodeAt $l [expr {$i + $di}] [expr {$j + $dj}]] \
                    0.18 $E $G 0.004 0.0014 $Iz 2
            }
        }
    }
}
set last $tag

# ---------------------------------------------------------------- gravity
timeSeries Linear 1
pattern Plain 1 1 {
    foreach line $lines {
        for {set l 1} {$l <= $levels} {incr l} {
            load [nodeAt $l {*}$line] 0.0 0.0 [expr {-$floorMass*$g/16.0}] 0.0 0.0 0.0
        }
    }
}
constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "gravity failed" }
loadConst -time 0.0
wipeAnalysis

# ---------------------------------------------------------------- earthquake
# Damping of the frames alone, proportional to their stiffness: 2 % at 2.5 Hz. The bearings damp by themselves.
region 1 -eleRange 1001 $last -rayleigh 0.0 0.0 [expr {2*0.02/(2*acos(-1.0)*2.5)}] 0.0
timeSeries Path 2 -dt 0.01 -filePath [file join $here ground_motions meloland_1979_270_g.txt] -factor $g
timeSeries Path 3 -dt 0.01 -filePath [file join $here ground_motions meloland_1979_360_g.txt] -factor $g
pattern UniformExcitation 2 1 -accel 2
pattern UniformExcitation 3 2 -accel 3

set masters {}
for {set l 1} {$l <= $levels} {incr l} { lappend masters [master $l] }
recorder Node -file $out/base.out -time -node [master 1] -dof 1 2 disp
recorder Element -file $out/bearing.out -time -ele 1 localForce
recorder Element -file $out/deformation.out -time -ele 1 deformation
eval recorder Node -file $out/reaction.out -time -node [lmap line $lines {nodeAt 0 {*}$line}] -dof 1 2 reaction
foreach {dof axis} {1 x 2 y} {
    eval recorder EnvelopeDrift -file $out/drift_$axis.out \
        -iNode [lrange $masters 0 end-1] -jNode [lrange $masters 1 end] -dof $dof -perpDirn 3
    eval recorder EnvelopeElement -file $out/shear_$axis.out -eleRange 1 16 -dof [expr {1 + $dof}] deformation
}

constraints Transformation
numberer RCM
system UmfPack
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set dt 0.01
set duration 30.0
if {[analyze [expr {int($duration/$dt)}] $dt] != 0} { error "no convergence at [getTime] s" }
remove recorders

# ---------------------------------------------------------------- results
# The columns of a table, as lists.
proc table {file} {
    set f [open $file]
    set columns {}
    foreach line [split [string trim [read $f]] \n] {
        set i 0
        foreach x $line { lappend c($i) $x; incr i }
    }
    close $f
    for {set k 0} {$k < $i} {incr k} { lappend columns $c($k) }
    return $columns
}
proc peak {values} {
    set peak 0.0
    foreach v $values { if {abs($v) > $peak} { set peak [expr {abs($v)}] } }
    return $peak
}

lassign [table $out/deformation.out] time axial uy uz
lassign [table $out/base.out] time ux1 uy1
set orbit 0.0
foreach a $uy b $uz { set r [expr {hypot($a, $b)}]; if {$r > $orbit} { set orbit $r } }
puts [format "peak displacement of the corner bearing  %6.1f mm" [expr {1000*$orbit}]]

foreach axis {x y} {
    # The third row of an envelope is the largest absolute value.
    set drift($axis) [lmap column [table $out/drift_$axis.out] {lindex $column 2}]
    puts [format "peak storey drifts in %s                  %s %%" $axis \
        [join [lmap d $drift($axis) {format %.3f [expr {100*$d}]}] "  "]]
}
set reactions [table $out/reaction.out]
set offset 1
foreach axis {x y} {
    set shear {}
    for {set k 0} {$k < [llength $time]} {incr k} {
        set sum 0.0
        for {set c $offset} {$c <= 32} {incr c 2} { set sum [expr {$sum + [lindex $reactions $c $k]}] }
        lappend shear $sum
    }
    incr offset
    puts [format "peak base shear in %s                     %6.0f kN  (%.3f of the weight)" \
        $axis [peak $shear] [expr {[peak $shear]/$weight}]]
}

if {[llength [info commands figure]]} {
    lassign [table $out/bearing.out] time n1 vy1 vz1 t1 my1 mz1 n2 vy2 vz2
    figure $out/bearing_loops.svg -title "Corner bearing" -x "shear displacement (m)" -y "shear force (kN)" \
        -line "along x" $uy $vy2 -line "along y" $uz $vz2
    figure $out/plan_orbit.svg -title "Base slab, seen from above" -x "displacement in x (m)" \
        -y "displacement in y (m)" -equal -line "" $ux1 $uy1
    set storeyNumbers {}
    for {set s 1} {$s <= $storeys} {incr s} { lappend storeyNumbers $s }
    foreach axis {x y} { set percent($axis) [lmap d $drift($axis) {expr {100*$d}}] }
    figure $out/drift_profile.svg -title "Peak storey drifts" -x "drift (% of the storey height)" -y "storey" \
        -xrange 0.0 [expr 110*max([join [concat $drift(x) $drift(y)] ,])] \
        -line "in x" $percent(x) $storeyNumbers -line "in y" $percent(y) $storeyNumbers
    puts "pictures: $out/bearing_loops.svg  $out/plan_orbit.svg  $out/drift_profile.svg"
}
wipe
