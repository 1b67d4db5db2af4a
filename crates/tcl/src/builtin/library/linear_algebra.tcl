# Vectors and matrices by the names and arguments of tcllib's math::linearalgebra. A matrix is a list of rows.
namespace eval ::math::linearalgebra {
    namespace export mkVector mkUnitVector mkMatrix mkIdentity mkDiagonal mkOnes dim shape getelem setelem getrow setrow \
        getcol setcol swaprows swapcols transpose add sub scale axpy dotproduct crossproduct matmul norm norm_one norm_two \
        norm_max normMatrix angle solveGauss solvePGauss det show
    proc mkVector {n {value 0.0}} { lrepeat $n $value }
    proc mkUnitVector {n at} { set v [lrepeat $n 0.0]; lset v $at 1.0; return $v }
    proc mkMatrix {rows cols {value 0.0}} { lrepeat $rows [lrepeat $cols $value] }
    proc mkOnes {n} { mkMatrix $n $n 1.0 }
    proc mkIdentity {n} { mkDiagonal [lrepeat $n 1.0] }
    proc mkDiagonal {values} {
        set m [mkMatrix [llength $values] [llength $values] 0.0]
        set i 0
        foreach x $values { lset m $i $i $x; incr i }
        return $m
    }
    proc shape {mv} {
        if {[llength [lindex $mv 0]] > 1} { return [list [llength $mv] [llength [lindex $mv 0]]] }
        return [llength $mv]
    }
    proc dim {mv} { llength [shape $mv] }
    proc getelem {mv row {col {}}} { if {$col eq {}} { lindex $mv $row } else { lindex $mv $row $col } }
    proc setelem {name row col {value {}}} {
        upvar 1 $name m
        if {$value eq {}} { lset m $row $col } else { lset m $row $col $value }
    }
    proc getrow {m row} { lindex $m $row }
    proc setrow {name row values} { upvar 1 $name m; lset m $row $values }
    proc getcol {m col} { lmap row $m { lindex $row $col } }
    proc setcol {name col values} {
        upvar 1 $name m
        set i 0
        foreach x $values { lset m $i $col $x; incr i }
        return $m
    }
    proc swaprows {name a b} {
        upvar 1 $name m
        set row [lindex $m $a]
        lset m $a [lindex $m $b]
        lset m $b $row
    }
    proc swapcols {name a b} {
        upvar 1 $name m
        set column [getcol $m $a]
        setcol m $a [getcol $m $b]
        setcol m $b $column
    }
    proc transpose {m} {
        set out {}
        for {set j 0} {$j < [llength [lindex $m 0]]} {incr j} { lappend out [getcol $m $j] }
        return $out
    }
    proc axpy {factor x y} {
        if {[llength [lindex $x 0]] > 1} { return [lmap a $x b $y { axpy $factor $a $b }] }
        lmap a $x b $y { expr {$factor * $a + $b} }
    }
    proc add {x y} { axpy 1 $x $y }
    proc sub {x y} { axpy -1 $y $x }
    proc scale {factor x} {
        if {[llength [lindex $x 0]] > 1} { return [lmap a $x { scale $factor $a }] }
        lmap a $x { expr {$factor * $a} }
    }
    proc dotproduct {x y} {
        set sum 0.0
        foreach a $x b $y { set sum [expr {$sum + $a * $b}] }
        return $sum
    }
    proc crossproduct {x y} {
        lassign $x a b c
        lassign $y d e f
        list [expr {$b * $f - $c * $e}] [expr {$c * $d - $a * $f}] [expr {$a * $e - $b * $d}]
    }
    proc norm_one {x} { set sum 0.0; foreach a $x { set sum [expr {$sum + abs($a)}] }; return $sum }
    proc norm_two {x} { expr {sqrt([dotproduct $x $x])} }
    proc norm_max {x} { set top 0.0; foreach a $x { set top [expr {max($top, abs($a))}] }; return $top }
    proc norm {x {type 2}} {
        switch -- $type {
            1 { norm_one $x }
            2 { norm_two $x }
            max - inf { norm_max $x }
            default { error "Unknown norm: $type" }
        }
    }
    proc normMatrix {m {type 2}} { norm [concat {*}$m] $type }
    proc angle {x y} { expr {acos([dotproduct $x $y] / ([norm_two $x] * [norm_two $y]))} }
    # A vector on the right is a column.
    proc matmul {a b} {
        if {[llength [lindex $a 0]] <= 1 && [llength [lindex $b 0]] <= 1} { return [dotproduct $a $b] }
        if {[llength [lindex $b 0]] <= 1} { return [lmap row $a { dotproduct $row $b }] }
        set columns [transpose $b]
        if {[llength [lindex $a 0]] <= 1} { return [lmap c $columns { dotproduct $a $c }] }
        lmap row $a { lmap c $columns { dotproduct $row $c } }
    }
    # Elimination with partial pivoting. Returns the triangle, the right-hand side, and the determinant.
    proc Eliminate {m b} {
        set n [llength $m]
        set det 1.0
        for {set i 0} {$i < $n} {incr i} {
            set best $i
            for {set k $i} {$k < $n} {incr k} {
                if {abs([lindex $m $k $i]) > abs([lindex $m $best $i])} { set best $k }
            }
            if {$best != $i} {
                swaprows m $i $best
                swaprows b $i $best
                set det [expr {-$det}]
            }
            set pivot [lindex $m $i $i]
            set det [expr {$det * $pivot}]
            if {$pivot == 0} { return [list $m $b 0.0] }
            for {set k [expr {$i + 1}]} {$k < $n} {incr k} {
                set f [expr {-[lindex $m $k $i] / double($pivot)}]
                lset m $k [axpy $f [lindex $m $i] [lindex $m $k]]
                lset b $k [axpy $f [lindex $b $i] [lindex $b $k]]
            }
        }
        return [list $m $b $det]
    }
    proc solvePGauss {m b} {
        lassign [Eliminate $m $b] u y det
        if {$det == 0} { error "Matrix is singular" }
        for {set i [expr {[llength $u] - 1}]} {$i >= 0} {incr i -1} {
            set row [lindex $y $i]
            for {set j [expr {$i + 1}]} {$j < [llength $u]} {incr j} {
                set row [axpy [expr {-[lindex $u $i $j]}] [lindex $y $j] $row]
            }
            lset y $i [scale [expr {1.0 / [lindex $u $i $i]}] $row]
        }
        return $y
    }
    proc solveGauss {m b} { solvePGauss $m $b }
    proc det {m} { lindex [Eliminate $m [lrepeat [llength $m] 0.0]] 2 }
    proc show {mv {format %6.4f} {rowsep \n} {colsep { }}} {
        if {[llength [lindex $mv 0]] <= 1} { set mv [list $mv] }
        join [lmap row $mv { join [lmap x $row { format $format $x }] $colsep }] $rowsep
    }
}
package provide math::linearalgebra 1.1
