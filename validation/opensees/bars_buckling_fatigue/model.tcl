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

# Concrete and devices under cycles that grow, with inner loops, from the same bars. N, mm; strain times 0.1.
model basic -ndm 1 -ndf 1
set laws {
    {ConcreteCM @ -30 -0.002 25000 7 1.035 3 0.0002 1.2 1e4}
    {ConcreteCM @ -45 -0.0025 30000 9 1.9 3 0.0002 2.5 30 -GapClose 1}
    {Concrete02IS @ 25000 -30 -0.002 -6 -0.005 0.2 3 2000}
    {Concrete06 @ -30 -0.002 2.0 1.1 0.32 3 0.0002 0.4 0.08}
    {ConcreteD @ -30 -0.002 3 0.00015 25000 1.5 2.0 0.25 1.15}
    {ConcretewBeta @ -30 -0.002 -15 -0.006 -3 -0.012 3 1.5 0.0005 0.3 0.001 -lambda 0.4 -alpha 0.8 -E 25000 -conf -36 -0.003}
    {ConcretewBeta @ -30 -0.002 -15 -0.006 -3 -0.012 3 1.5 0.0005 0.3 0.001 -M 0.1}
    {GNG @ 20000 20 0.0007 0.02}
    {ASD_SMA_3K @ 20000 400 6000 20 0.6}
    {ElasticPowerFunc @ -coeff 2000 3e6 -exp 1 3}
    {Multiplier @ 1 0.7}
}
node 1 0
fix 1 1
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
recorder Element -file concretes.out -time -ele {*}$bars axialForce
timeSeries Path 1 -dt 1 -factor 0.1 -values {0 -0.01 0.002 -0.015 -0.008 -0.012 0 0.004 -0.002 0.003 -0.02 -0.022 -0.005 -0.014 -0.008 -0.012 0.02 0.006 0.015 0.001 0.012 -0.03 -0.025 -0.032 0.03 0.024 0.028 -0.045 -0.01 -0.06 0.01 -0.02 0.0 -0.06 0.05 0.0}
pattern Plain 1 1 { foreach b $bars { sp [expr {10 + $b}] 1 1.0 } }
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-10 50
algorithm Newton
integrator LoadControl 0.1
analysis Static
analyze 350
wipe
