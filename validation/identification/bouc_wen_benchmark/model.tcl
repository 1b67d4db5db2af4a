# The Bouc-Wen benchmark of nonlinearbenchmark.org (Noël and Schoukens, "Hysteretic benchmark with a dynamic
# nonlinearity", 2016):
#
#   m y'' + c y' + k y + z = u,   z' = alpha y' - beta (gamma |y'| |z|^(nu-1) z + delta y' |z|^nu)
#
# with m 2 kg, c 10 Ns/m, k 5e4 N/m, alpha 5e4 N/m, beta 1e3, gamma 0.8, delta -1.1, nu 1; u a force, y the displacement.
#
# uniaxialMaterial BoucWen keeps z over alpha, a displacement ζ: with nu = 1
#   F = k y + alpha ζ,   ζ' = y' (1 - |ζ| (beta delta + beta gamma sgn(y' ζ))).
#
# Units: N, mm, s (mass in N s2/mm). Newmark with gamma 1/2, beta 1/4 at 15 kHz, every 20th step recorded (750 Hz).
wipe
model basic -ndm 1 -ndf 1

pset k     50.0     ;# N/mm
pset alpha 50.0     ;# N/mm
pset bg     0.8     ;# beta gamma, 1/mm
pset bd    -1.1     ;# beta delta, 1/mm
pset c     0.010    ;# N s/mm

if {![info exists force]} {set force train.dat}
if {![info exists npts]}  {set npts 2048}
# The exponent of the benchmark is 1. For others beta is 1e3 20^(1-nu) in N and m, which is this times 1/mm^nu for ζ.
if {![info exists nu]}    {set nu 1.0}
set scale [expr {1.0e3*pow(2500.0, $nu-1.0)*pow(1.0e-3, $nu)}]
set every 20
# Steps of the true system between two values of the force: at exponents above 1 its hysteretic force rises steeply.
set parts [expr {$nu > 1.0 ? 8 : 1}]
set dt [expr {1.0/750/$every/$parts}]

node 1 0.0
node 2 0.0
fix 1 1
mass 2 0.002

set ko [expr {$k+$alpha}]
uniaxialMaterial BoucWen 1 [expr {$k/$ko}] $ko $nu [expr {$scale*$bd}] [expr {$scale*$bg}] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 2 $c 1.0
element zeroLength 1 1 2 -mat 1 2 -dir 1 1

# The force at 15 kHz.
timeSeries Path 1 -dt [expr {$dt*$parts}] -filePath $force -useLast
pattern Plain 1 1 { load 2 1.0 }
recorder Node -file y.out -time -dT [expr {1.0/750}] -rTolDt 0.01 -node 2 -dof 1 disp

constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-12 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts*$every*$parts}] $dt] != 0} {error "no convergence at [getTime]"}
