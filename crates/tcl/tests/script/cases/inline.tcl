set r {}; for {set i 0} {$i < 3} {incr i} { lappend r [expr {$i * 2}] }; list $r $i

proc inl_set args {return mine}; set r {}; for {set i 0} {$i < 4} {incr i} { if {$i == 2} {rename lappend inl_la; proc lappend args {return [llength $args]}}; lappend r $i }; rename lappend {}; rename inl_la lappend; list $r [lappend r z]

namespace eval inlns { proc if args {return "own if"}; proc go {} { if {1} {error no} } }; list [inlns::go] [if {1} {set a b}]

namespace eval inlq { proc llength x {return 99}; proc go {} { set x {a b}; for {set i 0} {$i<3} {incr i} {set n [expr {[llength $x] + 1}]}; set n } }; list [inlq::go] [inlq::go]

proc f {} { for {set i 0} {$i < 3} {incr i} { set v [expr {[llength {a b c}] + [string length abcd] + [lindex {5 6 7} $i]}] }; set v }; list [f] [f]

proc f {l} { set s 0; for {set i 0} {$i < [llength $l]} {incr i} { set s [expr {$s + [lindex $l $i]}] }; set s }; list [f {1 2 3}] [f {1.5 2 0x10}] [f [list 1 2 [expr {1<<62}] 4611686018427387904]] [catch {f {1 a}} m] $m

proc f {l} { set s 0; foreach {a b} $l { incr s $a; if {$b eq ""} break; if {$b > 5} continue; incr s $b }; set s }; list [f {1 2 3 9 5}] [f {}] [f {1 6}]

proc f {} { foreach x {1 2 3} { foreach y {a b} { if {$x == 2} {return "$x$y"} } } }; f

foreach {} {1 2} {}

foreach x "{a" {}

foreach a(1) {1 2} {}; set a(1)

proc f n { set r {}; while 1 { if {[incr n -1] < 0} break; if {$n % 2} continue; lappend r $n }; set r }; list [f 7] [f 0]

proc f n { while {$n} { incr n -1; set k [expr {$n > 2 ? "many" : $n}] }; set k }; list [f 5] [f 5]

proc f x { if {$x < 0} then {set s neg} elseif {$x == 0} then {set s zero} else {set s pos}; set s }; list [f -1] [f 0] [f 1.5] [f 0.0] [f abc]

proc f x { if $x {return yes} {return no} }; list [f 1] [f 0] [f true] [f off] [catch {f maybe} m] $m

if {1} {set x 1} else

if {1} {set x 1} elseif

if {0} {set x 1} else {set x 2} more

if

if {0} {}

if {1} {}

if {"a" < "b"} {set x less}

while {1} {break} {extra}

for {set i 0} {$i < 2} {incr i} {error "at $i"}

for {set i 0} {$i < "x"} {incr i} {set q $i; if {$i > 3} break}

for {set i 0} {$i <} {incr i} {}

for {set i 0} {[bad]} {incr i} {}

for {error start} {1} {} {}

for {set i 0} {$i < 3} {error next} {set q $i}; set i

for {set i 0} {$i < 3} {break} {set q $i}; set i

for {set i 0} {$i < 3} {continue} {set q $i}

set x 5; while {$nosuch} {}

proc f {} { if {1} {error inner} }; catch f m o; list $m $::errorInfo

proc f {} { while 1 {expr {1 +}} }; catch f m o; list $m $::errorInfo

proc f {} { foreach x {1 2} { lappend y [expr {$x / 0}] } }; catch f m o; list $m $::errorInfo

proc f {} { set v [expr {$undefined + 1}] }; catch f m o; list $m $::errorInfo

proc f {} { return [lindex {a b} x] }; catch f m o; list $m $::errorInfo

proc f {} { incr s [expr {1.5}] }; catch f m o; set m

catch {if {1} { for {set i 0} {1} {incr i} {nosuchcommand $i}}} m; list $m $::errorInfo

proc f {} { upvar 1 v w; for {set i 0} {$i < 3} {incr i} { set w [expr {$w * 2}]; incr w; append t "$w," ; lappend l $w }; list $t $l }; set v 1; list [f] $v

proc f {} { global g; for {set i 0} {$i < 3} {incr i} { lappend g [expr {[llength $g] + $i}] }; set g }; set g {}; list [f] $g

proc f {} { for {set i 0} {$i < 3} {incr i} { unset -nocomplain k; set k [expr {$i + 0.5}]; lappend r $k; set j $k; unset k; if {[info exists k]} {lappend r bad} }; set r }; list [f] [f]

proc f {} { set a(1) 2; set a(x) 3.5; set k x; for {set i 0} {$i < 2} {incr i} { set s [expr {$a(1) + $a($k)}]; set a(1) [expr {$a(1) + 1}] }; list $s $a(1) }; list [f] [f] [catch {set a 1; expr {$a(1)}} m] $m

set a(1) 2; for {set i 0} {$i < 3} {incr i} { catch {expr {$a + 1}} m }; set m

proc f {} { set l {}; lappend l a; set m $l; lappend l b; append m " c"; list $l $m }; f

proc f {} { set l "a {b"; lappend l c }; f

proc f {} { set n 5; lappend n 6; append n 7; list $n [llength $n] [string length $n] }; f

proc f {} { set e {}; append e 1; append e 2; incr e; append e .5; set e [expr {$e + 1}] }; f

proc f {} { set x 9223372036854775807; for {set i 0} {$i < 2} {incr i} { set y [expr {$x + 1}]; set z [expr {-$x - 2}]; set p [expr {$x * 3}] }; incr x; list $x $y $z $p }; f

