# Five-storey building on high-damping-rubber bearings as a design office would model it: a shear building on one bilinear spring.
# Masses are taken as equal, 75 t a level (the source tells none), so forces are those of a building of 450 t.
# Units: kN, m, t, s.
wipe
model basic -ndm 1 -ndf 1

pset k0 7264.316839247049   ;# initial stiffness of the isolators, kN/m
pset Fy 154.5395441946389     ;# their yield force, kN
pset b  0.5165659435407605      ;# stiffness after yielding over the initial one
pset ks 73202.2767242474  ;# stiffness of a storey, kN/m
pset cs 774.1673307812272     ;# its damping, kN s/m

for {set i 1} {$i <= 7} {incr i} {node $i 0.0}
fix 1 1
for {set i 2} {$i <= 7} {incr i} {mass $i 75.0}
uniaxialMaterial Steel01 1 $Fy $k0 $b
element zeroLength 1 1 2 -mat 1 -dir 1
uniaxialMaterial Elastic 2 $ks
uniaxialMaterial Viscous 3 $cs 1.0
for {set i 2} {$i <= 6} {incr i} {
    element zeroLength $i $i [expr {$i+1}] -mat 2 3 -dir 1 1
}

timeSeries Path 1 -dt $dt -filePath $motion
pattern UniformExcitation 1 1 -accel 1
recorder Node -file disp.out -time -node 2 7 -dof 1 disp
recorder Node -file acc.out -timeSeries 1 -time -node 2 7 -dof 1 accel

# ---- added by hysteron diagnose: physics that the model left out ----
pset hy_sway 6279.022716617563
pset hy_sway_dashpot 1841.6209558653031
pset hy2_loss 0.31182819778633
pset hy2_energy 121.30296207773412
node 900000 [nodeCoord 1 1]
fix 900000 1
remove sp 1 1
uniaxialMaterial Elastic 900000 $hy_sway
uniaxialMaterial Viscous 900001 $hy_sway_dashpot 1.0
element zeroLength 900000 900000 1 -mat 900000 900001 -dir 1 1
amend element 1 degradation -loss $hy2_loss -energy $hy2_energy -dir 1
# ---- end of what was added ----
constraints Plain
numberer Plain
system ProfileSPD
test NormDispIncr 1.0e-8 40
algorithm Newton
integrator Newmark 0.5 0.25
analysis Transient
if {[analyze [expr {$npts-1}] $dt] != 0} {error "no convergence at [getTime]"}
