# Commands of the sheets. A sheet is a problem with a solution on paper; tests/manual.rs runs all sheets and writes docs/verification.

# A problem on a model of its own. `covers` are kinds or commands that it verifies, as they stand in a script.
proc sheet {title covers source problem body} {
    wipe
    puts "sheet\t$title\t$covers\t$source\t[regsub -all {\s+} [string trim $problem] { }]"
    uplevel #0 $body
}

# A result beside its reference. The error is relative to the reference, or to `scale` where that is larger.
proc check {what value reference tolerance {scale 0.0}} {
    puts "check\t$what\t$value\t$reference\t$tolerance\t$scale"
}

# An observed order of convergence: errors with a step and with half of it.
proc order {what coarse fine expected} {
    puts "check\t$what\t[expr {log(abs(double($coarse)/$fine))/log(2.0)}]\t$expected\t0.1\t0.0"
}

# Settings of a static analysis with loads in one or more steps.
proc statics {{steps 1} {handler Plain}} {
    constraints $handler; numberer RCM; system UmfPack
    test NormDispIncr 1e-12 100; algorithm Newton
    integrator LoadControl [expr {1.0/$steps}]; analysis Static
    if {[analyze $steps] != 0} {error "no convergence"}
}

# Settings of a transient analysis.
proc dynamics {args} {
    constraints Transformation; numberer RCM; system UmfPack
    test NormDispIncr 1e-13 100; algorithm Newton
    integrator {*}$args; analysis Transient
}
