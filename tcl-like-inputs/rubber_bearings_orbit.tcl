# Two rubber bearings pulled around an orbit: high damping rubber, and rubber with a lead plug.
#
#   Both are multiple shear springs, eight of them in a circle, under a constant vertical load that an axial spring
#   carries; node 2 of each is pulled out along x and then twice around a circle, at 50, 100 and 200 % shear strain.
#   The same is done along a line, and the table shows that a circle takes less than twice the work of a line: the
#   directions share one strength.
#
#           |  W
#           v
#           o  2 --> x, y
#         \ | /
#         -[*]-   8 shear springs, one material; and an axial spring
#         / | \
#           o  1
#
# Units: N, m. Bridgestone's X0.6 and a lead rubber bearing of the same rubber height in Kikuchi and Aiken's law
# (1997, doi 10.1002/(SICI)1096-9845(199702)26:2<215::AID-EQE640>3.0.CO;2-9; 2010, doi 10.1002/eqe.994).

set pi [expr {acos(-1.0)}]
set height 0.16 ;# total thickness of the rubber
set diameter 0.70
set area [expr {0.25*$pi*$diameter**2}]
set plug [expr {0.25*$pi*0.14**2}] ;# lead plug of 140 mm

# The materials of the shear springs, by name.
proc shearMaterial {device tag} {
  global area height plug
  switch $device {
    "high damping rubber" { uniaxialMaterial KikuchiAikenHDR $tag X0.6 $area $height }
    "lead rubber" {
      #                                 type area-of-rubber    height  G      lead  yield  modulus ratio
      uniaxialMaterial KikuchiAikenLRB $tag 1 [expr {$area-$plug}] $height 0.392e6 $plug 8.33e6 0.588e6 13.0
    }
  }
}

# Pull a bearing along a path, a list of x y in m; return the forces that it takes, a list of Fx Fy in N.
proc pull {device path} {
  wipe
  model BasicBuilder -ndm 3 -ndf 6
  node 1 0.0 0.0 0.0
  node 2 0.0 0.0 0.0
  fix 1 1 1 1 1 1 1
  fix 2 0 0 0 1 1 1
  shearMaterial $device 1
  uniaxialMaterial Elastic 2 2.0e9
  # The factors of -lim make the eight springs one bearing in every direction, here from 10 % shear strain on.
  element multipleShearSpring 1 1 2 8 -mat 1 -lim 0.016 -orient 0 0 1 1 0 0
  element zeroLength 2 1 2 -mat 2 -dir 3

  timeSeries Linear 1
  pattern Plain 1 1 { load 2 0.0 0.0 -4.0e6 0.0 0.0 0.0 }
  constraints Transformation
  numberer RCM
  system FullGeneral
  test NormDispIncr 1e-10 20
  algorithm Newton
  integrator LoadControl 1.0
  analysis Static
  if {[analyze 1] != 0} { error "the bearing does not carry its load" }
  loadConst -time 0.0

  foreach {x y} $path { lappend xs $x; lappend ys $y }
  timeSeries Path 2 -dt 1.0 -values $xs -useLast
  timeSeries Path 3 -dt 1.0 -values $ys -useLast
  pattern Plain 2 2 { sp 2 1 1.0 }
  pattern Plain 3 3 { sp 2 2 1.0 }
  for {set i 1} {$i < [llength $xs]} {incr i} {
    if {[analyze 1] != 0} { error "$device: the analysis failed at step $i" }
    lappend forces {*}[lrange [eleResponse 1 basicForce] 1 2]
  }
  return $forces
}

# Out along x in 20 steps, then twice around: a circle (shape 1) or a line (shape 0).
proc orbit {radius shape} {
  global pi
  set path {0.0 0.0}
  for {set i 1} {$i <= 20} {incr i} { lappend path [expr {$radius*$i/20.0}] 0.0 }
  for {set i 1} {$i <= 160} {incr i} {
    set angle [expr {2.0*$pi*$i/80.0}]
    lappend path [expr {$radius*cos($angle)}] [expr {$shape*$radius*sin($angle)}]
  }
  return $path
}

# Work of the second time around.
proc work {path forces} {
  set sum 0.0
  for {set i 101} {$i <= 180} {incr i} {
    foreach k {0 1} {
      set step [expr {[lindex $path [expr {2*$i+$k}]] - [lindex $path [expr {2*$i-2+$k}]]}]
      set mean [expr {0.5*([lindex $forces [expr {2*$i-2+$k}]] + [lindex $forces [expr {2*$i-4+$k}]])}]
      set sum [expr {$sum + $mean*$step}]
    }
  }
  return $sum
}

puts "                      shear    largest force, kN     work of a cycle, kJ"
puts "                      strain   line     circle       line     circle"
foreach device {"high damping rubber" "lead rubber"} {
  foreach strain {0.5 1.0 2.0} {
    set row [format "%-21s %5.0f %%" $device [expr {100.0*$strain}]]
    set peaks {}
    set works {}
    foreach shape {0 1} {
      set path [orbit [expr {$strain*$height}] $shape]
      set forces [pull $device $path]
      set peak 0.0
      foreach {fx fy} $forces { set peak [expr {max($peak, hypot($fx, $fy))}] }
      lappend peaks [expr {$peak/1e3}]
      lappend works [expr {[work $path $forces]/1e3}]
    }
    puts [format "%s %8.1f %9.1f %12.2f %9.2f" $row {*}$peaks {*}$works]
  }
}
