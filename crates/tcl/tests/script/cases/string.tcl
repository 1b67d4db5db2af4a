string

string foo

string length

string length abc

string length {}

string length "é ü 漢"

string len abc

string bytelength aé

string cat

string cat a b c

string compare a b

string compare b a

string compare a a

string compare -nocase A a

string compare -length 2 abc abd

string compare -length -1 abc abd

string compare -length x abc abd

string compare -length 0 a b

string compare -foo a b

string compare a

string compare a b c d e f

string equal a a

string equal -nocase Ab aB

string equal a b

string equal -length 1 ab ac

string equal -nocase -length 2 ABc abd

string equal

string first b abcb

string first b abcb 2

string first x abc

string first "" abc

string first bc abcabc 2

string first é aéb

string first b abc end

string first b abc x

string first

string last b abcb

string last b abcb 2

string last x abc

string last "" abc

string last a abc -1

string last a abca end-1

string last

string index abc 0

string index abc end

string index abc end-1

string index abc 5

string index abc -1

string index abc 1+1

string index aéb 1

string index abc x

string index abc

string range abcdef 1 3

string range abcdef 1 end

string range abcdef end-2 end

string range abcdef -1 2

string range abcdef 3 1

string range abcdef 3 99

string range aébc 1 2

string range abc x 1

string range abc 1

string replace abcdef 1 3

string replace abcdef 1 3 XY

string replace abcdef 3 1 XY

string replace abcdef -2 1 X

string replace abcdef 4 99 X

string replace abcdef 99 100 X

string replace abc -3 -1 X

string replace abc 0 end

string replace abc 0 end {}

string replace "" 0 0 x

string replace abc 1

string match a* abc

string match a?c abc

string match {a[bx]c} abc

string match {a[a-c]c} abc

string match {a[c-a]c} abc

string match {a[!b]c} axc

string match {a[^b]c} a^c

string match {a\*c} a*c

string match {a\*c} abc

string match * ""

string match "" ""

string match ? ""

string match -nocase A* abc

string match -nocase {[A-C]*} bcd

