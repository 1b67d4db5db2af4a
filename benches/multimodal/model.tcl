# Three storeys in free vibration: a study with many false optima, since a mode that is a period off fits nearly as badly as one
# that is not there at all. Units: kN, m, t, s.
wipe
model basic -ndm 1 -ndf 1
pset k1 800.0
pset k2 800.0
pset k3 800.0
for {set i 0} {$i <= 3} {incr i} { node $i 0.0 }
fix 0 1
foreach {i k} [list 1 $k1 2 $k2 3 $k3] {
    mass $i 1.0
    uniaxialMaterial Elastic $i $k
    element zeroLength $i [expr {$i - 1}] $i -mat $i -dir 1
}
rayleigh 0.2 0.0 0.0 0.0
# The roof is let go.
timeSeries Path 1 -time {0.0 0.05 0.1} -values {0.0 1.0 0.0}
pattern Plain 1 1 { load 3 400.0 }
recorder Node -file roof.out -time -node 3 -dof 1 disp
constraints Plain
numberer Plain
system ProfileSPD
algorithm Linear
integrator Newmark 0.5 0.25
analysis Transient
analyze 240 0.025
