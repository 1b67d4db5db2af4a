# Triple friction pendulum, configuration A of Kim and Constantinou (2023), Earthquake Engineering and Structural Dynamics,
# doi 10.1002/eqe.3797: geometry, reference friction and yield displacement as in the example of OpenSees'
# TripleFrictionPendulumX. The coefficients of friction at high speed are the reference ones; at rest they are half of
# them, with the rate 100 s/m of the factor k_v = 1 - 0.5 exp(-100 v) (Kumar, Whittaker and Constantinou, 2015).
#
# Units: N, m, s. Needs -ndm 3 -ndf 6, node j above node i along Z.
#
#   triplePendulum $element $i $j $tag $weight
#
# makes element $element under the weight $weight (N), with friction models $tag to $tag+2 and materials $tag, $tag+1.

array set tfp {
    L1 0.3937  L2 3.7465  L3 3.7465
    d1 0.0716  d2 0.5043  d3 0.5043
    mu1 0.01   mu2 0.04   mu3 0.08
    rate 100.0
    uy 0.001   kv 8.0e9   kvt 1.0   minFv 0.1   kr 10.0   tol 1.0e-5
}

proc triplePendulum {element i j tag weight} {
    global tfp
    set frictions {}
    foreach mu [list $tfp(mu1) $tfp(mu2) $tfp(mu3)] {
        set friction [expr {$tag + [llength $frictions]}]
        frictionModel VelDependent $friction [expr {0.5*$mu}] $mu $tfp(rate)
        lappend frictions $friction
    }
    set turning [expr {$tag + 1}]
    uniaxialMaterial Elastic $tag $tfp(kv)
    uniaxialMaterial Elastic $turning $tfp(kr)
    element TripleFrictionPendulum $element $i $j {*}$frictions $tag $turning $turning $turning \
        $tfp(L1) $tfp(L2) $tfp(L3) $tfp(d1) $tfp(d2) $tfp(d3) $weight $tfp(uy) $tfp(kvt) $tfp(minFv) $tfp(tol)
}
