# A high damping rubber bearing on a testing machine: growing cycles of shear under a constant axial load, then tension.
#
#   Element HDR: Grant's shear law with scragging beside Kumar's axial law. Three things to look for:
#     - the first cycle of each size is stiffer than the second (scragging and the Mullins effect);
#     - the vertical stiffness falls while the bearing is sheared;
#     - in tension it cavitates at 3 G A, and a bearing that has cavitated is weaker the next time.
#
#   Diameter 600 mm with a hole of 150 mm, 28 layers of 6 mm; parameters of the rubber in the style of Grant, Fenves and
#   Whittaker (2004), round numbers for show, not those of a product.
#
# Units: N, m.

source [file join [file dirname [info script]] .. models rubber.tcl]

set pi 3.141592653589793
set G 0.45e6            ;# shear modulus of the rubber
set K 2.0e9             ;# bulk modulus
set D1 0.15
set D2 0.60
set ts 0.003            ;# shim
set tr 0.006            ;# layer of rubber
set n 28
set T [expr {$n*$tr}]
set A [expr {$pi/4.0*($D2**2 - $D1**2)}]
set height [expr {$T + ($n - 1)*$ts}]
set load 1.0e6

wipe
model BasicBuilder -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 $height
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1     ;# the machine keeps the plates parallel

# alpha1 alpha2 alpha3 (Pa), beta1 beta2 (Pa) beta3, chi1 chi2 chi3 chi4
set shear [rubber::grant {0.70e6 -0.11e6 0.045e6} {0.07e6 0.04e6 10.0} {0.02 0.007 0.75 0.014} $A $T]
element HDR 1 1 2 $G $K $D1 $D2 $ts $tr $n {*}$shear 0 0 1 1 0 0 20.0 0.75 1.0 0.5 0.0 0.0

# Axial load
timeSeries Linear 1
pattern Plain 1 1 { load 2 0.0 0.0 [expr {-$load}] 0.0 0.0 0.0 }
constraints Transformation
numberer Plain
system BandGeneral
test NormUnbalance 1.0e-4 20
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "no equilibrium under the axial load" }
loadConst -time 0.0
set height0 [nodeDisp 2 3]

# Shear: two cycles of each size
set path {0.0}
foreach strain {0.5 0.5 1.0 1.0 1.5 1.5} {
    foreach peak [list $strain [expr {-$strain}] 0.0] {
        set from [lindex $path end]
        for {set i 1} {$i <= 40} {incr i} { lappend path [expr {$from + ($peak*$T - $from)*$i/40.0}] }
    }
}
timeSeries Path 2 -dt 1.0 -values $path
pattern Plain 2 2 { sp 2 1 1.0 }
integrator LoadControl 1.0

puts "shear strain   secant stiffness (kN/m)   settlement under shear (mm)"
set peaks {}
for {set i 1} {$i < [llength $path]} {incr i} {
    if {[analyze 1] != 0} { error "no equilibrium at step $i" }
    if {$i % 120 == 40} {
        set u [nodeDisp 2 1]
        set k [expr {1e-3*[lindex [eleResponse 1 basicForce] 1]/$u}]
        lappend peaks $k
        puts [format "%10.2f %21.0f %27.3f" [expr {$u/$T}] $k [expr {1e3*([nodeDisp 2 3] - $height0)}]]
    }
}
lassign [lrange $peaks 2 3] first second
puts [format "at 100 %% the second cycle is %.0f %% softer than the first" [expr {100.0*(1.0 - $second/$first)}]]

# Tension: pulled twice to the same height
loadConst -time 0.0
remove loadPattern 1
set cavitation [expr {3.0*$G*$A}]
set start [nodeDisp 2 3]
set peak 0.01
timeSeries Path 3 -dt 1.0 -values [list $start $peak 0.0 $peak] -useLast
pattern Plain 3 3 { sp 2 3 1.0 }
integrator LoadControl 0.02
set largest {}
foreach pull {1 2 3} {
    set most 0.0
    for {set i 1} {$i <= 50} {incr i} {
        if {[analyze 1] != 0} { error "no equilibrium in tension" }
        # At a millimetre: beyond cavitation, far from the largest displacement
        if {[nodeDisp 2 3] < 0.001} { set most [lindex [eleResponse 1 basicForce] 0] }
    }
    lappend largest $most
}
puts [format "cavitation force %.0f kN; at 1 mm the first pull takes %.0f kN, the second %.0f kN" \
    [expr {1e-3*$cavitation}] [expr {1e-3*[lindex $largest 0]}] [expr {1e-3*[lindex $largest 2]}]]
