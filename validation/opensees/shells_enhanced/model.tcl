# ASDShellQ4 and ASDShellT3 with their options, elastic and of layers, pushed and pulled; both shaken.
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
    system UmfPack
    test NormDispIncr 1e-11 30
    algorithm Newton
    integrator {*}$integrator
    analysis $kind
}

# Strips of two quadrilaterals or four triangles side by side, which do not touch.
set strips {
    11 ASDShellQ4 1 {}
    21 ASDShellQ4 2 {-drillingStab 0.3 -local 1 2 0.3}
    41 ASDShellQ4 1 {-corotational -drillingNL}
    51 ASDShellQ4 3 {-corotational -local 0 1 0}
    61 ASDShellT3 1 {-local 1 -1 0}
    71 ASDShellT3 2 {-reducedIntegration -local 0 1 0.1}
    81 ASDShellT3 1 {-corotational}
    91 ASDShellT3 2 {-corotational -reducedIntegration -drillingNL}
}
model basic -ndm 3 -ndf 6
sections
set tips {}
set firsts {}
foreach {first kind section options} $strips {
    points $first
    for {set i 0} {$i < 6} {incr i} { set $i [expr {$first + $i}] }
    if {$kind eq "ASDShellT3"} {
        element $kind $first $0 $1 $3 $section {*}$options
        element $kind [expr {$first + 1}] $1 $4 $3 $section {*}$options
        element $kind [expr {$first + 2}] $1 $2 $4 $section {*}$options
        element $kind [expr {$first + 3}] $2 $5 $4 $section {*}$options
    } else {
        element $kind $first $0 $1 $4 $3 $section {*}$options
        element $kind [expr {$first + 1}] $1 $2 $5 $4 $section {*}$options
    }
    lappend tips $2 $5
    lappend firsts $first
}
recorder Node -file strips.out -time -node {*}$tips -dof 1 2 3 4 5 6 disp
recorder Element -file forces.out -time -ele {*}$firsts forces
recorder Element -file stresses.out -time -ele {*}$firsts stresses
recorder Element -file strains.out -time -ele {*}$firsts strains
recorder Element -file point.out -time -ele 12 62 material 2 deformation
timeSeries Linear 1
pattern Plain 1 1 {
    foreach first $firsts {
        load [expr {$first + 2}] 10 20 -30 1 2 3
        load [expr {$first + 5}] -50 10 20 3 2 -1
    }
}
solve {LoadControl 2.0} Static
analyze 10
integrator LoadControl -3.0
analyze 12
wipe

# Shells with mass, shaken across.
model basic -ndm 3 -ndf 6
sections
points 1
element ASDShellQ4 1 1 2 5 4 1
element ASDShellT3 2 2 3 6 1
element ASDShellT3 3 2 6 5 1
recorder Node -file shaken.out -time -node 3 6 -dof 1 2 3 4 disp
timeSeries Path 5 -dt 0.1 -values {0 1 0 -1 0 0.5 0 0}
pattern UniformExcitation 5 3 -accel 5
rayleigh 0.1 0.001 0 0
solve {Newmark 0.5 0.25} Transient
analyze 40 0.02
wipe
