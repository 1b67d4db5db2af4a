proc

proc f

proc f {a b} {return $a$b}

f 1 2

f 1

f 1 2 3

proc f {a {b 5} args} {list $a $b $args}; list [f 1] [f 1 2] [f 1 2 3 4]

f

proc f {} {return x}; f 1

proc f args {llength $args}; f 1 2 3

proc f {{a 1} b} {list $a $b}; f 5

proc f {{a 1} b} {list $a $b}; f 5 6

proc f {a b {c 3} args} {}; f

proc f {a args b} {list $a $args $b}; f 1 2 3

f 1 2

proc f {{a b c}} {}

proc f {{}} {}

proc f {a(1)} {}

proc f {a::b} {}

proc f "a \{" {}

proc f {a a} {set a}; f 1 2

proc nons::f {} {}

proc ::g {} {return g}; g

proc {a b} {x} {return $x}; {a b} 5

{a b}

proc f {} {return -code error oops}; f

proc f {} {return -code error -errorcode {A B} oops}; f

proc f {} {return -code break}; foreach i {1 2} {f}; set i

proc f {} {return -code continue}; foreach i {1 2} {f; set i 9}; set i

proc f {} {return -code return val}; proc g {} {f; return no}; g

proc f {} {return -code 7 val}; catch f m; list [catch f] $m

proc f {} {return -code ok fine}; f

proc f {} {return -code foo x}; f

proc f {} {return -level 2 x}; proc g {} {f; return no}; g

proc f {} {return -level 0 x; return y}; f

return -level -1 x

return -level x y

proc f {} {return -options {-code error} msg}; f

proc f {} {return -options foo msg}; f

proc f {} {return -errorcode {X Y} -code error msg}; catch f; set errorCode

return

return 5

return a b c

break

continue

proc f {} {break}; f

proc f {} {continue}; f

proc f {} {error boom}; catch f; set errorInfo

proc f {} {
    set a 1
    error boom
}
catch f; set errorInfo

proc f {} {g2}; proc g2 {} {nosuch}; catch f; set errorInfo

proc f x {upvar $x y; set y 5}; f zz; set zz

proc f x {upvar 1 $x y; incr y}; set zz 1; f zz; set zz

