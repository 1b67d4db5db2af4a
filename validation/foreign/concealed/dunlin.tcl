# block foundation of a compressor, series dunlin
#===============================================================
#  BLOCK FOUNDATION OF A COMPRESSOR - RUN-UP            lb, in, s
#===============================================================
wipe
model basic -ndm 2 -ndf 3
set kx 734353.9
set cx 4081.538
set kr 3.739288
set g 386.4
set Wb 148000.        ;# block
set Wm  26000.        ;# machine
node 1  0.   0.
node 2  0.  42.       ;# CG of the block
node 3  0. 120.       ;# shaft
node 10 0.   0.
fix 10 1 1 1
mass 2 [expr $Wb/$g] [expr $Wb/$g] [expr 1.15e8/$g]
mass 3 [expr $Wm/$g] [expr $Wm/$g] 1.0
uniaxialMaterial Elastic 1 $kx $cx
uniaxialMaterial Elastic 2 2.2e6 2.4e4
uniaxialMaterial Elastic 3 [expr 1.0e9*$kr] 1.3e7
element zeroLength 1 10 1 -mat 1 2 3 -dir 1 2 6
uniaxialMaterial ElasticPP 4 6.0e6 4.0e-4
element zeroLength 4 10 1 -mat 4 -dir 1
# elements of the block and the pedestal
geomTransf Linear 1
element elasticBeamColumn 2 1 2 8000. 3.6e6 1.0e7 1
element elasticBeamColumn 3 2 3 1500. 3.6e6 8.0e5 1
# rotating force at the shaft
timeSeries Path 1 -dt $dt -filePath $motion
pattern Plain 1 1 {
    load 3 1.0 0.0 0.0
}
recorder Node -file shaft.out -time -node 3 -dof 1 disp
recorder Node -file block.out -time -node 2 -dof 1 3 accel
constraints Plain
numberer RCM
system ProfileSPD
test NormDispIncr 1.e-10 20
algorithm Newton
integrator HHT 0.95
analysis Transient
for {set i 1} {$i < $npts} {incr i} {
    if {[analyze 1 $dt] != 0} {error "no convergence"}
}
