# Smooth hysteresis of exponential and algebraic type, pinched hysteresis, a shape-memory alloy and ratchets: springs to and fro, and two of
# them under a mass that is shaken.
model basic -ndm 1 -ndf 1
uniaxialMaterial HystereticSmooth 1 200. 10. 2. 0.
uniaxialMaterial HystereticSmooth 2 200. 10. 47.5 12. -alpha
uniaxialMaterial HystereticAsym 3 200. 10. 2. 9. 4. 1.5
uniaxialMaterial HystereticPoly 4 200. 10. 20. 50. 200.
uniaxialMaterial HystereticPoly 5 200. 10. 3. 0. 0. 1e-6
uniaxialMaterial BWBN 21 0.1 200. 1.7 8. 15. 1. 0.2 0.8 0.4 0.3 0.05 0.4 1e-10 500
# (With a strain at the start: at exactly 0 OpenSees keeps the stress of the last trial.)
uniaxialMaterial SMA 20 200. 0.06 2. 2.6 1.5 0.8; uniaxialMaterial InitStrainMaterial 22 20 0.001
uniaxialMaterial Ratchet 23 200. 0.03 0.01 1
uniaxialMaterial Ratchet 24 200. 0.03 0.01 2
timeSeries Path 1 -dt 1 -values {0 0.00166667 0.00333333 0.005 0.00666667 0.00833333 0.01 0.0116667 0.0133333 0.015 0.0166667 0.0183333 0.02 0.0166667 0.0133333 0.01 0.00666667 0.00333333 0 -0.00333333 -0.00666667 -0.01 -0.0133333 -0.0166667 -0.02 -0.0141667 -0.00833333 -0.0025 0.00333333 0.00916667 0.015 0.0208333 0.0266667 0.0325 0.0383333 0.0441667 0.05 0.0416667 0.0333333 0.025 0.0166667 0.00833333 -6.93889e-18 -0.00833333 -0.0166667 -0.025 -0.0333333 -0.0416667 -0.05 -0.0375 -0.025 -0.0125 -6.93889e-18 0.0125 0.025 0.0375 0.05 0.0625 0.075 0.0875 0.1 0.0833333 0.0666667 0.05 0.0333333 0.0166667 -1.38778e-17 -0.0166667 -0.0333333 -0.05 -0.0666667 -0.0833333 -0.1 -0.0791667 -0.0583333 -0.0375 -0.0166667 0.00416667 0.025 0.0458333 0.0666667 0.0875 0.108333 0.129167 0.15 0.141667 0.133333 0.125 0.116667 0.108333 0.1 0.0916667 0.0833333 0.075 0.0666667 0.0583333 0.05 0.0541667 0.0583333 0.0625 0.0666667 0.0708333 0.075 0.0791667 0.0833333 0.0875 0.0916667 0.0958333 0.1 0.0791667 0.0583333 0.0375 0.0166667 -0.00416667 -0.025 -0.0458333 -0.0666667 -0.0875 -0.108333 -0.129167 -0.15 -0.141667 -0.133333 -0.125 -0.116667 -0.108333 -0.1 -0.0916667 -0.0833333 -0.075 -0.0666667 -0.0583333 -0.05 -0.0541667 -0.0583333 -0.0625 -0.0666667 -0.0708333 -0.075 -0.0791667 -0.0833333 -0.0875 -0.0916667 -0.0958333 -0.1 -0.075 -0.05 -0.025 1.38778e-17 0.025 0.05 0.075 0.1 0.125 0.15 0.175 0.2 0.166667 0.133333 0.1 0.0666667 0.0333333 0 -0.0333333 -0.0666667 -0.1 -0.133333 -0.166667 -0.2 -0.183333 -0.166667 -0.15 -0.133333 -0.116667 -0.1 -0.0833333 -0.0666667 -0.05 -0.0333333 -0.0166667 0}
node 1 0.; fix 1 1
# so that something is free
node 9 0.; uniaxialMaterial Elastic 9 1.; element zeroLength 9 1 9 -mat 9 -dir 1
foreach i {1 2 3 4 5 21 22 23 24} {
    node 1$i 0.
    element zeroLength $i 1 1$i -mat $i -dir 1
    pattern Plain $i 1 "sp 1$i 1 1.0"
    recorder Element -file spring$i.out -time -ele $i material 1 stressStrain
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-12 20
algorithm Newton
integrator LoadControl 1
analysis Static
analyze 180
remove recorders
loadConst -time 0.0
wipeAnalysis
mass 9 1.; node 2 0. -mass 1.; node 3 0. -mass 2.
element zeroLength 6 1 2 -mat 3 -dir 1
element zeroLength 7 2 3 -mat 4 -dir 1
recorder Node -file disp.out -time -node 2 3 -dof 1 disp
recorder Element -file force.out -time -ele 6 7 force
timeSeries Trig 2 0.0 10.0 0.8 -factor 4.
pattern UniformExcitation 9 1 -accel 2
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-12 20
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
analyze 500 0.01
