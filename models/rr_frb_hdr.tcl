# RR-FRB as an HDR bearing, Table 7 of the paper that rr_frb.tcl cites, by its Eqs 4 to 6. Units: N, m, s.
#
#     rr_frb_hdr $tag $iNode $jNode <$up <$x <$chi <$alpha <$beta>>>>>
#
# chi_3 = 1.836 is beyond 1, so scragging stiffens: it is taken as printed. With chi_1, chi_2 and chi_4 as printed there is next to no scragging
# at the strains of the tests: chi_1 gamma^3 is 0.003 at a strain of 60 %.

source [file join [file dirname [info script]] rr_frb.tcl]

proc rr_frb_hdr {tag iNode jNode {up {0 0 1}} {x {1 0 0}} {chi {0.012 0.086 1.836 0.00025}} {alpha {0.32 -0.01 0.003}}
                 {beta {0.188 0.187 5.77}}} {
    namespace upvar rr_frb shear shear bulk bulk size size fibre fibre layer layer layers layers thickness thickness
    # alpha and beta are in MPa, but for beta_3.
    set mega {{v} {lmap x $v {expr {1e6*$x}}}}
    set alpha [apply $mega $alpha]
    set beta [concat [apply $mega [lrange $beta 0 1]] [lindex $beta 2]]
    # The element has a round section of this diameter.
    set area [expr {acos(-1.0)*$size**2/4.0}]
    element HDR $tag $iNode $jNode $shear $bulk 0.0 $size $fibre $layer $layers \
        {*}[rubber::grant $alpha $beta $chi $area $thickness] {*}$up {*}$x
}
