# RR-FRB with every phenomenon of Table 4 of the paper that rr_frb.tcl cites, which none of its three models has. Units: N, m, s.
#
#     rr_frb_rheology $tag $iNode $jNode <$up <$x>>
#
# The shear is a rheology of high damping rubber [2] with softening of virgin rubber, coupled in the plane. The axial law
# is that of Kumar, Whittaker and Constantinou (2014): cavitation with damage, buckling, and an axial stiffness that falls with the shear
# displacement. `amend axial` takes lateral stiffness away under the axial load (Koh and Kelly, 1987).
#
# The ten numbers of the rubber are no fit to the tests, which are not public: they were chosen so that secant stiffness falls with
# the amplitude about as [1] tells. The critical load is that of Koh and Kelly for the same modulus and layers.
#
# [2] D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at room and low temperatures,
#     dissertation.

source [file join [file dirname [info script]] rr_frb.tcl]

proc rr_frb_rheology {tag iNode jNode {up {0 0 1}} {x {1 0 0}}} {
    namespace upvar rr_frb shear shear bulk bulk size size height height fibre fibre layer layer layers layers area area modulus modulus
    # C1eq C2eq C3eq tauCrEq m, C1oe C2oe tauCrOe a n: Pa and 1/s.
    set rubber {7.4e6 1.75e6 0.025e6 0.15e6 3.0 10.0e6 0.37e6 0.15e6 0.62e6 0.25}
    element HDRRheologyBearing $tag $iNode $jNode $shear $bulk 0.0 $size $fibre $layer $layers {*}$rubber -mullins 0.6 0.2 -orient {*}$up {*}$x
    # Haringx's column: P = (sqrt(S^2 + 4 S E) - S)/2, with the shear rigidity S and the Euler load E of the layered rubber.
    set steps [expr {$height/($layers*$layer)}]
    set rigidity [expr {$shear*$area*$steps}]
    set euler [expr {acos(-1.0)**2*$modulus/3.0*$size**4/12.0*$steps/$height**2}]
    set critical [expr {(sqrt($rigidity**2 + 4.0*$rigidity*$euler) - $rigidity)/2.0}]
    amend element $tag axial -critical $critical -width $size -dir 2 3
}
