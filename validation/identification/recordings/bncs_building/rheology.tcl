# The building of model.tcl on one spring of the rheology of high damping rubber (HDRRheology) at constant temperature. Compound HDR3
# at 23 degC has factors on its parts: spring, friction, overstress and viscosity. Units: kN, m, t, s; stresses of the compound in
# MPa, hence the area in square metres times 1000.
wipe
model basic -ndm 2 -ndf 3

pset area 0.26   ;# m2, of all isolators
pset height 0.15 ;# m of rubber
pset spring 1.0     ;# factor on C2eq, C3eq
pset friction 1.0   ;# on C1eq, tauCrEq
pset overstress 1.0 ;# on C1oe, C2oe, tauCrOe
pset viscosity 1.0  ;# on a
pset n 0.238        ;# power of the dashpot
pset excess 0.2     ;# of the virgin stress, lost over a strain of 0.6
pset ks     250000.0  ;# stiffness of a storey, kN/m
pset cs     500.0     ;# its damping, kN s/m

for {set i 1} {$i <= 7} {incr i} {node $i 0.0 0.0}
fix 1 1 1 1
for {set i 2} {$i <= 7} {incr i} {
    fix $i 0 1 1
    mass $i 75.0 75.0 1.0
}
lassign {7.12 0.486 0.0079 0.355 5.03 10.2 0.652 0.711 1.45} C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a
uniaxialMaterial HDRRheology 1 [expr {$friction*$C1eq}] [expr {$spring*$C2eq}] [expr {$spring*$C3eq}] \
    [expr {$friction*$tauCrEq}] $m [expr {$overstress*$C1oe}] [expr {$overstress*$C2oe}] [expr {$overstress*$tauCrOe}] \
    [expr {$viscosity*$a}] $n -area [expr {1000.0*$area}] -height $height -mullins $excess 0.6
element zeroLength 1 1 2 -mat 1 -dir 1
uniaxialMaterial Elastic 2 $ks
uniaxialMaterial Viscous 3 $cs 1.0
for {set i 2} {$i <= 6} {incr i} {
    element zeroLength $i $i [expr {$i+1}] -mat 2 3 -dir 1 1
}

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 7 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 7 -dof 1 accel

constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
