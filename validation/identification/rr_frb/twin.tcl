# A bearing of another kind than the three that are fitted, tested as they are: the rheology of high damping rubber with
# parameters chosen so that its stiffness falls with amplitude about as the paper's tests, softened by what it has been
# through, which loses lateral stiffness under its axial load.
wipe
model basic -ndm 3 -ndf 6
source common.tcl
bearing_nodes
element HDRRheologyBearing 1 1 2 $Gr $Kbulk 0.0 $D 0.0001 0.005 40 7.4e6 1.75e6 0.025e6 0.15e6 3.0 10.0e6 0.37e6 0.15e6 0.62e6 0.25 \
    -mullins 0.6 0.2 -axial linear -orient 0 0 1 1 0 0
amend element 1 axial -critical 400.0e3 -width $D -dir 2 3
bearing_test $motion $dt $npts
