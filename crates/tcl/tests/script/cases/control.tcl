if

if 1

if 1 then

if 1 {set r a}

if 0 {set r a}

if 0 {set r a} else {set r b}

if 0 {set r a} {set r b}

if 0 then {set r a} elseif 1 then {set r c} else {set r b}

if 0 {} elseif

if 0 {} elseif 1

if 0 {} else

if 1 {} else

if 0 {} else {} {}

if 1 {} else {} {}

if abc {}

if {abc} {}

if {"abc"} {}

if {""} {}

if {1 +} {}

if {$nosuch} {}

if true {set r 5}

if yes {set r 6} else {set r 7}

if {off} {set r 6} else {set r 7}

if 1.5 {set r 8}

if 0x0 {set r 8}

if "1 > 0" {set r 9}

if {1 > 0} "set r 10"

if 1 break

if 1 {error boom}

if {[catch {error x}]} {set r caught}

if 0 {} else if 1 {}

while

while 1

while {$i < 5} {incr i} x

set i 0; while {$i < 5} {incr i}; set i

set i 0; while 1 {incr i; if {$i > 3} break}; set i

set i 0; set r {}; while {$i < 5} {incr i; if {$i == 3} continue; lappend r $i}; set r

while {abc} {}

while {1 +} {}

while 0 {}

while {1} {error boom}

while {1} {return 5}

set i 0; while {[incr i] < 5} {}; set i

set i 0; while "$i < 1" {incr i; if {$i > 10} break}; set i

for

for {} {} {}

for {set i 0} {$i < 3} {incr i} {append fr $i}; set fr

for {set i 0} {$i < 3} {incr i} {if {$i == 1} continue; append fs $i}; set fs

for {set i 0} {$i < 3} {incr i} {if {$i == 1} break}; set i

for {set i 0} {1} {incr i; if {$i > 3} break} {}; set i

for {set i 0} {1} {incr i; if {$i > 3} continue} {if {$i > 5} break}; set i

for {set i 0; set j 10} {$i < $j} {incr i; incr j -1} {}; list $i $j

for {error a} {1} {} {}

for {} {error} {} {}

for {} {[error b]} {} {}

for {} 1 {error c} {}

for {} 1 {} {error d}

for {} 0 {} {}

for {set x 0} {$x < 1} {set x [expr {$x+0.1}]} {}; set x

foreach x {a b c} {append fe $x}; set fe

foreach x {} {error no}

switch

switch a

switch a {}

switch a a

switch a a {set r 1}

switch a b {set r 1} default {set r 2}

switch a {a {set r 3} b {set r 4}}

switch c {a {set r 3} default {set r 4}}

switch c {a {set r 3} b {set r 4}}

switch a {a - b {set r 5} default {set r 6}}

switch a {a - b -}

switch a {a - b}

switch a {a {set r 1} b}

switch a {a {set r 1} # comment
 b {set r 2}}

switch -exact a a {set r 7}

switch -glob abc a* {set r 8}

switch -glob abc {b* {set r 1} *c {set r 9}}

switch -regexp abc {^a.c$ {set r 10}}

switch -nocase A a {set r 11}

switch -glob -nocase ABC a* {set r 12}

switch -exact -glob a a {}

switch -foo a a {}

switch -- -a -a {set r 13}

switch -a {-a {set r 14}}

switch -exact -- a {a {set r 15}}

switch -matchvar m a a {}

switch -matchvar

switch -regexp -matchvar m xay {a(y) {set m}}

switch a {default {set r 16}}

switch a {default {set r 16} a {set r 17}}

switch default {default {set r 18}}

switch "a b" {"a b" {set r 19}}

switch 1 {1.0 {set r 20} 1 {set r 21}}

switch a {a {error boom}}

switch a {a {break}}

foreach x {1 2 3} {switch $x {2 break}}; set x

switch a {a "set r 22"}

switch a [list a {set r 23}]

switch [set q a] a {set r 24}

switch a "a {set r 25}"

switch a "\{a"

switch {} {{} {set r empty}}

switch -regexp -- foo {(f)(o) {set r 1} x}

