# elastomericBearingBoucWen, parameters of Table 6 (Fy in N; alpha_2 belongs to displacements in mm, as the
# paper has them, so mm are used inside of the element's law: alpha2 |u|^mu with u in mm).
wipe
model basic -ndm 3 -ndf 6
source ../common.tcl
pset Fy     11000.0
pset alpha1  0.28
pset alpha2 -0.0003
pset mu      2.40
pset beta    0.75
pset gamma  -0.25
pset eta     3.0
bearing_nodes
set kInit [expr {$Gr*$A/$Tr/$alpha1}]
# (u/mm)^mu = 1000^mu u^mu; the element multiplies alpha2 by kInit u, of the unit of the model.
set a2 [expr {$alpha2*pow(1000.0,$mu-1.0)}]
uniaxialMaterial Elastic 11 4.0e8
uniaxialMaterial Elastic 12 1.0e8
element elastomericBearingBoucWen 1 1 2 $kInit $Fy $alpha1 $a2 $mu $eta $beta $gamma -P 11 -T 12 -My 12 -Mz 12 -orient 0 0 1 1 0 0
bearing_test $motion $dt $npts
