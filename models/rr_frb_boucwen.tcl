# RR-FRB as a Bouc-Wen bearing, Table 6 of the paper that rr_frb.tcl cites. Units: N, m, s.
#
#     rr_frb_boucwen $tag $iNode $jNode <$up <$x>>     materials take the tags 10*tag+1 and 10*tag+2
#
# Table 6 gives the yield force F_y, and the element takes the characteristic strength q_d = (1 - alpha_1 - alpha_2 (F_y/K)^(mu-1)) F_y,
# as older versions of OpenSees worked it out themselves; alpha_2 belongs to lengths in mm. Directions without a law of their own get stiffnesses
# of a hundred times the lateral one.

source [file join [file dirname [info script]] rr_frb.tcl]

proc rr_frb_boucwen {tag iNode jNode {up {0 0 1}} {x {1 0 0}}} {
    namespace upvar rr_frb shear shear area area thickness thickness
    set fy 11000.0
    lassign {0.28 -0.0003 2.40 0.75 -0.25 3.0} alpha1 alpha2 mu beta gamma eta
    set k [expr {$shear*$area/$thickness}]
    # F = alpha_2 K |u|^mu with u in mm and K in N/mm: in N and m the factor is 1000^(mu - 1) times as large.
    set alpha2 [expr {$alpha2*1000.0**($mu - 1.0)}]
    set qd [expr {(1.0 - $alpha1 - $alpha2*($fy/$k)**($mu - 1.0))*$fy}]
    set axial [expr {10*$tag + 1}]
    set stiff [expr {10*$tag + 2}]
    rr_frb::axial $axial $area [expr {$area/$thickness}]
    uniaxialMaterial Elastic $stiff [expr {100.0*$k}]
    element elastomericBearingBoucWen $tag $iNode $jNode $k $qd $alpha1 $alpha2 $mu $eta $beta $gamma \
        -P $axial -T $stiff -My $stiff -Mz $stiff -orient {*}$up {*}$x
}
