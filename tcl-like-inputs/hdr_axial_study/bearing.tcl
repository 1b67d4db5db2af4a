# A recycled rubber bearing under three axial loads: the model of a study whose analyst took the HDR element.
#
#   hysteron diagnose tcl-like-inputs/hdr_axial_study/study.toml
#
# The recordings are of a Kikuchi bearing in OpenSees (kikuchi.tcl): its lateral stiffness falls with the axial load and with the
# shear displacement. Grant's law of shear in the HDR element knows no axial load. "Identification and Calibration of Advanced Hysteresis
# Models for Recycled Rubber-Fiber-Reinforced Bearings" finds that HDR misses the softening that Kikuchi's element has.
# Units: N, m, s.
wipe
model basic -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.21
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1

# Stresses of Eqs 4 and 5, MPa; beta3 has no unit. They are those of the paper's Table 7.
pset alpha1 0.32
pset beta1  0.188
pset beta2  0.187
pset beta3  5.77
source ../../models/rr_frb_hdr.tcl
rr_frb_hdr 1 1 2 {0 0 1} {1 0 0} {0.012 0.086 1.836 0.00025} [list $alpha1 -0.01 0.003] [list $beta1 $beta2 $beta3]

# A run gives its recording and its axial load.
if {![info exists recorded]} { set recorded heavy.csv }
if {![info exists axial]}    { set axial 180.0e3 }
timeSeries Linear 1
pattern Plain 1 1 "load 2 0.0 0.0 [expr {-$axial}] 0.0 0.0 0.0"
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "no equilibrium under the axial load" }
loadConst -time 0.0

lassign [columns $recorded] times path
timeSeries Path 2 -time $times -values $path -useLast
pattern Plain 2 2 { sp 2 1 1.0 }
recorder Element -file force.out -time -ele 1 force
integrator LoadControl [expr {[lindex $times 1] - [lindex $times 0]}]
foreach t [lrange $times 1 end] {
    if {[analyze 1] != 0} { error "no convergence at $t" }
}
