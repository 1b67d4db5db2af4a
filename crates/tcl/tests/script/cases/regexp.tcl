regexp

regexp a

regexp a abc

regexp x abc

regexp {b(c)} abcd m s; list $m $s

regexp {x(c)} abcd m s

regexp {(a)|(b)} b m x y; list $m $x $y

regexp -inline {(a)|(b)} b

regexp -indices {b(c)} abcd m s; list $m $s

regexp -indices {(a)|(b)} b m x y; list $m $x $y

regexp -inline -indices {b} abc

regexp -inline {x} abc

regexp -all {b} abcbd

regexp -all -inline {b.} abcbd

regexp -all -inline {(.)(.)} abcd

regexp -all {x*} abc

regexp -all -inline {x*} abc

regexp -all -inline {b*} abc

regexp -all -inline {^a} aaa

regexp -all -inline -indices {\d+} "a1b22"

regexp -nocase {ABC} xabcx

regexp -start 2 {a} abab

regexp -start 2 -inline -indices {a} abab

regexp -start 3 {^b} abab

regexp -start end {b} abab

regexp -start x a b

regexp -start -1 a abc

regexp -start 10 a abc

regexp -inline a abc x

regexp -foo a b

regexp -- -a x-ax

regexp -a b

regexp {(} a

regexp {)} a

