# Pad 31 in the shear frame
# units: N, m, s
wipe
model basic -ndm 2 -ndf 3

pset kInit 2200000.0
pset Fy    13000.0
pset alpha 0.25

set H 0.15
if {![info exists axial]} {set axial 150000.0}
node 1 0.0 0.0
node 2 0.0 $H
fix 1 1 1 1
fix 2 0 0 1
mass 2 50.0 50.0 1.0

uniaxialMaterial Elastic 1 4.0e8
uniaxialMaterial Elastic 2 1.0e8
element elastomericBearingBoucWen 1 1 2 $kInit $Fy $alpha 0.0 2.0 1.0 0.5 0.5 -P 1 -Mz 2 -orient 0 1 0 -1 0 0

# vertical load first
timeSeries Linear 1
pattern Plain 1 1 {
    load 2 0.0 [expr -$axial] 0.0
}
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 20
algorithm Newton
integrator LoadControl 0.2
analysis Static
analyze 5
loadConst -time 0.0
wipeAnalysis

# actuator
timeSeries Path 2 -dt $dt -filePath $motion
pattern Plain 2 2 {
    sp 2 1 1.0
}
recorder Element -file force.out -time -ele 1 force
recorder Node -file disp.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-9 50
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
