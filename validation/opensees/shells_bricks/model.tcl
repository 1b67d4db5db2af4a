# Shells of three formulations with elastic and layered sections, pushed and pulled; a shaken shell; skew bricks.
# Units: kN, m, s.
proc sections {} {
    nDMaterial ElasticIsotropic 1 2e7 0.25 2.4
    nDMaterial PlateFiber 2 1
    uniaxialMaterial Steel02 3 3e5 2e8 0.01 18 0.925 0.15
    nDMaterial PlateRebar 4 3 90
    nDMaterial PlateRebar 5 3 30
    nDMaterial PlateFromPlaneStress 6 1 5e6
    section ElasticMembranePlateSection 1 2e7 0.25 0.15 2.4
    section PlateFiber 2 2 0.15
    section LayeredShell 3 5 2 0.05 4 0.001 6 0.05 5 0.002 2 0.04
}
proc points {first} {
    set n $first
    foreach {x y z} {0 0 0  1.1 0.1 0.05  2.0 -0.1 0.1  0.1 1.0 0.2  1.0 1.2 0.25  2.1 1.1 0.3} {
        node $n $x $y $z
        incr n
    }
    fix $first 1 1 1 1 1 1
    fix [expr {$first + 3}] 1 1 1 1 1 1
}
proc solve {integrator kind} {
    constraints Plain
    numberer RCM
    system BandGeneral
    test NormUnbalance 1e-8 20
    algorithm Newton
    integrator {*}$integrator
    analysis $kind
}

# Three strips of shells side by side, which do not touch.
model basic -ndm 3 -ndf 6
sections
foreach {first section kind} {11 3 ShellMITC4 21 3 ShellDKGQ 31 3 ShellDKGT} {
    points $first
    for {set i 0} {$i < 6} {incr i} { set $i [expr {$first + $i}] }
    if {$kind eq "ShellDKGT"} {
        element $kind 31 $0 $1 $3 $section
        element $kind 32 $1 $4 $3 $section
        element $kind 33 $1 $2 $4 $section
        element $kind 34 $2 $5 $4 $section
    } else {
        element $kind $first $0 $1 $4 $3 $section
        element $kind [expr {$first + 1}] $1 $2 $5 $4 $section
    }
}
recorder Node -file strips.out -time -node 12 13 15 16 22 23 25 26 32 33 35 36 -dof 1 2 3 4 5 6 disp
recorder Element -file forces.out -time -ele 11 22 33 forces
recorder Element -file stresses.out -time -ele 12 21 34 stresses
timeSeries Linear 1
pattern Plain 1 1 {
    foreach first {11 21 31} {
        load [expr {$first + 2}] 10 20 -30 1 2 3
        load [expr {$first + 5}] -50 10 20 3 2 -1
    }
}
solve {LoadControl 2.0} Static
analyze 10
integrator LoadControl -3.0
analyze 12
wipe

# A shell with mass, shaken across.
model basic -ndm 3 -ndf 6
sections
points 1
element ShellMITC4 1 1 2 5 4 1
element ShellMITC4 2 2 3 6 5 2
recorder Node -file shaken.out -time -node 3 6 -dof 1 2 3 4 disp
timeSeries Path 5 -dt 0.1 -values {0 1 0 -1 0 0.5 0 0}
pattern UniformExcitation 5 3 -accel 5
rayleigh 0.1 0.001 0 0
solve {Newmark 0.5 0.25} Transient
analyze 40 0.02
wipe

# Two skew bricks with mass and a body force, loaded and then let go.
model basic -ndm 3 -ndf 3
nDMaterial ElasticIsotropic 1 2e7 0.2 2.4
set n 0
foreach {x y} {0 0  1.1 0.1  1.2 0.9  -0.1 1.0} {
    for {set k 0} {$k < 3} {incr k} { node [expr {1 + $n + 4*$k}] [expr {$x + 0.1*$k}] [expr {$y - 0.05*$k*$k}] [expr {0.8*$k + 0.05*$x}] }
    incr n
}
foreach i {1 2 3 4} { fix $i 1 1 1 }
element stdBrick 1 1 2 3 4 5 6 7 8 1
element stdBrick 2 5 6 7 8 9 10 11 12 1 0 0 -5
recorder Node -file bricks.out -time -node 9 10 11 12 -dof 1 2 3 disp
recorder Element -file brick.out -time -ele 1 stresses
timeSeries Linear 1
pattern Plain 1 1 { load 9 100 20 0; load 11 0 -50 30 }
solve {LoadControl 0.5} Static
analyze 4
wipeAnalysis
remove loadPattern 1
solve {Newmark 0.5 0.25} Transient
analyze 30 0.0005
wipe