string match {[} {[}

string match {[a} a

string match {[a-} a

string match {a[} {a[}

string match {*[0-9]} abc5

string match {\\} {\}

string match {\} {\}

string match a*b*c*d axbxcxd

string match *a*b*c* xxabxc

string match {[]]} {]}

string match {[a-z]*[0-9]} node12

string match -foo a b

string match a

string match "é*" "éa"

string map {a 1 b 2} abcab

string map {ab 1 a 2 b 3} abab

string map {} abc

string map {a} abc

string map -nocase {A 1} aAbB

string map {"" x a y} abc

string map {abc 1 ab 2 a 3 1 0} 1abcaababcabababc

string map [dict create a b] aaa

string map {a b b a} abab

string map -foo {a b} a

string map

string map {a {}} banana

string repeat ab 3

string repeat ab 0

string repeat ab -1

string repeat ab x

string repeat ab

string reverse abc

string reverse aéb

string reverse ""

string reverse

string tolower ABC

string tolower ABCDEF 1 3

string tolower ABCDEF 1

string tolower ABCDEF end-1 end

string tolower ABC x

string toupper abc

string toupper "straße"

string toupper abcdef 2

string toupper éa

string totitle "hello world"

string totitle HELLO

string totitle hello 1 3

string totitle hELLO 1

string toupper

string tolower a b c d

string trim "  a b  "

string trim xxabcxx x

string trim "\n\t a \r"

string trim abc ""

string trim abc abc

string trimleft "  a "

string trimleft xxaxx x

string trimright "  a "

string trimright xxaxx x

string trimright abc00 0

string trim

string trim a b c

string wordend "hello world" 0

string wordend "hello world" 5

string wordend "hello world" end

string wordend "a.b c" 1

string wordend "abc" 10

string wordend abc -1

string wordend abc x

string wordstart "hello world" 7

string wordstart "hello world" 5

string wordstart "hello world" 99

string wordstart "a_b c" 2

string wordstart abc -1

string wordstart

string is

string is integer

string is foo x

string is integer 12

string is integer -12

string is integer " 12 "

string is integer 12a

string is integer 0x1F

string is integer 010

string is integer 08

string is integer 1.0

string is integer ""

string is integer -strict ""

string is integer 4294967295

string is integer 4294967296

string is integer -4294967296

string is integer 2147483648

string is wideinteger 9223372036854775807

string is wideinteger 9223372036854775808

string is wideinteger 18446744073709551616

string is entier 99999999999999999999999

string is entier 1.5

string is double 1.5

string is double 1

string is double abc

string is double 1e5

string is double 1e

string is double .5

string is double 5.

string is double .

string is double ""

string is double -strict ""

string is double " 1.5 "

string is double Inf

string is double NaN

string is double 1e400

string is double 0x10

string is double 1_000

string is double 1,5

string is boolean true

string is boolean yes

string is boolean y

string is boolean 1

string is boolean 0

string is boolean 2

string is boolean 1.0

string is boolean on

string is boolean o

string is boolean off

string is boolean of

string is boolean tru

string is boolean TRUE

string is boolean ""

string is boolean -strict ""

string is true 1

string is true yes

string is true 5

string is false no

string is false 0

string is alnum abc1

string is alnum "abc 1"

string is alpha abc

string is alpha abc1

string is alpha é

string is ascii abc

string is ascii é

string is control "\x01"

string is control a

string is digit 123

string is digit 12a

string is graph abc

string is graph "a b"

string is lower abc

string is lower aBc

string is upper ABC

string is upper AbC

string is print "a b"

string is print "a\n"

string is punct ".,;!"

string is punct "+"

string is punct "a"

string is punct {$+<=>^`|~}

string is punct {_-%&'()*/:?@[\]{}"#}

string is space " \t\n"

string is space a

string is wordchar a_1

string is wordchar a-1

string is xdigit 1aF

string is xdigit 1g

string is list {a b c}

string is list "a \{b"

string is list {a {b}c}

string is list ""

string is integer -failindex i 12a; set i

string is integer -failindex i ab; set i

string is integer -failindex i 12.5; set i

string is integer -failindex i 99999999999999; set i

string is integer -failindex i 0x; set i

string is integer -failindex i "  12 x"; set i

string is double -failindex i 1.5x; set i

string is double -failindex i 1e; set i

string is double -failindex i x1; set i

string is double -failindex i 1.e; set i

string is double -failindex i -; set i

string is alpha -failindex i ab1; set i

string is list -failindex i "a b \{c"; set i

string is list -failindex i {a b {c}d e}; set i

string is boolean -failindex i maybe; set i

string is integer -strict -failindex i ""; set i

string is space -failindex i " a"; set i

string is integer -foo x

string is integer -failindex x

string is integer -strict -strict 12

string is int 5

string is d 5

append

append x

unset -nocomplain s; append s a b c

unset -nocomplain s; append s

set s a; append s; set s

append s(1) x

unset -nocomplain arr; append arr(1) x y

set x "a\tb"; string length $x

set s "\u00e9\x41\101\e\q"

set s "a\
    b"

set s {a\
    b}

set s \x4142

set s \u12

set s "\400"

set s "\18"

set s "a;b#c"

set s a#b

set a;set b;

set {a b} 1; set {a b}

set "x y" 5; set z ${x y}

set x 1; set s $x$x-$x.$x

set x 1; set s "$x($x"

set s a$

set s "$ $% $-"

set s $

set ::q 5; set s $::q

set s {$x [y] \n}

set s "[set x 5][set x 6]"

set s [set x 5; set x 7]

set s []

set s "a[]b"

set s [
set x 5
]

list {*}{a b} {*}[list c d] {*}{} e

list {*} a

list {*}$nosuch

list {*}"a \{"

list {*}a {*}b

{*}{list a b} c

set x {*}; list $x {*}$x
