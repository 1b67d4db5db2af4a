# One bearing in space under constant axial load and an imposed sine of 314 steps a cycle: the price of a step.
# Words: boucwen, hdr or kikuchi; number of cycles. Units: N, m, s. Prints the force at the end of the last cycle's first quarter.
set kind [lindex $argv 0]
set cycles [lindex $argv 1]
model BasicBuilder -ndm 3 -ndf 6
node 1 0.0 0.0 0.0
node 2 0.0 0.0 0.3
fix 1 1 1 1 1 1 1
fix 2 0 1 0 1 1 1
switch $kind {
    boucwen {
        uniaxialMaterial Elastic 1 1.0e9
        element elastomericBearingBoucWen 1 1 2 5.0e6 8.0e4 0.1 0.0 3.0 1.0 0.5 0.5 -P 1 -T 1 -My 1 -Mz 1 -orient 0 0 1 1 0 0
    }
    hdr {
        element HDR 1 1 2 0.45e6 2.0e9 0.15 0.60 0.003 0.006 28 1.1e6 -6.0e6 9.0e7 1.8e4 4.0e5 60.0 4.0 1.5 0.75 3.0 \
            0 0 1 1 0 0 10.0 0.5 1.0 0.5 0.0 0.0
    }
    kikuchi {
        uniaxialMaterial KikuchiAikenHDR 1 X0.6 0.36 0.15
        uniaxialMaterial AxialSp 2 1.2e9 1.0e6 -100.0e6 1.0 0.01 0.5 0.0
        element KikuchiBearing 1 1 2 -shape square -size 0.60 0.15 -totalHeight 0.3 -nMSS 8 -matMSS 1 -limDisp 0.0015 \
            -nMNS 30 -matMNS 2 -lambda 1.7
    }
}
timeSeries Linear 1
pattern Plain 1 1 { load 2 0.0 0.0 -1.0e6 0.0 0.0 0.0 }
constraints Transformation
numberer Plain
system BandGeneral
test NormDispIncr 1.0e-7 20
algorithm Newton
integrator LoadControl 0.1
analysis Static
if {[analyze 10] != 0} { error "no equilibrium under the axial load" }
loadConst -time 0.0
timeSeries Trig 2 0.0 1.0e6 1.0
pattern Plain 2 2 { sp 2 1 0.1 }
integrator LoadControl [expr {1.0/314.0}]
analysis Static
if {[analyze [expr {314*$cycles + 78}]] != 0} { error "no convergence" }
puts [eleResponse 1 force]
