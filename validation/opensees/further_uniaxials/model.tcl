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
