# three storeys, two bays, series fig
wipe
model BasicBuilder -ndm 2 -ndf 3
set rE 1.075075
set xi 0.03745298
for {set f 0} {$f <= 3} {incr f} {
    for {set c 1} {$c <= 3} {incr c} {
        node [expr 10*$f+$c] [expr 5.0*($c-1)] [expr 3.2*$f]
        if {$f > 0} {mass [expr 10*$f+$c] 18.0 18.0 1.0e-6}
    }
}
uniaxialMaterial Elastic 70 6.0e4 150.0
uniaxialMaterial Elastic 71 2.0e6
foreach n {1 2 3} {
    node 90$n [nodeCoord $n 1] [nodeCoord $n 2]
    fix 90$n 1 1 1
    fix $n 1 0 0
    element zeroLength 90$n 90$n $n -mat 71 70 -dir 2 6
}
set E [expr $rE*2.8e7]
geomTransf PDelta 1
geomTransf Linear 2
for {set f 1} {$f <= 3} {incr f} {
    for {set c 1} {$c <= 3} {incr c} {
        element elasticBeamColumn [expr 100*$f+$c] [expr 10*($f-1)+$c] [expr 10*$f+$c] 0.20 $E 0.0030 1
    }
    foreach b {1 2} {
        element elasticBeamColumn [expr 200*$f+1000+$b] [expr 10*$f+$b] [expr 10*$f+$b+1] 0.24 $E 0.0040 2
    }
}
pattern Plain 1 Linear {
    for {set f 1} {$f <= 3} {incr f} {
        foreach c {1 2 3} {load [expr 10*$f+$c] 0.0 -176.6 0.0}
    }
}
constraints Plain
numberer RCM
system ProfileSPD
test NormDispIncr 1e-10 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis
set lambda [eigen -fullGenLapack 2]
set w1 [expr sqrt([lindex $lambda 0])]
set w2 [expr sqrt([lindex $lambda 1])]
rayleigh [expr 2.0*$xi*$w1*$w2/($w1+$w2)] 0.0 [expr 2.0*$xi/($w1+$w2)] 0.0
timeSeries Path 2 -dt $dt -filePath $motion
pattern UniformExcitation 2 1 -accel 2
recorder Node -file acc.out -timeSeries 2 -time -node 12 22 32 -dof 1 accel
recorder Node -file disp.out -time -node 32 -dof 1 disp
constraints Plain
numberer RCM
system BandGeneral
test NormDispIncr 1e-9 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 2 [expr $dt/2.0]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 2 [expr $dt/2.0]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
