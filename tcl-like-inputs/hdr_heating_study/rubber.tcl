# A high damping rubber bearing in the tests of a dissertation: the model of a study whose rubber heats and softens.
#
#   hysteron diagnose tcl-like-inputs/hdr_heating_study/study.toml
#
# The analyst knows compound HDR3 at the temperature of the chamber, and fits a factor on each of its parts to this batch of
# rubber. The tests are of virgin specimens that warm themselves, which the model leaves out. D. A. Nguyen, A rheology model of
# high damping rubber bearings for seismic analysis at room and low temperatures, dissertation, asks for both in section
# 6.5. validation/identification/thesis/integrator.py made the recordings, without this program. Units: MPa, s, degC.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset spring     1.0 ;# C2eq, C3eq
pset friction   1.0 ;# C1eq, tauCrEq
pset overstress 1.0 ;# C1oe, C2oe, tauCrOe
pset viscosity  1.0 ;# a

# Tables 3.1 and 3.2 with the factors, as a compound of its own.
set f [open batch.txt w]
foreach {T C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a n} {
    -30 13.4 0.511 0.0055 0.561 5.62 19.2 1.253 1.365 3.93 0.248
    -10 8.84 0.442 0.0181 0.405 3.94 10.4 0.681 0.932 2.53 0.251
     23 7.12 0.486 0.0079 0.355 5.03 10.2 0.652 0.711 1.45 0.238
} {
    puts $f [list $T [expr {$friction*$C1eq}] [expr {$spring*$C2eq}] [expr {$spring*$C3eq}] [expr {$friction*$tauCrEq}] $m \
        [expr {$overstress*$C1oe}] [expr {$overstress*$C2oe}] [expr {$overstress*$tauCrOe}] [expr {$viscosity*$a}] $n]
}
close $f

# A run gives its recording and the temperature of the chamber.
if {![info exists chamber]} { set chamber -30 }
if {![info exists recorded]} { set recorded sine_a.csv }
uniaxialMaterial HDRRheology 1 -compound batch.txt -temperature $chamber
element zeroLength 1 1 2 -mat 1 -dir 1

lassign [columns $recorded] times strains
timeSeries Path 1 -time $times -values $strains -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file stress.out -time -ele 1 material 1 stress
recorder Element -file inside.out -time -ele 1 material 1 temperature

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-10 20
algorithm Newton
analysis Static
set last 0.0
foreach t [lrange $times 1 end] {
    integrator LoadControl [expr {$t - $last}]
    if {[analyze 1] != 0} { error "no convergence at $t" }
    set last $t
}