catch

catch {set x 5}

catch {set x 5} r; set r

catch {error boom} r; set r

catch {error boom} r o; list $r [dict get $o -code] [dict get $o -level] [dict get $o -errorcode]

catch {return 5} r o; list $r [dict get $o -code] [dict get $o -level]

catch {break} r o; dict get $o -code

catch {continue}

catch {return -code 5 x} r; set r

catch {return -code error x} r; set r

catch {return -level 0 -code 7 x} r; set r

catch {return -level 0 -code break} r

catch {set x 1} r o; dict get $o -code

catch {nosuch a} r o; dict get $o -errorinfo

catch {expr {1/0}} r o; dict get $o -errorcode

catch {error a b c} r o; list [dict get $o -errorinfo] [dict get $o -errorcode]

catch {error a "" c} r o; list [dict get $o -errorinfo] [dict get $o -errorcode]

catch {} r o; dict get $o -level

catch a b c d

catch {catch {error x} a; set a} b; set b

catch {set nosuch} ; set errorInfo

catch {set x [error inner]} m; set m

catch "set x \{" m; set m

catch {set x "abc} m; set m

catch {set x {a}b} m; set m

catch {set x "a"b} m; set m

catch "set x \[foo" m; set m

catch {set x $a(} m; set m

catch {set x ${abc} m; set m

catch {error [list a b]} m; set m

catch {error} m; set m

catch {error a b c d} m; set m

catch {error {}} m; list $m

error boom

error boom info

error boom info {CODE 1}

error "multi
line"

catch {error msg "custom info" MYCODE}; list $errorInfo $errorCode

throw

throw A

throw A msg

throw {A B} msg

throw {} msg

catch {throw {X Y} msg} r o; dict get $o -errorcode

try

try {set x 5}

try {error boom}

try {error boom} on error {m} {set r "got $m"}

try {error boom} on error {m o} {dict get $o -errorcode}

try {set x 5} on ok {v} {expr {$v*2}}

try {return 7} on return {v} {set r "ret $v"}

try {break} on break {} {set r brk}

try {continue} on continue {} {set r cont}

try {return -level 0 -code 9 x} on 9 {v} {set r "nine $v"}

try {throw {A B C} msg} trap {A B} {m} {set r "trapped $m"}

try {throw {A B C} msg} trap {A X} {m} {set r no} on error {m} {set r "err $m"}

try {throw {A B C} msg} trap {} {m} {set r "any $m"}

try {error boom} finally {set fin 1}

catch {try {error boom} finally {set fin 2}}; set fin

try {set x 1} finally {set fin 3}; set fin

try {set x 1} finally {error infin}

try {error a} on error {} {error b}

try {error a} on error {} {error b} finally {set fin 4}

catch {try {error a} on error {} {error b}} m o; dict exists $o -during

try {error a} on error {} - on ok {} {set r dash}

try {error a} on error {} -

try {set x 1} on foo {} {}

try {set x 1} on

try {set x 1} on ok

try {set x 1} on ok {}

try {set x 1} trap

try {set x 1} finally

try {set x 1} finally {} on ok {} {}

try {set x 1} foo

try {set x 1} on error {} {} finally

try {error boom} on error {m o x} {}

try {expr {1/0}} trap {ARITH DIVZERO} {m} {set m}

try {expr {1/0}} trap {ARITH} {m} {set m}

try {set nosuch} trap {TCL} {m} {set m}

try {nosuch} trap {TCL LOOKUP} {m} {set m}

foreach i {1 2 3} {try {if {$i == 2} break} finally {lappend tf $i}}; set tf

foreach i {1 2 3} {try {if {$i == 2} continue; lappend tg $i} finally {lappend tg f$i}}; set tg

proc tp {} {try {return a} finally {set ::side 1}}; tp

proc tp {} {try {error a} on error {} {return handled}}; tp

proc tp {} {try {return a} on return {v} {return -code error no}}; tp

try {try {error inner} finally {set q 1}} on error {m} {set r "outer $m"}

try {} on ok {a b} {list $a [dict get $b -code]}

try {error x} on error {} {}

try {error x} trap "a \{" {} {}

set x 5;# comment

set x 5 ;# comment

# comment only

# comment \
 continued
set x 6

set x 7 # not comment

if 1 {
  # comment with brace \{
  set x 8
}

if 1 {
  set x 9 ;# trailing
}

set x "a # b"

set x {a
b}

set x a\
b

set x "a\
   b"

set x {a\
   b}

set    x     5

set	x	5

set x 5;

;;; set x 5 ;;;

set x \n

set x "\n"

set x \x41\u0042\103

set x \

set x a\ b

set x a\;b

set x \$y

set x \[a\]

set x "\{"

set x \{

set x }

set x ]

set x a]b

set x a}b

