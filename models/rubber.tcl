# Formulas of rubber bearings that several devices share. Any consistent units.
#
# [1] Identification and Calibration of Advanced Hysteresis Models for Recycled Rubber-Fiber-Reinforced Bearings (the paper on
#     RR-FRB; Eqs 2 to 6).
# [2] Cardone et al., reference 18 of [1], for Eqs 4 to 6.

namespace eval rubber {
    # Modified Bessel function of the first kind of order 0 or 1, by its power series.
    proc bessel {order x} {
        set term [expr {$order == 0 ? 1.0 : 0.5*$x}]
        set sum $term
        for {set k 1} {$term > 1e-17*$sum} {incr k} {
            set term [expr {$term*0.25*$x*$x/($k*($k + $order))}]
            set sum [expr {$sum + $term}]
        }
        return $sum
    }

    # Dimensionless parameter of the shape of a layer, D/t_r sqrt(3 G_r/K_bulk) (Eq 3): also -lambda of KikuchiBearing.
    proc lambda {diameter layer shear bulk} {
        expr {double($diameter)/$layer*sqrt(3.0*$shear/$bulk)}
    }

    # Modulus of a layer in compression, E_init = K_bulk (1 - 2 I_1(lambda)/(lambda I_0(lambda))) (Eq 2).
    proc modulus {diameter layer shear bulk} {
        set l [lambda $diameter $layer $shear $bulk]
        expr {$bulk*(1.0 - 2.0*[bessel 1 $l]/($l*[bessel 0 $l]))}
    }

    # Parameters a1 a2 a3 b1 b2 b3 c1 c2 c3 c4 of the HDR element from those of the rubber (Eqs 4 to 6). alpha_1 to alpha_3, beta_1
    # and beta_2 are stresses; beta_3 and chi_1 to chi_4 have no unit. Eq 5 prints beta_2 in b3, where beta_3 is meant.
    proc grant {alpha beta chi area thickness} {
        lassign $alpha a1 a2 a3
        lassign $beta b1 b2 b3
        lassign $chi c1 c2 c3 c4
        set t [expr {double($thickness)}]
        list [expr {$a1*$area/$t}] [expr {$a2*$area/$t**3}] [expr {$a3*$area/$t**5}] \
            [expr {$b1*$area}] [expr {$b2*$area/$t**2}] [expr {$b3/$t}] \
            [expr {$c1/$t**3}] [expr {$c2/$t**3}] $c3 [expr {$c4/$t**3}]
    }
}