regexp {[} a

regexp {[a} a

regexp {a{} a

regexp {a{1} a

regexp {a{1,2} a

regexp {a{2,1}} a

regexp {a{1,300}} a

regexp {a{x}} "a{x}"

regexp {*a} a

regexp {+a} a

regexp {?} a

regexp {a**} a

regexp {a|*} a

regexp {(*a)} a

regexp {[b-a]} a

regexp {[[:foo:]]} a

regexp {\} a

regexp {a\} a

regexp {\1} a

regexp {(a)\2} aa

regexp {(a)\1} aa

regexp -inline {(\w+) \1} "the the cat"

regexp {\q} q

regexp {\g} g

regexp -inline {a|ab} abc

regexp -inline {(a|ab)(c|bcd)?} abcd

regexp -inline {a?(ab)?} abab

regexp -inline {a*?} aaa

regexp -inline {a+?} aaa

regexp -inline {a+?b} aaab

regexp -inline {.*?(\d+)} abc123

regexp -inline {(.*?)(\d+)$} abc123

regexp -inline {(.*)(\d+)} abc123

regexp -inline {<.+?>} <a><b>

regexp -inline {<.+>} <a><b>

regexp -inline {a{2}} aaaa

regexp -inline {a{2,}} aaaa

regexp -inline {a{2,3}} aaaa

regexp -inline {a{2,3}?} aaaa

regexp -inline {a{0}b} ab

regexp -inline {[[:alpha:]]+} 12ab3

regexp -inline {[[:digit:]]+} 12ab3

regexp -inline {[^[:space:]]+} " ab c"

regexp -inline {[[:alnum:]_]+} "a_1-b"

regexp -inline {[[:upper:]]+} abCDe

regexp -inline {[[:punct:]]+} "ab.,c"

regexp -inline {[[:xdigit:]]+} "xyzff"

regexp -inline {\d+\.\d*} x12.5y

regexp -inline {\s+} "ab  c"

regexp -inline {\S+} "  ab c"

regexp -inline {\w+} "--ab_1 c"

regexp -inline {\W+} "ab--c"

regexp -inline {\D+} "12ab3"

regexp -inline {[\d.]+} "ab12.5"

regexp -inline {[\w-]+} "  ab-c d"

regexp -inline {[a\]b]+} "xa]b"

regexp -inline {[]a]+} "x]a"

regexp -inline {[^]a]+} "]ax"

regexp -inline {[a-]+} "x-a"

regexp -inline {[-a]+} "x-a"

regexp -inline {[\n]} "a\nb"

regexp -inline "\[\n\]" "a\nb"

regexp {^b} "a\nb"

regexp -line {^b} "a\nb"

regexp -lineanchor {^b$} "a\nb\nc"

regexp -inline {a.b} "a\nb"

regexp -inline -line {a.b} "a\nb"

regexp -inline -linestop {a[^x]b} "a\nb"

regexp -inline {a[^x]b} "a\nb"

regexp -expanded {a b # comment
 c} abc

regexp {(?x) a b } ab

regexp {(?i)ABC} abc

regexp {(?n)^b} "a\nb"

regexp {(?q)a.b} a.b

regexp {(?q)a.b} axb

regexp {***=a.b} a.b

regexp {***:a.b} axb

regexp {(?z)a} a

regexp -inline {(?:ab)+} ababc

regexp -inline {a(?=b)} acab

regexp -inline {a(?!b)} abac

regexp -inline {(?=a)} ba

regexp {a$} "a\n"

regexp {\Aa} ba

regexp {a\Z} ab

regexp -inline {\mb\w*} "ab bc"

regexp -inline {\w*c\M} "cd bc"

regexp -inline {\yb} "ab bc"

regexp -inline {\Yb} "b ab"

regexp -inline {[[:<:]]b\w*} "ab bc"

regexp -inline {\w*c[[:>:]]} "cd bc"

regexp -inline {\t} "a\tb"

regexp -inline {\x41} "A"

regexp -inline {\u0041} "A"

regexp -inline {\.} "a.b"

regexp -inline {\$\{} {a${b}}

regexp -inline {\e} "\x1b"

regexp -inline {\B} {a\b}

regexp -inline {\cA} "\x01"

regexp -inline {é+} "aéé"

regexp -inline {.} é

regexp -indices {b} éb m; set m

regexp {} abc

regexp -inline {} abc

regexp -all -inline {} ab

regexp {a||b} x

regexp {|a} x

regexp {(|a)} x

regexp {()} x m s; list $m $s

regexp {a()b} ab

regexp -inline {(a*)*} aaa

regexp -inline {(a|b)*} abab

regexp -inline {^([^,]*),([^,]*)$} "foo,bar"

regexp {^\s*(-?\d+\.?\d*(?:[eE][-+]?\d+)?)} " -12.5e3 x" m v; list $m $v

regexp {NPTS=\s*(\d+),\s*DT=\s*([0-9.]+)} "NPTS= 4000, DT= .01000 SEC" -> n dt; list $n $dt

regexp {^(\w+)\s*=\s*(.*)$} "key = some value" -> k v; list $k $v

regexp {^#} "# comment"

regexp {^[0-9]+(\.[0-9]+)?$} 12.5

regexp -nocase -inline {[a-c]+} xABCx

regexp -nocase {É} é

regexp {a} b c d e f

regexp a(b ab

regexp {a.*b.*?c} abcbc m; set m

regexp -inline {x*y*} yyx

regexp -inline {(?:a|ab)(?:c|bcd)} abcd

regexp -inline {[^a]*?b} xxbxb

regexp -inline {(\d{1,3})(\d{3})*} 1234567

regexp -inline {^(.+)\.(\w+)$} file.tar.gz

regexp -inline {(\S+)\s+(\S+)} "one two three"

regsub

regsub a abc

regsub a abc X

regsub -all a abcabc X

regsub x abc X

regsub a abc X v; set v

regsub x abc X v; list $v

regsub -all a abcabc X v

regsub {(b)(c)} abcd {\2\1}

regsub {(b)(c)} abcd {[&]}

regsub {b} abc {\&}

regsub {b} abc {\\}

regsub {b} abc {\0\0}

regsub {b} abc {\9}

regsub {b} abc {\n}

regsub {b} abc "a\\"

regsub -all {x*} abc -

regsub -all {b*} abc -

regsub -all {} abc -

regsub -all {^} abc -

regsub -all {$} abc -

regsub {$} abc -

regsub -all -line {^} "a\nb" -

regsub -all -line {$} "a\nb" -

regsub -nocase B abc X

regsub -start 1 a aaa X

regsub -all -start 1 a aaa X

regsub -start 5 a aaa X

regsub -all {\s+} "a  b   c" " "

regsub -all {[aeiou]} "hello world" {<&>}

regsub -all {(\w)(\w)} abcd {\2\1}

regsub {(} a b

regsub -foo a b c

regsub a b c d e

regsub -all é aéb e

regsub -all {,} "1,2,3" " "

regsub -all {\.} a.b.c _

regsub {^\s+} "  a" ""

regsub {\s+$} "a  " ""

regsub -all {^\s+|\s+$} "  a  " ""

regsub -all {a|ab} abab X

regsub -all -inline a b c

regsub -- -a x-a y

regsub -all {\\} {a\b\c} /

regsub -all {[^a-z]} "a1b2" ""

regsub -all {a(.)} abac {\1&}

regsub a abc {$x [y]}

regsub {a+} baaac {<&>}

regsub {a+?} baaac {<&>}

regsub -all {(?=b)} abab -

switch -regexp abc {^a {set r 1} default {set r 2}}

switch -regexp -matchvar m abc {a(b)c {set m}}

switch -regexp -indexvar m abc {a(b)c {set m}}

switch -regexp -matchvar m -indexvar i xyz {a {} default {list $m $i}}

lsearch -regexp -all {abc bcd cde} {c.}

array set rr {abc 1 bcd 2}; lsort [array names rr -regexp {^b}]
