# A round bearing of natural rubber with a lead plug. Units: N, m, s (those of the material KikuchiAikenLRB).
#
#     lrb $tag $iNode $jNode <diameter <plug <thickness <layer <height <temperature>>>>>>
#                                                     materials take the tags 10*tag+1 and 10*tag+2
#
# Material: M. Kikuchi and I. D. Aiken, An analytical hysteresis model for elastomeric seismic isolation bearings, Earthquake Engineering and
# Structural Dynamics 26 (1997), as KikuchiAikenLRB of OpenSees: rubber of G = 0.392 MPa, yield stress of lead 8.33 MPa, shear modulus of lead
# 0.588 MPa, initial over post-yield stiffness 13. Sizes are those of an ordinary building bearing: 700 mm, plug of 150 mm, 28 layers of 5 mm.

source [file join [file dirname [info script]] rubber.tcl]

proc lrb {tag iNode jNode {diameter 0.7} {plug 0.15} {thickness 0.14} {layer 0.005} {height 0.25} {temperature 15.0}} {
    set shear 0.392e6
    set bulk 2000.0e6
    set spring [expr {10*$tag + 1}]
    set axial [expr {10*$tag + 2}]
    set lead [expr {acos(-1.0)*$plug**2/4.0}]
    set area [expr {acos(-1.0)*$diameter**2/4.0 - $lead}]
    uniaxialMaterial KikuchiAikenLRB $spring 1 $area $thickness $shear $lead 8.33e6 0.588e6 13.0 -T $temperature
    uniaxialMaterial AxialSp $axial [rubber::modulus $diameter $layer $shear $bulk] [expr {2.0*$shear}] -100.0e6 1.0 0.01 0.5 0.0
    element KikuchiBearing $tag $iNode $jNode -shape round -size $diameter $thickness -totalHeight $height \
        -nMSS 8 -matMSS $spring -limDisp [expr {0.01*$thickness}] -nMNS 30 -matMNS $axial \
        -lambda [rubber::lambda $diameter $layer $shear $bulk] -orient 0 0 1 1 0 0
}
