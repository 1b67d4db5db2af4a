# A round high damping rubber bearing of one of the compounds of the KikuchiAikenHDR material: X0.6, X0.6-0MPa, X0.4, X0.4-0MPa, X0.3,
# X0.3-0MPa. Units: N, m, s (the compounds' own).
#
#     kikuchi_aiken_hdr $tag $iNode $jNode <compound <diameter <thickness <layer <height>>>>>
#                                                     materials take the tags 10*tag+1 and 10*tag+2
#
# Compounds: M. Kikuchi and I. D. Aiken, An analytical hysteresis model for elastomeric seismic isolation bearings, Earthquake Engineering and
# Structural Dynamics 26 (1997), with the coefficients of OpenSees. The axial springs follow models/rubber.tcl; sizes are those of an ordinary
# building bearing: 800 mm, 32 layers of 6 mm.

source [file join [file dirname [info script]] rubber.tcl]

proc kikuchi_aiken_hdr {tag iNode jNode {compound X0.6} {diameter 0.8} {thickness 0.192} {layer 0.006} {height 0.3}} {
    # Shear modulus in small strains in MPa is in the name.
    set shear [expr {[string range $compound 1 3]*1e6}]
    set bulk 2000.0e6
    set spring [expr {10*$tag + 1}]
    set axial [expr {10*$tag + 2}]
    set area [expr {acos(-1.0)*$diameter**2/4.0}]
    uniaxialMaterial KikuchiAikenHDR $spring $compound $area $thickness
    uniaxialMaterial AxialSp $axial [rubber::modulus $diameter $layer $shear $bulk] [expr {2.0*$shear}] -100.0e6 1.0 0.01 0.5 0.0
    element KikuchiBearing $tag $iNode $jNode -shape round -size $diameter $thickness -totalHeight $height \
        -nMSS 8 -matMSS $spring -limDisp [expr {0.01*$thickness}] -nMNS 30 -matMNS $axial \
        -lambda [rubber::lambda $diameter $layer $shear $bulk] -orient 0 0 1 1 0 0
}
