# HDR (Grant's shear law with scragging, Kumar's axial law), parameters of Table 7, by Eqs 4 to 6.
wipe
model basic -ndm 3 -ndf 6
source ../common.tcl
source ../models/rr_frb_hdr.tcl
pset alpha1  0.32
pset alpha2 -0.01
pset alpha3  0.003
pset beta1   0.188
pset beta2   0.187
pset beta3   5.77
pset chi1    0.012
pset chi2    0.086
pset chi3    1.836
pset chi4    0.00025
bearing_nodes
rr_frb_hdr 1 1 2 {0 0 1} {1 0 0} [list $chi1 $chi2 $chi3 $chi4] [list $alpha1 $alpha2 $alpha3] [list $beta1 $beta2 $beta3]
bearing_test $motion $dt $npts
