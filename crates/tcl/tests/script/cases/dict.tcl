dict

dict foo

dict create

dict create a 1 b 2

dict create a

dict create a 1 b 2 a 3

dict get {a 1 b 2} a

dict get {a 1 b 2} c

dict get {a 1 b 2}

dict get {a 1 b 2 a 3}

dict get {a {b 1}} a b

dict get {a {b 1}} a c

dict get {a {b 1}} x c

dict get {a 1} a b

dict get {a} a

dict get "a \{" a

dict get {a 1 {b c}d 2} a

dict get

dict exists {a 1} a

dict exists {a 1} b

dict exists {a {b 1}} a b

dict exists {a 1} a b

dict exists {a} a

dict exists {a 1}

dict size {a 1 b 2}

dict size {a 1 a 2}

dict size {a}

dict size

dict keys {a 1 b 2}

dict keys {abc 1 bcd 2} a*

dict keys {a 1} x y

dict keys

dict values {a 1 b 2}

dict values {a 12 b 23} 1*

dict values

dict merge

dict merge {a 1}

dict merge {a 1 b 2} {b 3 c 4}

dict merge {a 1} {b}

dict merge {a} {b 1}

dict remove {a 1 b 2} a

dict remove {a 1 b 2} x

dict remove {a 1 b 2}

dict remove {a 1 b 2} a b

dict remove

dict replace {a 1} b 2

dict replace {a 1} a 2

dict replace {a 1} a

dict replace

set d {a 1}; dict set d b 2

unset -nocomplain d; dict set d a b c 1; set d

set d {a 1}; dict set d a 2

set d {a 1}; dict set d a b 2

set d x; dict set d a 1

dict set d

dict set d a

set d {a 1 b 2}; dict unset d a

set d {a 1 b 2}; dict unset d x

set d {a {b 1 c 2}}; dict unset d a b

set d {a 1}; dict unset d x y

unset -nocomplain d; dict unset d a; set d

dict unset d

set d {a 1}; dict incr d a

set d {a 1}; dict incr d a 5

unset -nocomplain d; dict incr d a; set d

set d {a x}; dict incr d a

set d {a 1}; dict incr d a x

dict incr d

set d {a x}; dict append d a y z

unset -nocomplain d; dict append d a y

dict append d

set d {a x}; dict lappend d a y z

unset -nocomplain d; dict lappend d a y; set d

set d [list a "x \{"]; dict lappend d a y

dict lappend d

set r {}; dict for {k v} {a 1 b 2} {lappend r $k=$v}; set r

dict for {k} {a 1} {}

dict for {k v w} {a 1} {}

dict for {k v} {a} {}

dict for {k v} {a 1 b 2} {break}; set k

set r {}; dict for {k v} {a 1 b 2 c 3} {if {$k eq "b"} continue; lappend r $k}; set r

dict for {k v} {a 1} {error boom}

dict for

dict map {k v} {a 1 b 2} {expr {$v*2}}

dict map {k v} {a 1 b 2 c 3} {if {$v==2} continue; set v}

dict map {k v} {a 1 b 2 c 3} {if {$v==2} break; set v}

dict map {k} {a 1} {}

dict filter {a 1 b 2 ab 3} key a*

dict filter {a 1 b 2 ab 3} key a b

dict filter {a 1 b 2 ab 3} key

dict filter {a 1 b 2 ab 13} value *1* 2

dict filter {a 1 b 2 c 3} script {k v} {expr {$v > 1}}

dict filter {a 1 b 2 c 3} script {k v} {if {$v==1} continue; if {$v==3} break; expr 1}

dict filter {a 1} script {k v} {set v x}

dict filter {a 1} script {k} {}

dict filter {a 1} foo x

dict filter {a 1}

dict filter {a 1} script

set d {a 1 b 2}; dict update d a x b y {set x 5; unset y}; set d

set d {a 1 b 2}; dict update d a x z y {set y 9}; set d

