list

list a {b c} {} "d e" \{ \} \" "a\"b" \\ {a\b} "a\nb" {$x} {[y]} {;} #x a#

list #a #b

list "a\nb\{" "x\ty\}" "a\\\nb" {a;b} "\[" "a\]\{b" "{a}b" "a{b}c" "{a b}" "a]b" "a\"b c"

list a\\ {a b\\} "\\" "\}" "a\}b" "\{\}" "{}" "{ }"

llength {a b c}

llength {a {b c} d}

llength "a \{b"

llength {a "b c" d}

llength {a "b c"d}

llength {a {b c}d}

llength {"a b}

llength

llength a b

lindex {a b c} 0

lindex {a b c} end

lindex {a b c} end-1

lindex {a b c} end-5

lindex {a b c} 5

lindex {a b c} -1

lindex {a b c} 1+1

lindex {a b c} 2-1

lindex {a b c} end+1

lindex {a b c} x

lindex {a b c} end-x

lindex {a b c} 1.5

lindex {a b c} ""

lindex {a b c} {}

lindex {a b c}

lindex {a {b c} d} 1 0

lindex {a {b c} d} {1 0}

lindex {a {b c} d} 1 0 0

lindex {a {b {c d}} e} 1 1 0

lindex {a b c} 1 x

lindex {a b c} 9 x

lindex {a b c} {0 x}

lindex {a b c} {9 x}

lindex

lindex {a b c} 08

lindex {a b c} 0x1

lindex {a b c} " 1"

lindex {a b c} "1 "

lindex {a b c} end--1

lindex {a b c} end-+1

lindex {a b c} 1++1

lindex {a b c} 99999999999999999999

lindex {a b c} -99999999999999999999

lindex {a b c} e

lindex {a b c} en

lindex {a b c} end-

lindex {a b c} 1+

lrange {a b c d} 1 2

lrange {a b c d} 0 end

lrange {a b c d} 2 1

lrange {a b c d} -3 1

lrange {a b c d} 2 99

lrange {a b c d} end-1 end

lrange {a b c d} x 1

lrange {a b c d} 1 x

lrange {a b c d} 1

lrange { a   b  c } 0 end

lrange {a {b c} "d e"} 0 end

linsert {a b c} 0 x

linsert {a b c} end x y

linsert {a b c} end-1 x

linsert {a b c} 99 x

linsert {a b c} -5 x

linsert {a b c} 1

linsert {a b c}

linsert {a b c} foo x

linsert {} 0 a b

lreplace {a b c d} 1 2

lreplace {a b c d} 1 2 x y z

lreplace {a b c d} 2 1 x

lreplace {a b c d} 0 0

lreplace {a b c d} end end z

lreplace {a b c d} 10 12 z

lreplace {a b c d} -1 -1 z

lreplace {a b c d} -5 1 z

lreplace {} 0 0 z

lreplace {a b c d} 1 99

lreplace {a b c} x 1

lreplace {a b c} 1

lreverse {a b c}

lreverse {}

lreverse {a {b c}}

lreverse

lrepeat 3 a

lrepeat 2 a b

lrepeat 0 a

lrepeat -1 a

lrepeat x a

lrepeat 3

lrepeat

concat a b {c d} {} {e  f}

concat

concat " a b " c

concat {a b} [list c d]

concat {} {}

concat "a\\ " b

concat a\\

concat [list a b] [list c {d e}]

join {a b c}

join {a b c} ,

join {a {b c} d} ,

join {} ,

join {a} ,

join "a \{b" ,

join

join a b c

split "a b c"

split "a,b,,c" ,

split ",a," ,

split "abc" ""

split "" ,

split "a b\tc\nd"

split "a,b;c" ",;"

split "a--b" "-"

split "aéb" é

split "a b" xyz

split

split a b c

set l {a b c}; lset l 1 X

set l {a b c}; lset l end X; set l

set l {a {b c} d}; lset l 1 0 X

set l {a {b c} d}; lset l {1 1} X

set l {a b c}; lset l 3 X

set l {a b c}; lset l 4 X

set l {a b c}; lset l -1 X

set l {a b c}; lset l {} {x y}

set l {a b c}; lset l {x y}

set l {a b c}; lset l foo X

set l {a b c}; lset l 0 0 X

set l {a b c}; lset l 0 1 X

set l {a b c}; lset l end+1 X

lset nosuch 0 x

lset

lset l

set l {a b c}; lset l 9 9 X

lassign {a b c} x y; list $x $y

lassign {a b c} x y z w; list $x $y $z $w

lassign {a b c} x

lassign {}  x

lassign {a b}

lassign

lassign "a \{" x

unset -nocomplain ll; lappend ll

unset -nocomplain ll; lappend ll a b; lappend ll {c d}

set ll "a \{b"; lappend ll c

set ll a; lappend ll

set ll "  a   b "; lappend ll c

lappend

lmap x {1 2 3} {expr {$x*2}}

lmap {a b} {1 2 3 4} {expr {$a+$b}}

lmap a {1 2 3} b {x y z} {list $a $b}

lmap x {1 2 3 4} {if {$x==2} continue; if {$x==4} break; set x}

lmap x {1 2} {error boom}

lmap x

lmap {} {1 2} {}

lsort {b a c}

lsort {B a C}

lsort -nocase {B a C b A}

lsort -decreasing {b a c}

lsort -integer {10 9 -1 0x10}

lsort -integer {10 a}

lsort -integer {10 1.5}

lsort -real {1.5 1e3 -2 0x10}

lsort -real {1.5 abc}

lsort -dictionary {a10 a2 A1 a1 b}

lsort -dictionary {x10 x9 x010 x09 X9}

lsort -dictionary {a B A b}

lsort -dictionary {1.10 1.9 1.1 01.1}

lsort -unique {b a b a c}

lsort -unique -nocase {b B a A}

lsort -unique -integer {1 01 0x1 2}

lsort -index 1 {{a 3} {b 1} {c 2}}

lsort -index end {{a 3} {b 1} {c 2}}

lsort -index {1 0} {{a {3 x}} {b {1 y}}}

lsort -index 1 -integer {{a 10} {b 9}}

lsort -index 2 {{a 3} {b 1}}

lsort -index end-2 {{a 3} {b 1}}

lsort -index x {{a 3} {b 1}}

lsort -indices {c a b}

lsort -indices -decreasing -integer {3 1 2}

lsort -stride 2 {c 3 a 1 b 2}

lsort -stride 2 -index 1 -integer {c 3 a 1 b 2}

lsort -stride 2 {a b c}

lsort -stride 1 {a b c}

lsort -stride 2 -index 2 {a b c d}

lsort -stride 2 -indices {c 3 a 1 b 2}

lsort -stride x {a b}

proc cmp {a b} {expr {$a < $b ? -1 : $a > $b}}; lsort -command cmp {3 1 2}

lsort -command {string compare} {c a b}

lsort -command foo {c a b}

lsort -command {list x} {c a b}

lsort -decreasing -command cmp {3 1 2}

lsort -unique -command cmp {3 1 2 1 3}

lsort

lsort -foo {a}

lsort a b

lsort -index

lsort -command {a}

lsort -in {a}

lsort -increasing {c b a}

lsort -ascii {10 9}

lsort "a \{"

lsort {{b c} a {a b}}

lsort -stride 3 -index {2 0} {a b {z y} c d {y z}}

lsort -real {NaN 1}

lsort -integer {9223372036854775808 1}

lsort -dictionary -nocase {B a}

lsort -decreasing {a1 a1 b}

lsort -index 0 -decreasing {{a 1} {b 2} {a 3} {b 4}}

lsort -index 0 -unique {{a 1} {b 2} {a 3} {b 4}}

lsearch {a b c} b

lsearch {a b c} z

lsearch -exact {a* a} a

lsearch -glob {foo bar} b*

lsearch {foo bar} b*

lsearch -regexp {foo bar} {^b}

lsearch -regexp {foo bar} {(}

lsearch -all {a b a} a

lsearch -all -inline {ab cd ae} a*

lsearch -inline {ab cd} c*

lsearch -inline {ab cd} x*

lsearch -not {a a b} a

lsearch -all -not {a a b} a

lsearch -start 1 {a b a} a

lsearch -start end {a b a} a

lsearch -start 5 {a b a} a

lsearch -start 5 -all {a b a} a

lsearch -start x {a} a

lsearch -start

lsearch -integer {1 02 3} 2

lsearch -integer -exact {1 02 3} 2

lsearch -exact -integer {1 x 3} 3

lsearch -exact -integer {1 2 3} x

lsearch -real -exact {1 2.0 3} 2

lsearch -nocase {A b} B

lsearch -nocase -exact {A b} a

lsearch -sorted {a b c} b

lsearch -sorted -integer {1 5 9} 5

lsearch -sorted -integer {1 5 9} 6

lsearch -sorted -decreasing -integer {9 5 1} 5

lsearch -bisect -integer {1 5 9} 6

lsearch -bisect -integer {1 5 9} 0

lsearch -bisect -integer {1 5 5 9} 5

lsearch -bisect -all {a} a

lsearch -index 1 {{a 1} {b 2}} 2

lsearch -index {1 0} {{a {1 2}} {b {3 4}}} 3

lsearch -index 1 -inline {{a 1} {b 2}} 2

lsearch -index 1 -subindices {{a 1} {b 2}} 2

lsearch -index 1 -subindices -inline {{a 1} {b 2}} 2

lsearch -subindices {a} a

lsearch -index 5 {{a 1}} x

lsearch -index

lsearch

lsearch a

lsearch -foo {a} a

lsearch -dictionary -exact {a10 A2} a2

lsearch -all -index 0 {{a 1} {b 2} {a 3}} a

lsearch -all -inline -not {a b c} b

lsearch {} a

lsearch -inline {} a

lsearch -all {} a

lsearch {{a b} c} {a b}

lsearch -sorted -all -integer {1 2 2 3} 2

foreach {a b} {1 2 3} {}; list $a $b

foreach a {1 2} b {x y z} {append r $a$b,}; set r

foreach {} {1 2} {}

foreach a

foreach a b c d

foreach a "x \{" {}

foreach {x y} {1 2 3 4} {append q $x-$y,}; set q

foreach x {1 2 3} {if {$x == 2} break}; set x
