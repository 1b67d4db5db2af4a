# Loads along curvature-based beams alone, in steps of gravity under the Plain handler: their end reactions act at once, their moments with the
# first correction, so that a beam on two supports "converges" at rest in every other step. Beams on two supports, cantilevers and two spans
# with clamped ends, in the plane and in space; fibers and elastic sections; two rules of integration. kN, m.
proc gravity {element ndm section transf ends load rule file} {
  wipe
  model BasicBuilder -ndm $ndm -ndf [expr {3*$ndm-3}]
  set spans [expr {$ends eq "clamped" ? 2 : 1}]
  for {set i 1} {$i <= $spans+1} {incr i} {
    if {$ndm == 2} { node $i [expr {4.0*($i-1)}] 0.0 } else { node $i [expr {4.0*($i-1)}] 0.0 0.0 }
  }
  set last [expr {$spans+1}]
  switch $ndm-$ends {
    2-simple { fix 1 1 1 0; fix $last 0 1 0 }
    2-free { fix 1 1 1 1 }
    2-clamped { fix 1 1 1 1; fix $last 1 1 1 }
    3-simple { fix 1 1 1 1 1 0 0; fix $last 0 1 1 0 0 0 }
    3-free { fix 1 1 1 1 1 1 1 }
    3-clamped { fix 1 1 1 1 1 1 1; fix $last 1 1 1 1 1 1 }
  }
  uniaxialMaterial Steel01 1 250e3 200e6 0.05
  if {$section eq "elastic"} {
    if {$ndm == 2} { section Elastic 1 200e6 0.06 4.5e-4 } else { section Elastic 1 200e6 0.06 4.5e-4 2e-4 77e6 5e-4 }
  } elseif {$ndm == 2} {
    section Fiber 1 { patch rect 1 6 2 -0.15 -0.1 0.15 0.1 }
  } else {
    section Fiber 1 -GJ 4e4 { patch rect 1 6 4 -0.15 -0.1 0.15 0.1 }
  }
  if {$ndm == 2} { geomTransf $transf 1 } else { geomTransf $transf 1 0 0 1 }
  for {set i 1} {$i <= $spans} {incr i} {
    if {$rule eq "Lobatto"} { beamIntegration Lobatto $i 1 4 } else { beamIntegration HingeRadau $i 1 0.4 1 0.4 1 }
    element $element $i $i [expr {$i+1}] 1 $i
  }
  timeSeries Linear 1
  pattern Plain 1 1 {
    for {set i 1} {$i <= $spans} {incr i} {
      if {$load eq "uniform"} {
        if {$ndm == 2} { eleLoad -ele $i -type -beamUniform -100.0 } else { eleLoad -ele $i -type -beamUniform -100.0 15.0 }
      } else {
        if {$ndm == 2} { eleLoad -ele $i -type -beamPoint -230.0 0.3 } else { eleLoad -ele $i -type -beamPoint -230.0 50.0 0.3 }
      }
    }
  }
  constraints Plain; numberer Plain; system FullGeneral
  test NormDispIncr 1e-8 30 0; algorithm Newton; integrator LoadControl 0.2; analysis Static
  for {set step 1} {$step <= 5} {incr step} {
    set ok [analyze 1]
    puts $file "$ok [testIter] [nodeDisp 1] [nodeDisp 2] [eleResponse 1 force] [eleResponse 1 section 1 force]"
  }
}
foreach {ndm name} {2 plane.out 3 space.out} {
  set file [open $name w]
  foreach element {forceBeamColumnCBDI forceBeamColumnCSBDI} {
    foreach section {fiber elastic} {
      foreach {transf ends} {Linear simple PDelta free Corotational free Linear clamped} {
        foreach load {uniform point} {
          foreach rule {Lobatto HingeRadau} { gravity $element $ndm $section $transf $ends $load $rule $file }
        }
      }
    }
  }
  close $file
}
