# Identification of the rheology of high damping rubber from its tests, as procedures to `source` after hdrb_tests.tcl.
#
#   hdrb::equilibrium STRAINS STRESSES           Table 3.1: nonlinear least squares on the end points of MSR (3.3)
#   hdrb::stepSearch PARAMETERS RUN              Table 3.2: the search of Fig 3.7 on overstress parameters, one cycle of Sin
#   hdrb::joint PARAMETERS RUNS                  all ten parameters at once, with confidence intervals
#
# Parameters are lists in the order of `uniaxialMaterial HDRRheology`: C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a n.
# Equations and figures are those of D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at
# room and low temperatures, dissertation.

namespace eval hdrb {
    variable names {C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a n}
    # Least squares end where a round gains less than this part of what is left.
    variable enough 1e-6

    # Inverse of a symmetric positive matrix (a list of rows) by Gauss and Jordan.
    proc inverse {matrix} {
        set n [llength $matrix]
        for {set i 0} {$i < $n} {incr i} {
            set row [lindex $matrix $i]
            for {set j 0} {$j < $n} {incr j} { lappend row [expr {$i == $j ? 1.0 : 0.0}] }
            lset matrix $i $row
        }
        for {set i 0} {$i < $n} {incr i} {
            set best $i
            for {set k [expr {$i + 1}]} {$k < $n} {incr k} {
                if {abs([lindex $matrix $k $i]) > abs([lindex $matrix $best $i])} { set best $k }
            }
            set pivot [lindex $matrix $best]
            lset matrix $best [lindex $matrix $i]
            set scale [lindex $pivot $i]
            if {$scale == 0.0} { error "the matrix is singular: a parameter has no effect" }
            set row {}
            foreach x $pivot { lappend row [expr {$x/$scale}] }
            lset matrix $i $row
            for {set k 0} {$k < $n} {incr k} {
                set factor [lindex $matrix $k $i]
                if {$k == $i || $factor == 0.0} { continue }
                set other {}
                foreach x [lindex $matrix $k] y $row { lappend other [expr {$x - $factor*$y}] }
                lset matrix $k $other
            }
        }
        set out {}
        foreach row $matrix { lappend out [lrange $row $n end] }
        return $out
    }

    proc sumOfSquares {list} {
        set sum 0.0
        foreach x $list { set sum [expr {$sum + $x*$x}] }
        return $sum
    }

    # Derivatives of a model (a command prefix that takes parameters and gives a list) by the logarithms of parameters: a list
    # of columns.
    proc sensitivities {model p base} {
        set columns {}
        set i 0
        foreach x $p {
            set column {}
            foreach y [{*}$model [lreplace $p $i $i [expr {$x*exp(1e-4)}]]] y0 $base {
                lappend column [expr {($y - $y0)/1e-4}]
            }
            lappend columns $column
            incr i
        }
        return $columns
    }

