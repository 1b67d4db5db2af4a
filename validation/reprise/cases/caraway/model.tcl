# Seismic pad, specimens P-31 to P-33
# units: kN, mm, s
wipe
model basic -ndm 2 -ndf 3
node 1 0.0 0.0
node 2 0.0 0.0
fix 1 1 1 1
fix 2 0 1 1

pset ke 1.4
pset k1 6.0
pset Fy 20.0

uniaxialMaterial Elastic 1 $ke
uniaxialMaterial Steel01 2 $Fy $k1 0.02
element twoNodeLink 1 1 2 -mat 1 -dir 2 -orient 0 1 0 -1 0 0
element twoNodeLink 2 1 2 -mat 2 -dir 2 -orient 0 1 0 -1 0 0

timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    sp 2 1 1.0
}
recorder Node -file shear.out -time -node 1 -dof 1 reaction
recorder Node -file travel.out -time -node 2 -dof 1 disp

constraints Transformation
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-9 50
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
