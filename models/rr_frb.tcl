# The recycled rubber bearing with fibre reinforcement (RR-FRB), 210 x 210 x 210 mm, of the tests of Calabrese et al. as identified in
# [1]: Tables 5 to 8. Units: N, m, s.
#
# [1] A. Flora, A. Calabrese and D. Cardone, Identification and Calibration of Advanced Hysteresis Models for Recycled
#     Rubber-Fiber-Reinforced Bearings, Buildings 13(1), 65, 2023, doi:10.3390/buildings13010065.
#
# The tables taken literally do not reproduce the errors that [1] gives in its Table 10: they are a start, not a fit.

source [file join [file dirname [info script]] rubber.tcl]

namespace eval rr_frb {
    # Table 5.
    variable shear 1.1e6        ;# G_r
    variable bulk 2000.0e6      ;# K_bulk
    variable size 0.210         ;# D, a side of the square
    variable height 0.210       ;# H
    variable fibre 0.1e-3       ;# t_s
    variable layer 5.0e-3       ;# t_r
    variable layers 40          ;# n
    variable thickness 0.200    ;# T_r = n t_r
    variable area [expr {$size**2}]

    # Modulus in compression (Eqs 2 and 3), cavitation at 2 G_r, yielding at 100 MPa.
    variable modulus [rubber::modulus $size $layer $shear $bulk]
    variable cavitation [expr {2.0*$shear}]
    variable crushing 100.0e6

    # Largest shear strain of the tests that the models are identified by.
    variable calibrated 0.60

    # Refuse a state in which a bearing between a lower and an upper node is sheared beyond the tests.
    proc within_tests {pairs} {
        variable calibrated; variable thickness
        foreach {tag lower upper} $pairs {
            set squares 0.0
            foreach a [lrange [nodeDisp $lower] 0 1] b [lrange [nodeDisp $upper] 0 1] {
                set squares [expr {$squares + ($b - $a)**2}]
            }
            set strain [expr {sqrt($squares)/$thickness}]
            if {$strain > $calibrated} {
                error [format "bearing %d has a shear strain of %.1f %% at %.2f s: the models are identified up to %.0f %%" \
                    $tag [expr {100.0*$strain}] [getTime] [expr {100.0*$calibrated}]]
            }
        }
    }

    # Axial material of one unit of force: AxialSp with post-elastic stiffness of 1/100 in tension and 1/2 in compression.
    # Stress and strain for factors of 1, force and displacement for the area and for the area over the thickness.
    proc axial {tag {strength 1.0} {stiffness 1.0}} {
        variable modulus; variable cavitation; variable crushing
        uniaxialMaterial AxialSp $tag [expr {$modulus*$stiffness}] [expr {$cavitation*$strength}] \
            [expr {-$crushing*$strength}] 1.0 0.01 0.5 0.0
    }
}