proc f {a b} { list [expr {$a < $b}] [expr {$a == $b}] [expr {$a % $b}] [expr {$a / $b}] [expr {$a ** $b}] }; list [f 7 2] [f 7 2] [f -7 2] [f 7 -2] [f -7 -2] [f 2 70] [f 3 0]

proc f {a b} { list [expr {$a < $b}] [expr {$a == $b}] [expr {$a / $b}] [expr {$a ** $b}] [expr {max($a, $b)}] [expr {min($a, $b, 3)}] }; list [f 7.5 2] [f 7.5 2] [f -0.0 0] [f 9007199254740993 9007199254740992.0] [f 1e308 10] [f 0.5 -0.5]

proc f x { list [expr {abs($x)}] [expr {int($x)}] [expr {round($x)}] [expr {double($x)}] [expr {sqrt(abs($x))}] [expr {pow($x, 2)}] [expr {hypot($x, 1)}] [expr {floor($x)}] [expr {!$x}] [expr {-$x}] [expr {+$x}] }; list [f 2] [f 2] [f -2.5] [f -2.5] [f 0] [f 1e20] [f -9223372036854775808]

proc f x { expr {sqrt($x)} }; list [f 4] [f 9.0] [catch {f -1} m] $m [catch {f -1} m] $m

proc f x { expr {log($x) + 1} }; list [catch {f 0} m] $m [catch {f 0} m] $m [catch {f -1} m] $m

proc f x { expr {$x / 0.0} }; list [f 1] [f 1] [f -1] [catch {f 0} m] $m

proc f {a b} { list [expr {$a && $b}] [expr {$a || $b}] [expr {$a ? $b : -1}] [expr {$a > 1 && $b > 1 || $a == 0}] }; list [f 1 0] [f 1 0] [f 0 2.5] [f 2 3] [f 0.0 0x1] [f yes no] [f true 2]

proc f {a} { expr {$a ? $a > 5 ? "big" : "small" : "none"} }; list [f 9] [f 9] [f 2] [f 0]

proc f {a} { expr {$a ? $a > 5 ? 100 : 10 : 1} }; list [f 9] [f 9] [f 2] [f 0]

proc f {a} { expr {$a == "1.0"} }; list [f 1] [f 1] [f 1.00] [f x]

proc f {a} { list [expr {$a eq 1}] [expr {$a ne "1"}] [expr {$a in {1 2}}] }; list [f 1] [f 1] [f 1.0] [f " 1"]

proc f {a} { list [expr {$a}] [expr {$a + 0}] [expr {"$a"}] }; list [f 0x1F] [f 0x1F] [f 010] [f 0o17] [f 1e3] [f " 7 "] [f 1_0]

proc f {} { set s 0; foreach v {1 2 3} { set s [expr {$s + $v}]; if {$v == 2} { proc ::tcl::mathfunc::sin x {return 42} }; lappend r [expr {sin(0)}] [expr {sin(0.0)}] }; set r }; set q [f]; rename ::tcl::mathfunc::sin {}; list $q [catch {expr {sin(0)}} m] $m

proc inl_tag n { set r {}; for {set i 8} {$i < $n} {incr i} { set tag "1$i"; lappend r $tag [expr {$tag + 1}] [string length $tag] "0$i" "-$i" [string length "-$i"] }; set r }; inl_tag 12

proc f {} { set x 0$::i; set y "[lindex {a b} 1]$::i"; list $x $y [string length $x] }; set i 7; f

set n 0; set r {}; while {[llength $r] < 3} { lappend r [incr n] }; set r

list [llength] 

string length

string length a b

lindex

list [lindex {a {b c}} 1 0] [lindex {a b} end] [lindex {a b} end-1] [lindex {a b} 5] [lindex {a b} -1] [lindex a] [lindex {a b} {}] [lindex {a b} 00001]

proc f {} { set l {a b c}; set k end; list [lindex $l $k] [lindex $l 1] [lindex $l [expr {0 + 1}]] [llength "$l d"] [string length "é$l"] }; list [f] [f]

llength "a {b"

set

set x 1 2

incr

incr x y z

incr nonexist_a; incr nonexist_b 3; list $nonexist_a $nonexist_b

set x abc; incr x

set x 5; incr x 1.5

append nonexist_c a b c; append nonexist_d "$x-" ; append nonexist_d "$x." ; list $nonexist_c $nonexist_d

lappend nonexist_e; lappend nonexist_e a b; lappend nonexist_f "$x y"; list $nonexist_e $nonexist_f

proc f {} { return }; list [f] [catch {return 5} m] $m

proc f {} { return -code error oops }; catch f m; set m

proc f {a a} { set a }; list [f 1 2]

proc f {a {b 5} args} { list $a $b $args }; list [f 1] [f 1 2] [f 1 2 3 4] [catch f m] $m

proc fib n { if {$n < 2} {return $n}; expr {[fib [expr {$n - 1}]] + [fib [expr {$n - 2}]]} }; fib 15

proc f n { set a 0; set b 1; while {$n > 0} { set t [expr {$a + $b}]; set a $b; set b $t; incr n -1 }; set a }; list [f 90] [f 100]

proc deep n { if {$n == 0} {error "deep down"}; deep [expr {$n - 1}]}; catch {deep 3} m; list $m $::errorInfo

set body {lappend r [expr {$i * $i}]}; set r {}; for {set i 0} {$i < 3} {incr i} $body; set r

set test {$i < 2}; set r {}; set i 0; while $test {lappend r $i; incr i; if {$i > 4} break}; set r