set d {a 1}; dict update d a x {error foo}

set d {a 1}; catch {dict update d a x {set x 9; error foo}}; set d

dict update nosuch a x {}

dict update d a x

set d {a 1 b 2}; dict with d {incr a; set b 5}; set d

set d {a {x 1 y 2}}; dict with d a {incr x}; set d

set d {a 1}; dict with d x {}

dict with nosuch {}

dict with d

set d {a 1 b 2}; dict with d {unset a}; set d

set d {a 1 b 2}; dict with d {set c 3}; set d

set d {a 1}; dict with d {}; set a

dict info

set d [dict create]; dict set d x 1; dict set d y 2; dict unset d x; dict set d x 3; set d

set d [dict create a [list 1 2] b "x y"]; set d

dict create {} {} "a b" "c d"

llength [dict create a 1 b 2]

lindex [dict create a 1 b 2] 2

set d {  a   1   b 2 }; dict set d c 3

foreach {k v} [dict create x 1 y 2] {append zz $k$v}; set zz

dict get [list a 1 b [dict create c 2]] b c

dict keys [dict create b 1 a 2 c 3]

dict merge [dict create a 1 b 2] [dict create a 3]

string length [dict create a 1]

dict set a(1) x 5

dict set a(1) y 6; set a(1)

dict getdef {a 1} b 2

dict getwithdefault {a 1} b 2

array

array foo

array set a2 {x 1 y 2}; list $a2(x) $a2(y)

array set a2 {x}

array set a2 "x \{"

set s 1; array set s {x 1}

set s 1; array set s {}

array set b2 {}; array exists b2

array set b2(1) {x 1}

array set

array get a2

array get a2 x*

array get nosuch

array get s

array get

array names a2

array names a2 x*

array names a2 -exact x

array names a2 -glob {[xy]}

array names a2 -regexp {^x}

array names a2 -foo x

array names nosuch

array names

array names a b c d

array size a2

array size nosuch

array size

array exists a2

array exists s

array exists nosuch

array exists

array unset a2 x; array names a2

array unset a2; array exists a2

array unset nosuch

array unset s

array unset

array unset a b c

for {set i 0} {$i < 40} {incr i} {set big(k$i) $i}; array names big

for {set i 0} {$i < 200} {incr i} {set big2($i) $i}; array names big2

array names big2 1?

array get big k1*

foreach n {1 5 9 13 17} {unset big2($n)}; array names big2 {?}

set m(1,2) 3; set m(2,1) 4; array names m 1,*

set i 1; set j 2; set m($i,$j)

set m( ) 5; set m( )

set {m(a b)} 6; set m(a b)

set m(x)

set m

set s(1)

set s 5; set s(1)

set s 5; set s(1) 2

unset m(1,2); info exists m(1,2)

unset m(zzz)

unset nosuch

unset -nocomplain nosuch

unset s; info exists s

unset

unset -nocomplain

unset -- x

unset -foo

unset m; array exists m

set v(a) 1; incr v(a); append v(b) x; lappend v(c) y z; list $v(a) $v(b) $v(c)

foreach {k val} [array get v] {lappend out $k=$val}; lsort $out

info exists v(a)

info exists v(q)

info exists v

info exists v(a

array set v {a 100}; set v(a)

parray nosuch

array set pp {one 1 three 3 two 2}; parray pp

parray pp t*

set pp

puts $pp

set pp 5

append pp x

lappend pp x

incr pp

foreach pp {1 2} {}

lassign {1 2} pp q

catch {} pp

array set ord {b 1 a 2 c 3 d 4 e 5 f 6 g 7 h 8 i 9 j 10 k 11 l 12 m 13 n 14}; array names ord

array set ord2 {node 1 elem 2 mat 3 sect 4 time 5 disp 6 force 7}; array get ord2

set x(a)(b) 5; array names x

set x(a)b 5

array names x

set {x(} 5

set {)} 4
