# Transverse motion (x) of a two-span bridge on a bent: the deck (along y) is a beam, held at both abutments as if they were rock,
# and by a spring, the bent, in the middle. The ground moves as the foot of the bent does.
# 20 t a metre of deck is assumed: only ratios of stiffness to mass are determined.
# Units: kN, m, t, s. A study sets south and north, the spans.
wipe
model basic -ndm 2 -ndf 3

pset EI 2.0e8    ;# of the deck about its vertical axis, kN m2
pset kb 1.0e5    ;# of the bent, kN/m
pset beta 0.003  ;# stiffness-proportional damping, s

set ys [list 0.0 [expr {0.5*$south}] $south [expr {$south+0.5*$north}] [expr {$south+$north}]]
for {set i 1} {$i <= 5} {incr i} {
    node $i 0.0 [lindex $ys [expr {$i-1}]]
    set from [lindex $ys [expr {max($i-2,0)}]]
    set to [lindex $ys [expr {min($i,4)}]]
    mass $i [expr {20.0*0.5*($to-$from)}] 0.0 0.0
}
fix 1 1 1 0
fix 2 0 1 0
fix 3 0 1 0
fix 4 0 1 0
fix 5 1 1 0
node 6 0.0 $south
fix 6 1 1 1

geomTransf Linear 1
for {set i 1} {$i <= 4} {incr i} {element elasticBeamColumn $i $i [expr {$i+1}] 1.0 1.0 $EI 1}
uniaxialMaterial Elastic 1 $kb
element zeroLength 5 6 3 -mat 1 -dir 1 -doRayleigh 1
rayleigh 0.0 0.0 $beta 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file acc.out -timeSeries 1 -time -node 1 2 3 4 5 -dof 1 accel

constraints Plain
numberer RCM
system ProfileSPD
test NormDispIncr 1.0e-10 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
