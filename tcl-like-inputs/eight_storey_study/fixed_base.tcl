# The eight-storey frame of building.tcl on a fixed base, for a comparison with the isolated one.
#
# Units: kN, m, s, t.

set fixedBase 1
source [file join [file dirname [file normalize [info script]]] building.tcl]
