# Identification of the rheology of high damping rubber from its tests, as procedures to `source` after hdrb_tests.tcl.
#
#   hdrb::equilibrium STRAINS STRESSES           Table 3.1: nonlinear least squares on the end points of MSR (3.3)
#   hdrb::overstressStart EQUILIBRIUM RUN ...    starting values of Table 3.2 from a simple relaxation (Figs 3.5, 3.6)
#   hdrb::stepSearch PARAMETERS RUN              Table 3.2: the search of Fig 3.7 on overstress parameters, one cycle of Sin
#   hdrb::joint PARAMETERS RUNS                  all ten parameters at once, with confidence intervals
#   hdrb::undetermined NAMES HALVES              names of the parameters that a test does not determine
#
# Intervals are relative half widths of 95 % intervals, from noise alone: they do not know what a scheme takes for granted.
# Parameters are lists in the order of `uniaxialMaterial HDRRheology`: C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a n.
# Equations and figures are those of D. A. Nguyen, A rheology model of high damping rubber bearings for seismic analysis at
# room and low temperatures, dissertation.

namespace eval hdrb {
    variable names {C1eq C2eq C3eq tauCrEq m C1oe C2oe tauCrOe a n}
    # Least squares end where a round gains less than this part of what is left.
    variable enough 1e-6
    # A parameter whose interval is wider than this part of it is not determined.
    variable widest 0.5

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

    # Names of the parameters whose interval is too wide.
    proc undetermined {names halves} {
        variable widest
        set out {}
        foreach name $names half $halves { if {$half > $widest} { lappend out $name } }
        return $out
    }

    # C2, C3 and m of Eq 3.7 from points: for each m the other two are linear.
    proc elasticStart {strains stresses} {
        set best Inf
        for {set m 2.0} {$m <= 8.0} {set m [expr {$m + 0.25}]} {
            lassign {0.0 0.0 0.0 0.0 0.0} aa ab bb ay by
            foreach g $strains s $stresses {
                set b [expr {($g < 0 ? -1.0 : 1.0)*abs($g)**$m}]
                lassign [list [expr {$aa + $g*$g}] [expr {$ab + $g*$b}] [expr {$bb + $b*$b}] [expr {$ay + $g*$s}] \
                    [expr {$by + $b*$s}]] aa ab bb ay by
            }
            set det [expr {$aa*$bb - $ab*$ab}]
            set c2 [expr {($ay*$bb - $by*$ab)/$det}]
            set c3 [expr {($by*$aa - $ay*$ab)/$det}]
            if {$c2 <= 0.0 || $c3 <= 0.0} { continue }
            set missed 0.0
            foreach g $strains s $stresses {
                set missed [expr {$missed + ($s - $c2*$g - ($g < 0 ? -1.0 : 1.0)*$c3*abs($g)**$m)**2}]
            }
            if {$missed < $best} { lassign [list $missed $c2 $c3 $m] best p2 p3 power }
        }
        if {$best == Inf} { error "the equilibrium stress does not stiffen: there is no start for C3eq and m" }
        return [list $p2 $p3 $power]
    }

    # Equilibrium parameters from the end points of a multi-step relaxation, R2, and intervals. tau_cr is half of the height
    # of the loop, as in the thesis: the mean over strains that are passed in both directions. Its interval is from the
    # scatter of the heights. The others are found by least squares. The middle of the loop gives the start of C2, C3 and m.
    # C1 starts at the least value with which the slider yields between two points after a reversal.
    proc equilibrium {strains stresses} {
        set gaps {}
        set at {}
        set middle {}
        set step Inf
        set before ""
        foreach g $strains s $stresses {
            set key [format %.3f $g]
            if {[info exists first($key)] && abs($g) < 2.3 && abs($s - $first($key)) > 1e-6} {
                lappend gaps [expr {0.5*abs($s - $first($key))}]
                lappend at $g
                lappend middle [expr {0.5*($s + $first($key))}]
            }
            if {![info exists first($key)]} { set first($key) $s }
            if {$before ne ""} { set step [expr {min($step, abs($g - $before))}] }
            set before $g
        }
        # Strains that are passed three times count by the largest difference; small ones are those of the same branch.
        set most [tcl::mathfunc::max {*}$gaps]
        lassign {} heights loop points
        foreach x $gaps g $at s $middle {
            if {$x > 0.5*$most} { lappend heights $x; lappend loop $g; lappend points $s }
        }
        set n [llength $heights]
        set tau [expr {[tcl::mathop::+ {*}$heights]/$n}]
        set scatter [expr {sqrt([sumOfSquares [lmap x $heights { expr {$x - $tau} }]]/max(1, $n - 1)/$n)}]
        # The ends of the loop are passed once, on the branch of loading.
        foreach g $strains s $stresses {
            if {abs($g) >= 2.3} { lappend loop $g; lappend points [expr {$s - ($g < 0 ? -$tau : $tau)}] }
        }
        set start [list [expr {2.0*$tau/$step}] {*}[elasticStart $loop $points]]
        set model [list apply {{strains tau p} {
            lassign $p c1 c2 c3 m
            hdrb::equilibriumStress $strains [list $c1 $c2 $c3 $tau $m]
        }} $strains $tau]
        set limits [list [lindex $start 0] 200.0 0.01 10.0 1e-5 1.0 1.5 9.0]
        lassign [leastSquares $model $start $stresses $limits] p r2 half
        lassign $p c1 c2 c3 m
        lassign $half h1 h2 h3 hm
        return [list [list $c1 $c2 $c3 $tau $m] $r2 [list $h1 $h2 $h3 [expr {1.96*$scatter/$tau}] $hm]]
    }

