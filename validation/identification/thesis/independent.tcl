# The law with self-heating and softening against the recordings of `integrator.py`, which integrates the same equations with scipy.
#
#   hysteron run validation/identification/thesis/independent.tcl
#
# What remains is the noise of the recordings, 0.02 MPa. Units: MPa, s, degC.

set study [file normalize [file join [file dirname [info script]] ../../../tcl-like-inputs/hdr_heating_study]]
set f [open $study/rubber.tcl]
set model [read $f]
close $f
set concealed {-temperature $chamber -heatCapacity 3.29176 -beyond hold -mullins 0.25 0.6}
set model [string map [list {-temperature $chamber} $concealed {spring     1.0} {spring 1.06} {friction   1.0} {friction 0.92} \
    {overstress 1.0} {overstress 1.08} {viscosity  1.0} {viscosity 0.95}] $model]
foreach {name temperature} {sine_a -30 sine_b -10 slow_c -20 fast_d 23} {
    set chamber $temperature
    set recorded $study/$name.csv
    eval $model
    wipe
    lassign [columns $recorded] t g stress
    lassign [columns stress.out] t simulated
    set sum 0.0
    foreach a [lrange $stress 1 end] b $simulated { set sum [expr {$sum + ($a - $b)**2}] }
    set deviation [expr {sqrt($sum/[llength $simulated])}]
    puts [format "%s: %.4f MPa" $name $deviation]
    if {$deviation > 0.022} { error "$name differs by more than the noise" }
}
