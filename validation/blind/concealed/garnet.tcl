# pad 19, acceptance test
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3
set kInit 1942087
set Qd 28853.4
set alpha 0.1134691

if {![info exists axial]} {set axial 195428.6}
node 1 0.0 0.0
node 2 0.0 0.2
fix 1 1 1 1
fix 2 0 0 1
mass 2 50 50 50

uniaxialMaterial Elastic 1 4.407339e+08
uniaxialMaterial Elastic 2 4407339
frictionModel Coulomb 1 0.1476417
element flatSliderBearing 1 1 2 1 1721720 -P 1 -Mz 2 -orient 0 1 0 -1 0 0 -iter 50 1.0e-10
node 5 0.0 0.2
fix 5 1 1 1
uniaxialMaterial Elastic 5 220367
element zeroLength 5 5 2 -mat 5 -dir 1

# vertical load first
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-09 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

# overturning and vertical shaking
timeSeries Path 3 -dt $dt -filePath $vertical
pattern Plain 3 3 {
    load 2 0.0 -1.0 0.0
}

# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 5 force

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1e-09 60
algorithm Newton
integrator Newmark 0.6 0.3025
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1 $dt]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1 $dt]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
