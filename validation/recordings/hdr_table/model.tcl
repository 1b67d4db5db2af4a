# High damping rubber HDR3 in simple shear: one cycle of 175 % at a constant rate, by the rheology model as printed.
# Units: MPa and strain on a specimen of unit area and height, s, degC.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset scale 1.0    ;# factor on the printed stresses

uniaxialMaterial HDRRheology 1 -compound HDR3 -temperature $T
uniaxialMaterial Multiplier 2 1 $scale
element zeroLength 1 1 2 -mat 2 -dir 1

# 0, 1.75, -1.75, 0, and a little beyond, so that the cycle is complete.
set times {0.0}
set path {0.0}
set time 0.0
set at 0.0
foreach to {1.75 -1.75 0.0 0.02} {
    set time [expr {$time + abs($to - $at)/$rate}]
    set at $to
    lappend times $time
    lappend path $to
}
timeSeries Path 1 -time $times -values $path -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file stress.out -time -ele 1 force
recorder Node -file strain.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 50
algorithm Newton
set steps 468
integrator LoadControl [expr {$time/$steps}]
analysis Static
if {[analyze $steps] != 0} {error "no convergence at [getTime]"}
