set l {}; expr {srand(1)}; for {set i 0} {$i < 5000} {incr i} {lappend l [expr {rand()}]}; lrange [lsort -real $l] 0 5

for {set i 0} {$i < 3000} {incr i} {set a([expr {$i*7919 % 10007}]) $i}; lrange [array names a] 0 20

lrange [array get a] 0 20

set n 0; set t [string repeat "foo=12, bar=34.5; baz = 'q' \n" 200]; foreach {m k v} [regexp -all -inline {(\w+)\s*=\s*([^,;\n]+)} $t] {incr n [string length $k$v]}; set n

set p {}; for {set i 2} {[llength $p] < 300} {incr i} {set ok 1; foreach q $p {if {$q*$q > $i} break; if {$i % $q == 0} {set ok 0; break}}; if {$ok} {lappend p $i}}; lindex $p end

foreach w [split "the quick brown fox jumps over the lazy dog the end"] {dict incr c $w}; set c

proc h {n a b c} {if {$n == 0} {return 0}; expr {[h [expr {$n-1}] $a $c $b] + 1 + [h [expr {$n-1}] $c $b $a]}}; h 10 a b c

set best 0; for {set i 1} {$i < 2000} {incr i} {set n $i; set k 0; while {$n != 1} {set n [expr {$n % 2 ? 3*$n+1 : $n/2}]; incr k}; if {$k > $best} {set best $k; set bi $i}}; list $bi $best

set x 1; for {set i 1} {$i <= 200} {incr i} {set x [expr {$x*$i}]}; set x

set r {}; for {set i -5} {$i < 25} {incr i} {lappend r [expr {10.0**$i/3}]}; set r

set r {}; for {set i 0} {$i < 40} {incr i} {lappend r [format %g|%e|%.3f|%10.4g [expr {exp($i-20)}] [expr {exp($i-20)}] [expr {exp(($i-20)/4.)}] [expr {-exp($i-20)}]]}; set r

proc sieve n {set l [lrepeat [expr {$n+1}] 1]; for {set i 2} {$i*$i <= $n} {incr i} {if {[lindex $l $i]} {for {set j [expr {$i*$i}]} {$j <= $n} {incr j $i} {lset l $j 0}}}; set r {}; for {set i 2} {$i <= $n} {incr i} {if {[lindex $l $i]} {lappend r $i}}; set r}
sieve 100

proc qsort l {if {[llength $l] < 2} {return $l}; set p [lindex $l 0]; set a {}; set b {}; foreach x [lrange $l 1 end] {if {$x < $p} {lappend a $x} else {lappend b $x}}; concat [qsort $a] [list $p] [qsort $b]}
qsort {3 1 4 1 5 9 2 6 5 3 5}

proc gauss {A b} {
    set n [llength $b]
    for {set k 0} {$k < $n} {incr k} {
        for {set i [expr {$k+1}]} {$i < $n} {incr i} {
            set m [expr {double([lindex $A $i $k])/[lindex $A $k $k]}]
            for {set j $k} {$j < $n} {incr j} {
                lset A $i $j [expr {[lindex $A $i $j]-$m*[lindex $A $k $j]}]
            }
            lset b $i [expr {[lindex $b $i]-$m*[lindex $b $k]}]
        }
    }
    for {set i [expr {$n-1}]} {$i >= 0} {incr i -1} {
        set s [lindex $b $i]
        for {set j [expr {$i+1}]} {$j < $n} {incr j} {set s [expr {$s-[lindex $A $i $j]*$x($j)}]}
        set x($i) [expr {$s/[lindex $A $i $i]}]
    }
    set r {}
    for {set i 0} {$i < $n} {incr i} {lappend r $x($i)}
    return $r
}
gauss {{4 1 2} {1 5 3} {2 3 6}} {1 2 3}

set text {# section table
W14x90  26.5  999.0
W21x50  14.7  984.0   # comment
W8x31   9.13  110.0}
foreach line [split $text \n] {
    regsub {#.*} $line {} line
    if {[string trim $line] eq ""} continue
    lassign $line name A I
    set sec($name) [list A $A I $I]
}
set r {}
foreach name [lsort -dictionary [array names sec]] {lappend r [format "%-8s %6.2f %8.1f" $name [dict get $sec($name) A] [dict get $sec($name) I]]}
join $r |

proc memo {n} {global M; if {[info exists M($n)]} {return $M($n)}; set M($n) [expr {$n < 2 ? $n : [memo [expr {$n-1}]] + [memo [expr {$n-2}]]}]}
memo 80

namespace eval stack {variable s {}; proc push x {variable s; lappend s $x; llength $s}; proc pop {} {variable s; set x [lindex $s end]; set s [lrange $s 0 end-1]; set x}; namespace export *; namespace ensemble create}
stack push a; stack push b; list [stack pop] [stack pop] [catch {stack peek} m] $m

set fp [open motion.txt w]; for {set i 0} {$i < 20} {incr i} {puts -nonewline $fp [format "%15.7E" [expr {sin($i*0.3)*0.35}]]; if {$i % 5 == 4} {puts $fp ""}}; close $fp
set fp [open motion.txt]; set peak 0; set n 0; while {[gets $fp line] >= 0} {foreach v $line {incr n; if {abs($v) > abs($peak)} {set peak $v}}}; close $fp; list $n $peak
