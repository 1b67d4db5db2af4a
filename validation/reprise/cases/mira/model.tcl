# Steel column with a replaceable foot, top driven sideways
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3

pset Kh 4000000.0   ;# foot: rotational stiffness
pset Mz 50000.0     ;# foot: strength
pset b  0.06        ;# foot: hardening

set h 2.4
if {![info exists axial]} {set axial 100000.0}
node 1 0.0 0.0
node 2 0.0 0.0
node 3 0.0 $h
fix 1 1 1 1

set ty [expr $Mz/((1.0-$b)*$Kh)]
uniaxialMaterial BoucWen 1 $b $Kh 1.0 [expr 0.5/$ty] [expr 0.5/$ty] 1.0 0.0 0.0 0.0
uniaxialMaterial Elastic 2 1.0e11
element zeroLength 1 1 2 -mat 2 2 1 -dir 1 2 6
geomTransf Linear 1
element elasticBeamColumn 2 2 3 5.4e-3 2.0e11 2.5e-5 1

# jack
timeSeries Linear 1
pattern Plain 1 1 {
    load 3 0.0 [expr -$axial] 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-10 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 3 1 1.0
}
recorder Element -file force.out -time -ele 2 globalForce
recorder Node -file disp.out -time -node 3 -dof 1 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-10 60
algorithm Newton
integrator LoadControl $dt
analysis Static
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze 1]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze 1]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
