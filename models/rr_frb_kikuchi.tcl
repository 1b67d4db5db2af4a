# RR-FRB as a Kikuchi bearing, Table 8 of the paper that rr_frb.tcl cites: KikuchiAikenHDR of compound X0.6 with c_g, c_h, c_u, and AxialSp.
# Units: N, m, s (the compound's own).
#
#     rr_frb_kikuchi $tag $iNode $jNode <$up <$x <$coefficients>>>     materials take the tags 10*tag+1 and 10*tag+2

source [file join [file dirname [info script]] rr_frb.tcl]

proc rr_frb_kikuchi {tag iNode jNode {up {0 0 1}} {x {1 0 0}} {coefficients {2.0 0.80 1.12}}} {
    namespace upvar rr_frb shear shear bulk bulk size size height height layer layer thickness thickness area area
    set spring [expr {10*$tag + 1}]
    set axial [expr {10*$tag + 2}]
    uniaxialMaterial KikuchiAikenHDR $spring X0.6 $area $thickness -coGHU {*}$coefficients
    rr_frb::axial $axial
    # Shear springs are scaled for displacements from 1 % of the thickness on.
    element KikuchiBearing $tag $iNode $jNode -shape square -size $size $thickness -totalHeight $height \
        -nMSS 8 -matMSS $spring -limDisp [expr {0.01*$thickness}] -nMNS 30 -matMNS $axial \
        -lambda [rubber::lambda $size $layer $shear $bulk] -orient {*}$up {*}$x
}