    # Starting values of the overstress parameters from a simple relaxation, names of whose segments are those of `path`.
    # Overstress is the stress above the one at the end of the hold. In the hold the springs unload the dashpot,
    # -d tau/dt = (C1 + C2) (tau/a)^(1/n) by Eqs 3.9 to 3.13, so that logarithms of stress and rate give n and a
    # (Figs 3.5, 3.6). On the ramp the overstress is a line whose height is tau_cr and whose slope is C2.
    proc overstressStart {equilibrium segments stresses} {
        lassign [sample $segments] times strains names
        set slope 0.0
        lassign {} loaded line hold
        foreach t $times g $strains s $stresses name $names {
            switch $name {
                loading {
                    if {$slope == 0.0 && $g > 0.0} { set slope [expr {$s/$g}] }
                    lappend line $g [expr {$s - [lindex [equilibriumStress [list 0.0 $g] $equilibrium] end]}]
                    set begin $t
                }
                hold-loading { lappend hold [expr {$t - $begin}] $s }
            }
        }
        set rest [lindex $hold end]
        set line [lrange $line [expr {[llength $line]/4*2}] end]
        lassign [regression $line] height c2
        set c2 [expr {max($c2, 0.05*$height)}]
        # The spring of the slider has what the first slope leaves beside the equilibrium.
        set c1 [expr {max($slope - [lindex $equilibrium 1] - $c2, 2.0*$height)}]
        set points {}
        foreach {t s} [lrange $hold 0 end-2] {then next} [lrange $hold 2 end] {
            if {$t <= 0.0 || $then > 10.0 || $next >= $s || $next <= $rest} { continue }
            lappend points [expr {log(0.5*($s + $next) - $rest)}] [expr {log(($s - $next)/($then - $t))}]
        }
        lassign [regression $points] level power
        set n [expr {min(0.9, 1.0/max($power, 1.2))}]
        return [list $c1 $c2 $height [expr {exp($n*(log($c1 + $c2) - $level))}] $n]
    }

    # Height at zero and slope of a line through points {x y x y ...}.
    proc regression {points} {
        lassign {0 0.0 0.0 0.0 0.0} n sx sy xx xy
        foreach {x y} $points {
            incr n
            lassign [list [expr {$sx + $x}] [expr {$sy + $y}] [expr {$xx + $x*$x}] [expr {$xy + $x*$y}]] sx sy xx xy
        }
        if {$n < 3} { error "$n points are too few for a line" }
        set slope [expr {($n*$xy - $sx*$sy)/($n*$xx - $sx*$sx)}]
        return [list [expr {($sy - $slope*$sx)/$n}] $slope]
    }

    # Stress of the law along the history of a run.
    proc stressOf {segments p {options {}}} {
        return [dict get [run $segments [list HDRRheology {*}$p {*}$options]] stress]
    }

    # The search of Fig 3.7: one parameter after the other is raised or lowered by its step, which grows (S_l) where that
    # helps and shrinks (S_r) where it does not, until all steps are smaller than a limit. Equilibrium parameters stay, but for
    # those of `-free`, which relaxation has left open. Stresses are those of the whole history, or of the segments whose name
    # `-cycle` gives, with the row before them. Gives parameters, R2, the number of simulations, and intervals of all ten; a
    # parameter that stays has none.
    proc stepSearch {p segments stresses args} {
        variable names
        set options [dict merge {-cycle * -grow 1.2 -shrink 0.5 -least 0.002 -free {}} $args]
        lassign [lmap key {-cycle -grow -shrink -least} { dict get $options $key }] cycle grow shrink least
        set searched [lmap name [dict get $options -free] { lsearch -exact $names $name }]
        lappend searched 5 6 7 8 9
        # Eq 3.15: overstress is what is above the equilibrium stress of the strain.
        lassign [sample $segments] times strains segment
        set equilibrium [equilibriumStress $strains [lrange $p 0 4]]
        set equilibrium [dict get [select [dict create stress $equilibrium name $segment] $cycle] stress]
        set overstress [lmap s $stresses e $equilibrium { expr {$s - $e} }]
        set model [list apply {{segments cycle equilibrium p} {
            set run [hdrb::run $segments [list HDRRheology {*}$p]]
            lmap s [dict get [hdrb::select $run $cycle] stress] e $equilibrium { expr {$s - $e} }
        }} $segments $cycle $equilibrium]
        set best [r2 $overstress [{*}$model $p]]
        set evaluations 1
        foreach i $searched { set step($i) 0.1 }
        set open 1
        while {$open && $evaluations < 3000} {
            set open 0
            foreach i $searched {
                if {$step($i) <= $least} { continue }
                set open 1
                set kept $p
                set found 0
                foreach factor [list [expr {1.0 + $step($i)}] [expr {1.0 - $step($i)}]] {
                    set next [lreplace $kept $i $i [expr {[lindex $kept $i]*$factor}]]
                    if {[lindex $next 9] > 1.0} { continue }
                    set r [r2 $overstress [{*}$model $next]]
                    incr evaluations
                    if {$r > $best} { lassign [list $r $next 1] best p found }
                }
                set step($i) [expr {$step($i)*($found ? $grow : $shrink)}]
            }
        }
        set got [{*}$model $p]
        set left [sumOfSquares [lmap y $overstress m $got { expr {$y - $m} }]]
        set deviation [expr {sqrt($left/max(1, [llength $got] - [llength $searched]))}]
        set columns {}
        foreach i $searched {
            set x [expr {[lindex $p $i]*exp(1e-4)}]
            lappend columns [lmap y [{*}$model [lreplace $p $i $i $x]] y0 $got { expr {($y - $y0)/1e-4} }]
        }
        set half [lrepeat 10 {}]
        foreach i $searched h [intervals $columns $deviation] { lset half $i $h }
        return [list $p $best $evaluations $half]
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
