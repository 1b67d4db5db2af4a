# lead rubber bearing with a loading beam, series curlew
# prototype test, lead rubber bearing dia. 0.70 m  (N, m, Pa)
wipe
model basic -ndm 2 -ndf 3
set Gr   383248.8      ;# shear modulus of the rubber
set tauL 7601991    ;# yield stress of the lead

# ---- geometry
set Ar 0.385
set Hr 0.14
set Ap 0.0177
node 1 0.00 0.00
node 2 0.00 0.32
node 3 0.60 0.32
fix 1 1 1 1
fix 2 0 1 1
fix 3 0 1 1

# ---- bearing; loading beam between bearing and actuator
uniaxialMaterial KikuchiAikenLRB 10 1 $Ar $Hr $Gr $Ap $tauL 0.588e6 13.0 -T $T
uniaxialMaterial Elastic 12 4.0e8
element twoNodeLink 1 1 2 -mat 10 -dir 2
element truss 2 2 3 1.0 12

timeSeries Path 5 -dt $dt -filePath $motion
pattern MultipleSupport 5 {
    groundMotion 5 Plain -disp 5
    imposedMotion 3 1 5
}
recorder Node -file bearing.txt -time -node 2 -dof 1 disp
recorder Element -file shear.txt -time -ele 1 localForce

constraints Transformation
numberer Plain
system FullGeneral
test NormDispIncr 1.0e-9 100
algorithm Newton
integrator LoadControl $dt
analysis Static
set n [expr int($npts) - 1]
while {$n > 0} {
    if {[analyze 1] != 0} {error "step [getTime] s did not converge"}
    incr n -1
}
