# Two-storey steel frame
# units: kip, in, s
wipe
model basic -ndm 1 -ndf 1

pset k1 290.0
pset k2 170.0
node 1 0.0
fix 1 1
node 2 0.0 -mass 0.52
node 3 0.0 -mass 0.41

uniaxialMaterial Elastic 1 $k1
uniaxialMaterial Elastic 2 $k2
element zeroLength 1 1 2 -mat 1 -dir 1 -doRayleigh 1
element zeroLength 2 2 3 -mat 2 -dir 1 -doRayleigh 1
rayleigh 0.24 0.0 0.0016 0.0

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file acc.out -timeSeries 1 -time -node 2 3 -dof 1 accel
recorder Node -file disp.out -time -node 2 3 -dof 1 disp

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-7 50
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
