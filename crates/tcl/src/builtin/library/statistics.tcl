# Statistics by the names and arguments of tcllib's math::statistics.
namespace eval ::math::statistics {
    namespace export mean min max number var stdev pvar pstdev median basic-stats corr \
        pdf-normal cdf-normal Inverse-cdf-normal pdf-uniform cdf-uniform random-normal random-uniform
    # Missing values are empty.
    proc Values {data} { lsearch -all -inline -not -exact $data {} }
    proc number {data} { llength [Values $data] }
    proc mean {data} { set v [Values $data]; expr {[::tcl::mathop::+ 0.0 {*}$v] / [llength $v]} }
    proc min {data} { ::tcl::mathfunc::min {*}[Values $data] }
    proc max {data} { ::tcl::mathfunc::max {*}[Values $data] }
    proc pvar {data} {
        set m [mean $data]
        set sum 0.0
        foreach x [Values $data] { set sum [expr {$sum + ($x - $m) ** 2}] }
        expr {$sum / [number $data]}
    }
    proc var {data} { set n [number $data]; expr {$n > 1 ? [pvar $data] * $n / ($n - 1.0) : 0.0} }
    proc stdev {data} { expr {sqrt([var $data])} }
    proc pstdev {data} { expr {sqrt([pvar $data])} }
    proc median {data} {
        set v [lsort -real [Values $data]]
        set n [llength $v]
        expr {0.5 * ([lindex $v [expr {($n - 1) / 2}]] + [lindex $v [expr {$n / 2}]])}
    }
    proc basic-stats {data} {
        list [mean $data] [min $data] [max $data] [number $data] [stdev $data] [var $data] [pstdev $data] [pvar $data]
    }
    proc corr {a b} {
        set ma [mean $a]
        set mb [mean $b]
        set sab 0.0; set saa 0.0; set sbb 0.0
        foreach x $a y $b {
            set sab [expr {$sab + ($x - $ma) * ($y - $mb)}]
            set saa [expr {$saa + ($x - $ma) ** 2}]
            set sbb [expr {$sbb + ($y - $mb) ** 2}]
        }
        expr {$sab / sqrt($saa * $sbb)}
    }
    proc pdf-normal {mean stdev x} {
        expr {exp(-0.5 * (($x - $mean) / double($stdev)) ** 2) / $stdev / sqrt(2.0 * acos(-1.0))}
    }
    # By the series and the continued fraction of the error function (Abramowitz and Stegun, 1964, 7.1.6 and 7.1.14).
    proc cdf-normal {mean stdev x} {
        set z [expr {($x - $mean) / double($stdev) / sqrt(2.0)}]
        set a [expr {abs($z)}]
        if {$a < 2.5} {
            set term $a
            set sum $a
            for {set n 1} {$term > 1e-17 * $sum} {incr n} {
                set term [expr {$term * 2.0 * $a * $a / (2.0 * $n + 1.0)}]
                set sum [expr {$sum + $term}]
            }
            set tail [expr {1.0 - 2.0 / sqrt(acos(-1.0)) * exp(-$a * $a) * $sum}]
        } else {
            set f 0.0
            for {set n 60} {$n > 0} {incr n -1} { set f [expr {0.5 * $n / ($a + $f)}] }
            set tail [expr {exp(-$a * $a) / sqrt(acos(-1.0)) / ($a + $f)}]
        }
        expr {$z > 0 ? 1.0 - 0.5 * $tail : 0.5 * $tail}
    }
    # By bisection and Newton's method.
    proc Inverse-cdf-normal {mean stdev prob} {
        if {$prob <= 0.0 || $prob >= 1.0} { error "Probability must be between 0 and 1" }
        set low -40.0; set high 40.0; set z 0.0
        for {set i 0} {$i < 80} {incr i} {
            set p [cdf-normal 0.0 1.0 $z]
            if {$p > $prob} { set high $z } else { set low $z }
            set next [expr {$z - ($p - $prob) / ([pdf-normal 0.0 1.0 $z] + 1e-300)}]
            if {!($next > $low && $next < $high)} { set next [expr {0.5 * ($low + $high)}] }
            if {abs($next - $z) <= 1e-15 * abs($z)} break
            set z $next
        }
        expr {$mean + $stdev * $z}
    }
    proc pdf-uniform {pmin pmax x} { expr {$x < $pmin || $x > $pmax ? 0.0 : 1.0 / ($pmax - $pmin)} }
    proc cdf-uniform {pmin pmax x} {
        expr {$x <= $pmin ? 0.0 : $x >= $pmax ? 1.0 : ($x - $pmin) / double($pmax - $pmin)}
    }
    proc random-uniform {pmin pmax number} {
        set out {}
        for {set i 0} {$i < $number} {incr i} { lappend out [expr {$pmin + ($pmax - $pmin) * rand()}] }
        return $out
    }
    # By pairs (Box and Muller, 1958).
    proc random-normal {mean stdev number} {
        set out {}
        while {[llength $out] < $number} {
            set angle [expr {2.0 * acos(-1.0) * rand()}]
            set radius [expr {$stdev * sqrt(-2.0 * log(rand()))}]
            lappend out [expr {$mean + $radius * cos($angle)}]
            if {[llength $out] < $number} { lappend out [expr {$mean + $radius * sin($angle)}] }
        }
        return $out
    }
}
package provide math::statistics 1.0