set x a{b

set x a"b

set x $x$x

set x [set x][set x]

set x "[set x]"

set x {[set x]}

set y [list a [list b [list c]]]

set y "a[list b "c d"]e"

set y [list "a]b"]

set y [list {a]b}]

set y "[list "]"]"

set y [set x 1
set x 2]

set y [# comment
set x 3]

set y "$x(a)"

set z(a) 1; set y "$z(a)b"

set z(a b) 2; set y "$z(a b)"

set i a; set y $z($i)

set z(1,2) 3; set a 1; set b 2; set y $z($a,$b)

set y $z([set i])

set y "$z([lindex {a b} 0])"

set y ${z(a)}

set y ${z}

set y $::z(a)

set y $nosuch::x

set y $z(nosuch)

set y "$"

set y "a$"

set y "$ a"

set y $-

set y a$.b

set y "${x}y"

set y "$x:y"

set y "$x::y"

set y "$::x:"

set {a b} c; set y ${a b}

set "q w" 1; set y "${q w}x"

set abc 5; set y "$abc."

set y "[expr {1+1}]px"

set y [expr 1+1]px

set y a[set x 4]b[set x 5]c

list [list] {} ""

list \{ \} \[ \] \" \\ \$ \;

list a;list b

list "a;b"

list {a;b}

list a\nb

list a\tb "a\tb" {a\tb}

list {a\{b} {a\\b}

list {a {b c} d}

list {*}{a b}c

list {*}"a b" {*}{c d}

list {*}[list a b]c

list {*}

list {*} a

list {}*

list {a}b

list "a"b

nosuchcommand

nosuchcommand a b

::nosuch::cmd

"" a

{} a

[]

[list set] x 1

$nosuch

set x [nosuch]

set x [

set x "abc

set x {abc

set x [list a

set x $y(

set x ${y

set x "[list a"

set x {a {b c}

{set} x 5

"set" x 5

set {x} {5}

s\et x 5

se[list t] x 5

set set set; $set x 7

info complete "set x \{"

info complete "set x {}"

info complete "set x \""

info complete "set x \["

info complete "set x \\"

info complete {}

info complete "a b; c \[d\]"

info complete "# \{"

subst {a $x [set x] \n}

subst -nobackslashes {a $x \n}

subst -nocommands {a $x [set x]}

subst -novariables {a $x [set x]}

subst -nobackslashes -nocommands -novariables {a $x [y] \n}

subst {a [break] b}

subst {a [continue] b}

subst {a [return x] b}

subst {a [error x] b}

subst {a $nosuch}

subst {a [nosuch]}

subst {a [set x}

subst {$z(a) ${x}}

subst "a\\"

subst {$}

subst

subst -foo a

subst a b

subst {\x41 \u42 \103}

subst -novariables {$x\$x}

subst {[list a b][list c]}

subst {"$x"}

subst {{$x}}

subst {a # b}

subst {$x; $x}

lindex [split "a b" { }] 1

update

update idletasks

update foo

after 0

after

after abc

if 1 {set a 1} elseif

if 1 {set a 1} elseif 1

if 1 {set a 1} foo bar

if 1 {set a 1} elseif 1 then

if 1 {set a 1} elseif 0 {} foo bar

if {[set zz 1]} then {set zz 2} elseif {[set zz 3]} then {set zz 4} else {set zz 5}
