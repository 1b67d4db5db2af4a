# Backbones, concretes, steel and an oil damper: springs to and fro, fibers, sections of isolators, a damper that is shaken, and
# cables.
model basic -ndm 1 -ndf 1
uniaxialMaterial HystereticSM 1 -posEnv 1.5 0.01 2. 0.03 1.8 0.06 0.5 0.1 -negEnv -1. -0.01 -1.4 -0.04 -0.3 -0.1 -pinch 0.7 0.4 -damage 0.02 0.01 -beta 0.3
uniaxialMaterial HystereticSM 2 -posEnv 1.5 0.01 2. 0.03 1.8 0.05 1.7 0.07 0.5 0.1 -damage 0.05 0.05
uniaxialMaterial Steel4 3 2. 200. -asym -kin 0.02 20. 0.9 0.15 0.01 25. 0.9 0.15 -iso 0.01 1. 0.001 20. 2. 0.02 1. 0.001 20. -ult 3. 5. 3.5 5. -init 0.4
uniaxialMaterial FRPConfinedConcrete02 4 -30. 2000. -0.02 -JacketC 0.4 1e4 0.12 150. 3. 200. 1
uniaxialMaterial ECC01 5 3. 0.002 4. 0.05 0.2 -40. -0.03 -0.15 3. 4. 2. 1.5 0.4 0.3
uniaxialMaterial Concrete01WithSITC 6 -30. -0.02 -6. -0.06 0.02
uniaxialMaterial CastFuse 7 8 0.5 1.5 50. 2900. 12. 0.05 20. 0.92 0.15 0.02 1. 0.03 1.
uniaxialMaterial Steel03 31 2. 200. 0.02 20. 0.9 0.15 0.1 5. 0.2 6.
uniaxialMaterial BarSlip 32 3e7 4.2e8 2e11 6.2e8 4e9 0.02 0.4 4 0.4 0.4 strong beamTop Damage1 Pa
hystereticBackbone Raynor 1 200. 2. 3. 0.02 0.12 3. 1.
hystereticBackbone ReeseSand 2 400. 0.03 2. 0.12 3.
hystereticBackbone ReeseStiffClayBelowWS 3 400. 0.01 0.6 4.
hystereticBackbone Mander 4 3. 0.05 100.
hystereticBackbone LinearCapped 5 1 0.06 -20. 0.5
foreach i {1 2 3 4 5} { uniaxialMaterial Backbone [expr $i + 20] $i 1.5 }
set path {0}
set at 0.
foreach goal {-0.02 0.01 -0.035 0.03 -0.015 0.06 0.02 -0.06 -0.045 0.05 0.02 0.05 -0.08 -0.03 0.09 -0.1 0.12 0.} {
    for {set i 1} {$i <= 8} {incr i} { lappend path [expr {$at + ($goal - $at) * $i / 8.}] }
    set at $goal
}
timeSeries Path 1 -dt 1 -values $path
node 1 0.; fix 1 1
# so that something is free
node 9 0.; uniaxialMaterial Elastic 9 1.; element zeroLength 9 1 9 -mat 9 -dir 1
foreach i {1 2 3 4 5 6 7 21 22 23 24 25 31 32} {
    node 1$i 0.
    element zeroLength $i 1 1$i -mat $i -dir 1
    pattern Plain $i 1 "sp 1$i 1 1.0"
    recorder Element -file spring$i.out -time -ele $i material 1 stress
}
constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 20; algorithm Newton
integrator LoadControl 1; analysis Static
analyze 144
wipe
model basic -ndm 1 -ndf 1
node 1 0.; fix 1 1
node 2 0. -mass 1.; node 3 0. -mass 2.
uniaxialMaterial Elastic 1 150.
uniaxialMaterial BilinearOilDamper 2 200. 5. 4. 0.1
uniaxialMaterial BilinearOilDamper 3 300. 8. 6. 0.2 0. 2 1e-5 1e-8 12
element zeroLength 1 1 2 -mat 1 2 -dir 1 1
element zeroLength 2 2 3 -mat 1 3 -dir 1 1
timeSeries Trig 1 0.0 10.0 0.6 -factor 4.
pattern UniformExcitation 1 1 -accel 1
constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-13 200; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient
recorder Node -file shaken.out -time -node 2 3 -dof 1 disp
recorder Element -file damper.out -time -ele 1 2 material 2 stress
analyze 300 0.01
wipe
model basic -ndm 2 -ndf 3
uniaxialMaterial Concrete01WithSITC 1 -30. -0.02 -6. -0.06 0.02
section Bidirectional 1 143. 3.2 2. 16. Vy P
section Isolator2spring 2 1e-10 16. 3.5 2. 930. 11. 1200. 10.
section Fiber 3 { fiber 0. 0. 1. 1 }
section Elliptical 4 143. 90. 3.2 2.5 0.3 16. 9. Vy P
set across {0}
foreach x $path { lappend across [expr {20. * $x}] }
set along {0}
for {set i 0} {$i < 145} {incr i} { lappend along [expr {-0.02 - 0.0003 * $i}] }
timeSeries Path 1 -dt 1 -values $across
timeSeries Path 2 -dt 1 -values $along
timeSeries Path 3 -dt 1 -values $path
node 1 0. 0.; fix 1 1 1 1
node 9 0. 0.; fix 9 0 1 1; uniaxialMaterial Elastic 9 1.; element zeroLength 9 1 9 -mat 9 -dir 1
foreach i {1 2 3 4} {
    node 1$i 0. 0.; fix 1$i 0 [expr {$i == 3}] 1
    element zeroLengthSection $i 1 1$i $i
    recorder Element -file section$i.out -time -ele $i section force
}
pattern Plain 1 3 { sp 11 1 1.0; sp 13 1 1.0; sp 14 1 1.0 }
pattern Plain 2 1 { sp 12 1 1.0 }
pattern Plain 3 2 { sp 11 2 1.0; sp 12 2 1.0; sp 14 2 1.0 }
constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 50; algorithm Newton
integrator LoadControl 1; analysis Static
analyze 140
wipe
model basic -ndm 3 -ndf 3
node 1 0. 0. 90.; node 2 15. 0. 40.; node 3 30. 60. 30.
fix 1 1 1 1; fix 3 1 1 1
mass 2 1. 1. 1.
element CatenaryCable 1 1 2 -0.2 3e4 1. 50. 6.5e-6 100. 0.02 1e-10 5 0
element CatenaryCable 2 2 3 -0.2 3e4 1. 50. 6.5e-6 100. 0.02 1e-10 1 3
timeSeries Linear 1
pattern Plain 1 1 { load 2 3. 4. -2. }
constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-11 50; algorithm Newton
integrator LoadControl 0.1; analysis Static
recorder Node -file cables.out -time -node 2 -dof 1 2 3 disp
recorder Element -file cable_forces.out -time -ele 1 2 force
analyze 10
pattern Plain 2 1 { eleLoad -ele 1 2 -type -beamUniform 0. 0.1 -0.4 }
analyze 10
wipe
# Concretes and bars at strains of their own, then springs of columns that fail at a limit curve.
model basic -ndm 1 -ndf 1
uniaxialMaterial Concrete07 41 -30. -0.002 25000. 3. 0.0002 2. 2.3 4.
uniaxialMaterial Concrete07 42 -30. -0.002 25000. 3. 0.0002 2. 30. 4.
uniaxialMaterial ConfinedConcrete01 43 S4b 30. 26000. -epscu 0.02 -varub 300. 200. 10. 100. 400. 206000. 0.005 100. 16. -internal 8. 100. 400. 206000. 0. 100. -wrap 30. 0.2 1. 3000. 2e5 -stRatio 0.85
uniaxialMaterial ConfinedConcrete01 44 C 30. 26000. -scott -nu 0.2 300. 10. 100. 300. 206000. 0. 1000. 16. -gravel
uniaxialMaterial ASDConcrete1D 45 30000. -fc 30.
uniaxialMaterial ASDConcrete1D 46 30000. -Te 0. 0.0001 0.001 -Ts 0. 3. 0.1 -Td 0. 0. 0.9 -Ce 0. 0.0005 0.002 0.01 -Cs 0. 15. 30. 3. -Cd 0. 0. 0.2 0.9
uniaxialMaterial Dodd_Restrepo 47 400. 600. 0.01 0.12 2e5 0.04 520.
uniaxialMaterial SteelDRC 48 2e5 400. 0.12 600. 0.01
uniaxialMaterial SteelDRC 49 2e5 400. 0.12 600. 0.01 -shPoint 0.04 520. -bausch 0 -omegaFactor 0.8
uniaxialMaterial SteelDRC 50 2e5 400. 0.12 600. 0.01 -bausch 2 -fractStrain 0.2
uniaxialMaterial Masonry 51 -5. 0.2 -0.002 -0.01 0.001 5000. 2. 0.3 0.2 -0.003 -0.008 0.3 0.4 1.5 0.7 1.5 0.6 1.1 1.5 1. 1
uniaxialMaterial Masonry 52 -5. 0. -0.002 -0.01 0.001 5000. 2. 0.3 0.3 0. 0. 0.3 0.4 1.5 0.7 1.5 0.6 1.1 1.5 1. 2
timeSeries Path 1 -dt 1 -values $path
node 1 0.; fix 1 1
node 9 0.; uniaxialMaterial Elastic 9 1.; element zeroLength 9 1 9 -mat 9 -dir 1
foreach {i share} {41 0.06 42 0.02 43 0.1 44 0.1 45 0.03 46 0.03 47 0.3 48 0.3 49 0.08 50 0.4 51 0.08 52 0.1} {
    node 1$i 0.
    element zeroLength $i 1 1$i -mat $i -dir 1
    pattern Plain $i 1 "sp 1$i 1 $share"
    recorder Element -file spring$i.out -time -ele $i material 1 stress
}
constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-12 20; algorithm Newton
integrator LoadControl 1; analysis Static
analyze 144
wipe
# kip and in.
set n 0
foreach curve {
    {Shear 1 1 0.0018 3517. 9. 9. 7.75 11.87 2470. 3. 2 0 1 4 1 2 0.}
    {Shear 1 1 0.0018 3517. 9. 9. 7.75 11.87 -20. 3. 2 1 1 4 1 2 -0.01}
    {ThreePoint 1 1 0. 22. 0.01 18. 0.02 12. -8. 2. 2 1 1 4 1 2}
    {ThreePoint 1 1 0. 22. 0.001 18. 0.002 12. -8. 2. 1 1}
    {RotationShearCurve 1 1 1 3 3 15. -0.4 -10. 0.0275}
    {RotationShearCurve 1 1 1 3 3 -1 -1 0 1 9. 7.75 9. 58. 6. 2. 49. 20. 0.5 0.0018 3.517 60. 60. -0.0289}
} {
    incr n
    model basic -ndm 2 -ndf 3
    node 1 0. 0.; node 2 0. 0.; node 3 0. 58.; node 4 0. 58.
    fix 1 1 1 1; fix 4 0 0 1
    equalDOF 3 4 2 3
    geomTransf Linear 1
    uniaxialMaterial Elastic 12 1e6
    element elasticBeamColumn 1 2 3 81. 3000. 50000. 1
    element zeroLength 3 1 2 -mat 12 12 12 -dir 1 2 6
    eval limitCurve $curve
    uniaxialMaterial LimitState 5 25. 0.0125 30. 0.015 45. 0.0225 -25. -0.0125 -30. -0.015 -45. -0.0225 0.4 0.3 0.01 0.02 0. 1 2 [expr {$n % 2}]
    element zeroLength 2 3 4 -mat 5 12 12 -dir 1 2 6
    timeSeries Constant 2
    pattern Plain 2 2 { load 3 0. -60. 0. }
    timeSeries Path 5 -dt 1 -values $path
    pattern Plain 5 5 { sp 4 1 20. }
    recorder Element -file column$n.out -time -ele 2 force
    constraints Transformation; numberer Plain; system BandGeneral; test NormDispIncr 1e-10 60; algorithm Newton
    integrator LoadControl 1; analysis Static
    for {set i 0} {$i < 144} {incr i} {
        if {[analyze 1] != 0} {
            algorithm ModifiedNewton -initial; test NormDispIncr 1e-10 3000
            analyze 1
            algorithm Newton; test NormDispIncr 1e-10 60
        }
    }
    wipe
}
# A pounding mass with Coulomb friction.
model basic -ndm 1 -ndf 1
node 1 0.; fix 1 1
node 2 0. -mass 1.; node 3 0. -mass 2.
uniaxialMaterial CoulombDamper 2 40. 1.5 -tol 0.2
uniaxialMaterial ViscoelasticGap 3 800. 1. -0.02
uniaxialMaterial Elastic 4 60.
element zeroLength 1 1 2 -mat 2 -dir 1
element zeroLength 2 2 3 -mat 3 4 -dir 1 1
timeSeries Trig 1 0.0 10.0 0.6 -factor 4.
pattern UniformExcitation 1 1 -accel 1
constraints Plain; numberer Plain; system BandGeneral; test NormDispIncr 1e-13 200; algorithm Newton
integrator Newmark 0.5 0.25; analysis Transient
recorder Node -file pounding.out -time -node 2 3 -dof 1 disp
analyze 600 0.005
wipe
wipe
# Beams of fibers of continua, in the plane and in space.
foreach {n ndm ndf kind} {1 2 3 dispBeamColumn 2 2 3 forceBeamColumn 3 3 6 forceBeamColumn 4 3 6 dispBeamColumn} {
    model basic -ndm $ndm -ndf $ndf
    nDMaterial J2Plasticity 1 1.6e5 8e4 300. 380. 20. 500.
    nDMaterial ElasticIsotropic 2 30000. 0.2
    if {$ndm == 2} {
        node 1 0. 0.; node 2 1500. 100.; fix 1 1 1 1
        geomTransf Linear 1
        section NDFiber 1 -alpha 0.8 { patch rect 1 8 1 -100. -50. 100. 50.; layer straight 2 3 200. -80. -40. -80. 40.; fiber 90. 0. 400. 2 }
    } else {
        node 1 0. 0. 0.; node 2 1500. 100. 50.; fix 1 1 1 1 1 1 1
        geomTransf Linear 1 0. 0. 1.
        section NDFiber 1 { patch rect 1 6 3 -100. -50. 100. 50.; layer straight 2 3 200. -80. -40. -80. 40.; fiber 90. 0. 400. 2 }
    }
    element $kind 1 1 2 4 1 1
    timeSeries Path 1 -dt 1 -values {0 1 -1 1.5 -1.5 0.5}
    if {$ndm == 2} { pattern Plain 1 1 { load 2 -1e5 1.1e5 1e7 } } else { pattern Plain 1 1 { load 2 -1e5 8e4 2.5e4 5e6 -1e6 2e6 } }
    constraints Plain; numberer Plain; system FullGeneral; test NormDispIncr 1e-9 50; algorithm Newton
    integrator LoadControl 0.05; analysis Static
    recorder Node -file beam$n.out -time -node 2 -dof 1 2 3 disp
    recorder Element -file beam_section$n.out -time -ele 1 section 1 force
    analyze 100
    wipe
}