    # Least squares by Levenberg and Marquardt in the logarithms of the parameters, which are all positive. Gives parameters,
    # R2 (Eq 3.14), the relative half widths of the 95 % intervals of confidence, and the standard deviation of what is left.
    proc leastSquares {model p data {limits {}}} {
        variable enough
        set lambda 1e-3
        set n [llength $p]
        set got [{*}$model $p]
        set miss [lmap y $data m $got { expr {$y - $m} }]
        set sum [sumOfSquares $miss]
        for {set round 0} {$round < 60} {incr round} {
            set columns [sensitivities $model $p $got]
            set normal [normal $columns]
            set gradient [lmap c $columns { tcl::mathop::+ {*}[lmap x $c y $miss { expr {$x*$y} }] }]
            set better 0
            while {!$better && $lambda < 1e9} {
                set damped $normal
                for {set i 0} {$i < $n} {incr i} {
                    lset damped $i $i [expr {[lindex $normal $i $i]*(1.0 + $lambda) + 1e-30}]
                }
                set step [lmap row [inverse $damped] {
                    tcl::mathop::+ {*}[lmap x $row g $gradient { expr {$x*$g} }]
                }]
                set next [lmap x $p d $step { expr {$x*exp(max(-0.7, min(0.7, $d)))} }]
                set i 0
                foreach {low high} $limits {
                    lset next $i [expr {max($low, min($high, [lindex $next $i]))}]
                    incr i
                }
                set then [{*}$model $next]
                set left [lmap y $data m $then { expr {$y - $m} }]
                set total [sumOfSquares $left]
                if {$total < $sum} { set better 1 } else { set lambda [expr {$lambda*5.0}] }
            }
            if {!$better} { break }
            set gained [expr {1.0 - $total/$sum}]
            lassign [list $next $then $left $total] p got miss sum
            set lambda [expr {max(1e-9, $lambda*0.2)}]
            if {$gained < $enough || $sum < 1e-20} { break }
        }
        set deviation [expr {sqrt($sum/max(1, [llength $data] - $n))}]
        return [list $p [r2 $data $got] [intervals [sensitivities $model $p $got] $deviation] $deviation]
    }

    proc normal {columns} {
        set rows {}
        foreach a $columns {
            set row {}
            foreach b $columns { lappend row [tcl::mathop::+ {*}[lmap x $a y $b { expr {$x*$y} }]] }
            lappend rows $row
        }
        return $rows
    }

    # Relative half widths of 95 % intervals from derivatives by logarithms and the deviation of the data; infinite where the
    # data do not tell.
    proc intervals {columns deviation} {
        set normal [normal $columns]
        # Scaled to ones on the diagonal, so that round-off is that of the correlations.
        set size {}
        set i 0
        foreach row $normal { lappend size [expr {sqrt([lindex $row $i])}]; incr i }
        set most [tcl::mathfunc::max {*}$size]
        set scaled {}
        foreach row $normal s $size {
            lappend scaled [lmap x $row t $size { expr {$s > 1e-7*$most && $t > 1e-7*$most ? $x/$s/$t : 0.0} }]
        }
        set i 0
        foreach s $size { if {$s <= 1e-7*$most} { lset scaled $i $i 1.0 }; incr i }
        if {[catch { inverse $scaled } covariance]} { return [lmap s $size { expr {Inf} }] }
        set out {}
        set i 0
        foreach s $size {
            set v [lindex $covariance $i $i]
            lappend out [expr {$s > 1e-7*$most && $v > 0.0 ? 1.96*$deviation*sqrt($v)/$s : Inf}]
            incr i
        }
        return $out
    }

    # Equilibrium stress (Eqs 3.4 to 3.7) at strains that come one after the other.
    proc equilibriumStress {strains p} {
        lassign $p c1 c2 c3 tau m
        set slip 0.0
        set out {}
        foreach g $strains {
            set t [expr {$c1*($g - $slip)}]
            if {abs($t) > $tau} {
                set t [expr {$t > 0.0 ? $tau : -$tau}]
                set slip [expr {$g - $t/$c1}]
            }
            lappend out [expr {$t + $c2*$g + ($g < 0 ? -1.0 : 1.0)*$c3*abs($g)**$m}]
        }
        return $out
    }