proc f {} {upvar #0 zz y; set y 7}; f; set zz

proc f {} {upvar 5 a b}; f

proc f {} {upvar #5 a b}; f

proc f {} {upvar foo a b}; f

proc f {} {upvar a}; f

proc f {} {upvar}; f

proc f {} {upvar 1 a}; f

proc f {} {upvar 1 arr(x) y; set y 3}; f; set arr(x)

proc f {} {upvar 1 a b(x)}; f

proc f {} {set b 1; upvar 1 a b}; f

proc f {} {upvar 1 a b; upvar 1 c b; set b 9}; f; set c

proc f {} {upvar 0 x x}; f

proc f {} {set x 1; upvar 0 x y; incr y; set x}; f

proc f {} {upvar nosuchv v; info exists v}; f

proc f {} {upvar nosuchv v; set v}; f

proc f {} {upvar nosuchv v; unset v}; f

set qq 1; proc f {} {upvar qq v; unset v}; f; info exists qq

proc f {} {global zz; incr zz}; set zz 1; f; set zz

proc f {} {global nosuchg; info exists nosuchg}; f

proc f {} {global g1 g2; set g1 1; set g2 2}; f; list $g1 $g2

proc f {} {set loc 1; global loc}; f

global

global x y

proc f {} {global ns::v; set v 1}; namespace eval ns {variable v 0}; f; set ns::v

proc f {} {global a(1)}; f

proc f {} {uplevel {set up 5}}; f; set up

proc f {} {uplevel 1 set up 6}; f; set up

proc f {} {uplevel #0 {set up 7}}; f; set up

proc f {} {uplevel 1 {return 5}; return 6}; proc g {} {f; return 7}; g

proc f {} {uplevel 9 {set x}}; f

uplevel

uplevel 1 {set x}

uplevel #0 {set zz}

uplevel 0 {set zz}

proc f {} {uplevel 1 error boom}; f

proc f {} {uplevel 1 {break}}; foreach i {1 2 3} {f}; set i

info level

info level 0

proc f {} {info level}; f

proc f {} {info level 0}; f

proc f args {info level 0}; f a {b c}

proc f {} {info level 1}; proc g {} {f}; g

proc f {} {info level -1}; proc g x {f}; g 5

proc f {} {info level 5}; f

proc f {} {info level -5}; f

proc f {} {info level x}; f

proc f {} {expr {[info level] > 3 ? "deep" : [f]}}; f

apply {x {expr {$x*2}}} 5

apply {{x {y 2}} {expr {$x*$y}}} 5

apply {{x y} {}} 5

apply {x} 5

apply {a b c d} 1

apply

apply "a \{"

apply {{} {namespace current} ::nsx}

namespace eval nsx {variable q 5}; apply {{} {variable q; set q} ::nsx}

apply {{} {error boom}}

apply {args {llength $args}} 1 2 3

apply {x {return -code error $x}} foo

rename f ff; ff

rename nosuch x

rename ff g

rename ff ""; info commands ff

rename

rename a b c

proc tmp {} {return 1}; rename tmp ns::tmp; ns::tmp

rename nosuch ""

proc tmp {} {return old}; rename tmp tmp_old; proc tmp {} {return new-[tmp_old]}; tmp

rename puts _puts; proc puts args {_puts "P:$args"}; puts hi; rename puts ""; rename _puts puts

rename set _set; _set x 5; rename _set set; set x

proc fact n {expr {$n < 2 ? 1 : $n * [fact [expr {$n-1}]]}}; fact 30

proc fib n {if {$n < 2} {return $n}; return [expr {[fib [expr {$n-1}]] + [fib [expr {$n-2}]]}]}; fib 15

proc inf {} {inf}; inf

proc inf n {return [inf [expr {$n+1}]]}; inf 1

proc inf {} {eval inf}; inf

proc inf {} {uplevel 1 inf}; inf

proc inf {} {if 1 {foreach x {1} {inf}}}; inf

proc deep n {if {$n == 0} {return done}; deep [expr {$n-1}]}; deep 900

proc f {} {tailcall g9 5}; proc g9 x {return <$x>}; f

proc f n {if {$n == 0} {return ok}; tailcall f [expr {$n-1}]}; f 5

tailcall foo

proc f {a} {set a}; info args f

info args nosuch

info body f

info body nosuch

info default f a d

proc f {{a 5} b} {}; list [info default f a d] $d [info default f b d] $d

info default f zz d

info default nosuch a d

info args

info procs f

info procs nosuch

proc f {x} {set y 1; global zz; lsort [info locals]}; f 1

proc f {x} {set y 1; global zz; lsort [info vars]}; f 1

proc f {} {info locals z*}; f

info locals

proc f {} {info exists x}; f

proc f {} {set x 1; unset x; info exists x}; f

proc f {} {catch {set x [nosuch]}; info exists x}; f

proc repeat {n body} {for {set i 0} {$i < $n} {incr i} {uplevel 1 $body}}; set acc 0; repeat 5 {incr acc 3}; set acc

proc f {x} {return [expr {$x > 5 ? "big" : "small"}]}; list [f 3] [f 10]

proc f {} {return}; f

proc f {} {}; f

proc f {} {set x 5}; f

proc f {} {if 0 {set x 5}}; f

proc f {x} {set x}; f "a b"

proc outer {} {proc inner {} {return in}; inner}; outer

inner

proc unknown args {return "unk: $args"}; nosuchcmd a b

rename unknown ""; nosuchcmd a b

proc vf {name args} {upvar 1 $name n; foreach a $args {lappend n $a}; return [llength $n]}; unset -nocomplain zl; vf zl a b c; set zl

proc f {{x {}}} {list $x}; f

proc f "x {y {default value}}" {list $x $y}; f 1

proc f {x
y} {list $x $y}; f 1 2

catch {f 1 2 3} m; set m

proc "sp ace" {a} {}; catch {"sp ace"} m; set m

set cmd "set x"; $cmd 5

set cmd {set x}; {*}$cmd 5

set c set; $c x 9

[list set] x 10

eval set x 11

eval {set x} 12

eval [list set x {a b}]

eval "set x 1; set y 2"

eval

eval {}

eval error boom

eval {break}

set x [eval {set y 5}]

unset -nocomplain x; set x $x

proc p {a b} {return [expr {$a+$b}]}; p [p 1 2] [p 3 4]

proc sum args {set s 0; foreach a $args {set s [expr {$s+$a}]}; return $s}; sum 1 2 3.5

time {set x 1} 0

time {error foo}

time

time {set x} x

lindex [time {set x 1} 10] 1

lrange [time {set x 1}] 1 end
