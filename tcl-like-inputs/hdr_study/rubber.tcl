# High damping rubber in the laboratory: the model of a study.
#
#   hysteron calibrate tcl-like-inputs/hdr_study/study.toml
#
# All ten parameters of the rheology at once, from a sine, a slow cycle, a relaxation and a multi-step relaxation. The recordings
# were made by the law itself, with the parameters of HDR3 at 23 degC (D. A. Nguyen, A rheology model of high damping rubber
# bearings for seismic analysis at room and low temperatures, dissertation, Tables 3.1 and 3.2) and noise of 0.01 MPa:
# what comes back can be compared with what went in. Units: MPa, s.
wipe
model basic -ndm 1 -ndf 1
node 1 0.0
node 2 0.0
fix 1 1

pset C1eq    8.0
pset C2eq    0.5
pset C3eq    0.01
pset tauCrEq 0.4
pset m       5.0
pset C1oe    8.0
pset C2oe    1.0
pset tauCrOe 1.0
pset a       2.0
pset n       0.3
uniaxialMaterial HDRRheology 1 $C1eq $C2eq $C3eq $tauCrEq $m $C1oe $C2oe $tauCrOe $a $n
element zeroLength 1 1 2 -mat 1 -dir 1

# A run gives its strain history: times and strains. Steps are from a millisecond to ten minutes.
if {![info exists motion]} { set motion sine.dat }
lassign [columns $motion] times strains
timeSeries Path 1 -time $times -values $strains -useLast
pattern Plain 1 1 { sp 2 1 1.0 }
recorder Element -file stress.out -time -precision 9 -ele 1 material 1 stress

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