    # Equilibrium parameters from the end points of a multi-step relaxation. tau_cr is half of the height of the loop, as in
    # the thesis: the mean over strains that are passed in both directions; the others are found by least squares.
    proc equilibrium {strains stresses} {
        set gaps {}
        foreach g $strains s $stresses {
            set key [format %.3f $g]
            if {[info exists first($key)] && abs($g) < 2.3 && abs($s - $first($key)) > 1e-6} {
                lappend gaps [expr {0.5*abs($s - $first($key))}]
            }
            if {![info exists first($key)]} { set first($key) $s }
        }
        # Strains that are passed three times count by the largest difference; small ones are those of the same branch.
        set most [tcl::mathfunc::max {*}$gaps]
        set gaps [lmap x $gaps { expr {$x > 0.5*$most ? $x : [continue]} }]
        set tau [expr {[tcl::mathop::+ {*}$gaps]/[llength $gaps]}]
        set model [list apply {{strains tau p} {
            lassign $p c1 c2 c3 m
            hdrb::equilibriumStress $strains [list $c1 $c2 $c3 $tau $m]
        }} $strains $tau]
        lassign [leastSquares $model {8.0 0.5 0.01 5.0} $stresses {1.0 100.0 0.01 10.0 1e-5 1.0 1.5 9.0}] p r2 half
        lassign $p c1 c2 c3 m
        return [list [list $c1 $c2 $c3 $tau $m] $r2]
    }

    # Stress of the law along the history of a run.
    proc stressOf {segments p {options {}}} {
        return [dict get [run $segments [list HDRRheology {*}$p {*}$options]] stress]
    }

    # The search of Fig 3.7: one parameter after the other is raised or lowered by its step, which grows (S_l) where that
    # helps and shrinks (S_r) where it does not, until all steps are smaller than a limit. Equilibrium parameters stay.
    # Stresses are those of the whole history, or of the segments whose name `-cycle` gives, with the row before them.
    proc stepSearch {p segments stresses args} {
        set options [dict merge {-cycle * -grow 1.2 -shrink 0.5 -least 0.002} $args]
        lassign [lmap key {-cycle -grow -shrink -least} { dict get $options $key }] cycle grow shrink least
        # Eq 3.15: overstress is what is above the equilibrium stress of the strain.
        lassign [sample $segments] times strains names
        set equilibrium [equilibriumStress $strains [lrange $p 0 4]]
        set equilibrium [dict get [select [dict create stress $equilibrium name $names] $cycle] stress]
        set overstress [lmap s $stresses e $equilibrium { expr {$s - $e} }]
        set quality [list apply {{segments cycle equilibrium overstress p} {
            if {[lindex $p 9] > 1.0} { return -1e9 }
            set run [hdrb::run $segments [list HDRRheology {*}$p]]
            set modelled [lmap s [dict get [hdrb::select $run $cycle] stress] e $equilibrium { expr {$s - $e} }]
            hdrb::r2 $overstress $modelled
        }} $segments $cycle $equilibrium $overstress]
        set best [{*}$quality $p]
        set evaluations 1
        for {set i 5} {$i < 10} {incr i} { set step($i) 0.1 }
        set open 1
        while {$open && $evaluations < 3000} {
            set open 0
            for {set i 5} {$i < 10} {incr i} {
                if {$step($i) <= $least} { continue }
                set open 1
                set kept $p
                set found 0
                foreach factor [list [expr {1.0 + $step($i)}] [expr {1.0 - $step($i)}]] {
                    set next [lreplace $kept $i $i [expr {[lindex $kept $i]*$factor}]]
                    set r [{*}$quality $next]
                    incr evaluations
                    if {$r > $best} { lassign [list $r $next 1] best p found }
                }
                set step($i) [expr {$step($i)*($found ? $grow : $shrink)}]
            }
        }
        return [list $p $best $evaluations]
    }

    # All parameters at once from several runs, {segments stresses weight ...}.
    proc joint {p runs} {
        set data {}
        foreach {segments stresses weight} $runs {
            foreach s $stresses { lappend data [expr {$weight*$s}] }
        }
        set model [list apply {{runs p} {
            set out {}
            foreach {segments stresses weight} $runs {
                foreach s [hdrb::stressOf $segments $p] { lappend out [expr {$weight*$s}] }
            }
            return $out
        }} $runs]
        set limits {0.5 200 0.01 20 1e-5 1 0.01 10 1.5 9 0.5 200 0.01 20 0.01 10 0.05 50 0.05 1.0}
        return [leastSquares $model $p $data $limits]
    }
}
