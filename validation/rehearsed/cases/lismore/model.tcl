# Three-storey clinic on isolators
# units: kN, m, t, s
wipe
model basic -ndm 1 -ndf 1

pset Ki 50000.0
pset Fy 300.0
pset Hk 5000.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 210.0
node 3 0.0 -mass 170.0
node 4 0.0 -mass 170.0
node 5 0.0 -mass 140.0

uniaxialMaterial Hardening 1 $Ki $Fy 0.0 $Hk
element zeroLength 1 1 2 -mat 1 -dir 1
uniaxialMaterial Elastic 11 [expr 1.0*150000.0]
uniaxialMaterial Viscous 21 420.0 1.0
element zeroLength 11 2 3 -mat 11 21 -dir 1 1
uniaxialMaterial Elastic 12 [expr 1.0*140000.0]
uniaxialMaterial Viscous 22 380.0 1.0
element zeroLength 12 3 4 -mat 12 22 -dir 1 1
uniaxialMaterial Elastic 13 [expr 1.0*110000.0]
uniaxialMaterial Viscous 23 300.0 1.0
element zeroLength 13 4 5 -mat 13 23 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 2 3 4 5 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 3 4 5 -dof 1 accel

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-8 50
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
set sub 1
if {[info exists nsub]} {set sub $nsub}
for {set i 1} {$i < $npts} {incr i} {
    set ok [analyze $sub [expr $dt/double($sub)]]
    if {$ok != 0} {
        algorithm KrylovNewton
        set ok [analyze $sub [expr $dt/double($sub)]]
        algorithm Newton
    }
    if {$ok != 0} {error "no convergence at [getTime]"}
}
