# A learned law for the Bouc-Wen benchmark, which knows nothing of its equation: a mass on a spring, a dashpot and hysteresis whose
# slopes are piecewise linear in the force along the motion. Each slope of loading is a part of that of unloading, so that the law
# makes no energy.
#
# Units: N, mm, s (mass in N s2/mm). Newmark with gamma 1/2, beta 1/4 at 15 kHz, every 20th step recorded (750 Hz).
wipe
model basic -ndm 1 -ndf 1

pset m  0.0018   ;# N s2/mm
pset k  60.0     ;# N/mm
pset c  0.020    ;# N s/mm
pset a  30.0     ;# initial slope of the hysteresis, N/mm
pset u1 1.5      ;# slopes of unloading over the initial one, at a quarter of the level and so on
pset u2 2.0
pset u3 2.5
pset u4 3.0
pset d1 0.3      ;# part by which loading is less steep there
pset d2 0.4
pset d3 0.5
pset d4 0.6

if {![info exists force]} {set force train.dat}
if {![info exists npts]}  {set npts 2048}
if {![info exists level]} {set level 2.0}
set every 20
set dt [expr {1.0/750/$every}]

node 1 0.0
node 2 0.0
fix 1 1
mass 2 $m
uniaxialMaterial Elastic 1 1.0
element zeroLength 1 1 2 -mat 1 -dir 1
amend element 1 learned -range 5.0 1000.0 200.0 -spring $k -dashpot 1 [expr {1000.0*$c}] \
    -hysteresis curve $level [expr {$a*$level}] \
    -curve $u4 $u3 $u2 $u1 1 [expr {$u1*(1-$d1)}] [expr {$u2*(1-$d2)}] [expr {$u3*(1-$d3)}] [expr {$u4*(1-$d4)}]

# The force at 15 kHz.
timeSeries Path 1 -dt $dt -filePath $force -useLast
pattern Plain 1 1 { load 2 1.0 }
recorder Node -file y.out -time -dT [expr {1.0/750}] -rTolDt 0.01 -node 2 -dof 1 disp
recorder Node -file v.out -time -dT [expr {1.0/750}] -rTolDt 0.01 -node 2 -dof 1 vel
recorder Element -file f.out -time -dT [expr {1.0/750}] -rTolDt 0.01 -ele 1 force

constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-12 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts*$every}] $dt] != 0} {error "no convergence at [getTime]"}
