# Reinforcing bars under cycles with partial reversals: Menegotto-Pinto curves with shifts, yield plateau, buckling by two
# models, fatigue. Units: ksi, inch/inch.
model basic -ndm 1 -ndf 1
set laws {
    {SteelMPF @ 60 55 29000 0.02 0.01 20 0.925 0.15}
    {SteelMPF @ 60 55 29000 0.02 0.01 20 0.925 0.15 0.02 1.0 0.03 1.0}
    {ReinforcingSteel @ 60 90 29000 700 0.008 0.1}
    {ReinforcingSteel @ 60 90 29000 700 0.008 0.1 -IsoHard 4.3 0.01}
    {ReinforcingSteel @ 60 90 29000 700 0.008 0.1 -GABuck 6 1 0.4 0.5}
    {ReinforcingSteel @ 60 90 29000 700 0.008 0.1 -DMBuck 6 0.9}
    {ReinforcingSteel @ 60 90 29000 700 0.008 0.1 -CMFatigue 0.12 0.506 0.389 -MPCurveParams 0.333 17 4.2}
}
node 1 0
fix 1 1
# A point of its own keeps the equations from being none.
node 2 1
uniaxialMaterial Elastic 99 1
element truss 99 1 2 1 99
set n 0
set bars {}
foreach law $laws {
    incr n
    node [expr {10 + $n}] 1
    uniaxialMaterial {*}[string map [list @ $n] $law]
    element truss $n 1 [expr {10 + $n}] 1 $n
    lappend bars $n
}
recorder Element -file bars.out -time -ele {*}$bars axialForce
timeSeries Path 1 -dt 1 -values {0 0.004 -0.003 0.006 0.002 0.005 0.001 0.0045 0.003 0.0042 0.0022 0.02 -0.015 0.03 0.01 0.025 0.005 0.02 0.012 0.018 0.014 0.016 0.0145 0.0155 0.015 0.0157 0.0149 0.0152 0.04 -0.04 -0.01 -0.03 -0.015 -0.025 -0.018 -0.022 -0.019 0.05 0.0}
pattern Plain 1 1 { foreach b $bars { sp [expr {10 + $b}] 1 1.0 } }
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 380
wipe
