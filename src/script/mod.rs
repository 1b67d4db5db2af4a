//! The Tcl 8.6 interpreter that runs the scripts.
