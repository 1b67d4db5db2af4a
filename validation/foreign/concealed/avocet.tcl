# elevated tank on a rubber bearing, series avocet
# elevated tank, full, on one high-damping rubber bearing          kN - m - t - s
model basic -ndm 3 -ndf 6
set a1 869.8302
set b1 31.57703

proc support {tag bottom top height} {
    global a1 b1
    node $bottom 0. 0. 0.
    node $top    0. 0. $height
    fix $bottom 1 1 1 1 1 1
    fix $top    0 0 1 1 1 1
    element HDR $tag $bottom $top 700. 2.0e6 0. 0.6 0.003 0.008 20 $a1 -700. 2500. $b1 300. 30. 0.1 0.1 0.8 3. 0 0 1 1 0 0 10. 0.7 1. 0.5 0.0 0.
}
support 7 1 2 0.25
mass 2 150. 150. 150. 0. 0. 0.

timeSeries Path 11 -dt $dt -filePath $motion
timeSeries Path 12 -dt $dt -filePath $second
pattern UniformExcitation 11 1 -accel 11
pattern UniformExcitation 12 2 -accel 12

recorder Node -file tank.out -time -node 2 -dof 1 2 disp
recorder Node -file acc.out -timeSeries 11 12 -time -node 2 -dof 1 2 accel

system FullGeneral
numberer Plain
constraints Plain
test EnergyIncr 1.0e-12 50
integrator Newmark 0.5 0.25
algorithm Newton
analysis Transient
if {[analyze [expr int($npts)-1] $dt] != 0} {error "stopped at [getTime]"}
