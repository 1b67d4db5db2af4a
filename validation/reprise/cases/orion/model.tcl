# Four-storey workshop, shear frame
# units: N, m, kg, s
wipe
model basic -ndm 1 -ndf 1
pset rk 1.0     ;# storey stiffness / drawing value
pset ry 1.0     ;# storey strength / drawing value
pset rc 1.0     ;# dashpots / assumed value
node 1 0.0
fix 1 1
node 2 0.0 -mass 130000.0
node 3 0.0 -mass 125000.0
node 4 0.0 -mass 120000.0
node 5 0.0 -mass 95000.0
proc uy {vy k} {
    upvar rk rk ry ry
    return [expr $ry*$vy/(0.92*$rk*$k)]
}
uniaxialMaterial BoucWen 1 0.08 [expr $rk*230000000.0] 2.0 [expr 0.5/pow([uy 1150000.0 230000000.0],2)] [expr 0.5/pow([uy 1150000.0 230000000.0],2)] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 11 [expr $rc*420000.0] 1.0
element zeroLength 1 1 2 -mat 1 11 -dir 1 1
uniaxialMaterial BoucWen 2 0.08 [expr $rk*205000000.0] 2.0 [expr 0.5/pow([uy 1000000.0 205000000.0],2)] [expr 0.5/pow([uy 1000000.0 205000000.0],2)] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 12 [expr $rc*380000.0] 1.0
element zeroLength 2 2 3 -mat 2 12 -dir 1 1
uniaxialMaterial BoucWen 3 0.08 [expr $rk*170000000.0] 2.0 [expr 0.5/pow([uy 800000.0 170000000.0],2)] [expr 0.5/pow([uy 800000.0 170000000.0],2)] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 13 [expr $rc*310000.0] 1.0
element zeroLength 3 3 4 -mat 3 13 -dir 1 1
uniaxialMaterial BoucWen 4 0.08 [expr $rk*125000000.0] 2.0 [expr 0.5/pow([uy 520000.0 125000000.0],2)] [expr 0.5/pow([uy 520000.0 125000000.0],2)] 1.0 0.0 0.0 0.0
uniaxialMaterial Viscous 14 [expr $rc*230000.0] 1.0
element zeroLength 4 4 5 -mat 4 14 -dir 1 1

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1

recorder Node -file disp.out -time -node 2 5 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 3 5 -dof 1 accel

constraints Transformation
numberer RCM
system BandGeneral
test NormDispIncr 1.0e-9 40
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
