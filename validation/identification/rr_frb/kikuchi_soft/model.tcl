# KikuchiBearing as in kikuchi/model.tcl, its axial springs softer and weaker in tension than Eqs 2 and 3 of the paper and 2 G_r make
# them: those are of rigid plates that are bonded to their supports. Fibres stretch, and the edges of a bearing that only lies
# between its supports lift.
wipe
model basic -ndm 3 -ndf 6
source ../common.tcl
source ../models/rr_frb_kikuchi.tcl
pset cg 2.0
pset ch 0.80
pset cu 1.12
pset modulus 0.5
pset tension 0.1
set rr_frb::modulus [expr {$modulus*$rr_frb::modulus}]
set rr_frb::cavitation [expr {$tension*$rr_frb::cavitation}]
bearing_nodes
rr_frb_kikuchi 1 1 2 {0 0 1} {1 0 0} [list $cg $ch $cu]
bearing_test $motion $dt $npts
