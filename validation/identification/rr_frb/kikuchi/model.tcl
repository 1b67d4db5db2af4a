# KikuchiBearing with KikuchiAikenHDR (compound X0.6) and AxialSp, parameters of Table 8.
wipe
model basic -ndm 3 -ndf 6
source ../common.tcl
source ../models/rr_frb_kikuchi.tcl
pset cg 2.0
pset ch 0.80
pset cu 1.12
bearing_nodes
rr_frb_kikuchi 1 1 2 {0 0 1} {1 0 0} [list $cg $ch $cu]
bearing_test $motion $dt $npts
