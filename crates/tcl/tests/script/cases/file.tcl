set f [open a.txt w]; puts $f "line one"; puts -nonewline $f "two"; puts $f ""; close $f

set f [open a.txt]; set r [read $f]; close $f; set r

set f [open a.txt r]; gets $f a; gets $f b; set n [gets $f c]; set e [eof $f]; close $f; list $a $b $n $e

set f [open a.txt]; set r {}; while {[gets $f l] >= 0} {lappend r $l}; close $f; set r

set f [open a.txt]; set r {}; while {![eof $f]} {lappend r [gets $f]}; close $f; set r

set f [open a.txt]; set r [read $f 4]; append r |[read $f 3]; append r |[tell $f]; close $f; set r

set f [open a.txt]; seek $f 5; set r [read $f 3]; seek $f -3 end; append r |[read $f]; seek $f 0 start; append r |[gets $f]; seek $f 1 current; append r |[read $f 2]; close $f; set r

set f [open a.txt a]; puts $f three; close $f; set f [open a.txt]; set r [read -nonewline $f]; close $f; set r

set f [open a.txt r+]; seek $f 0 end; puts $f four; seek $f 0; set r [read $f]; close $f; set r

set f [open a.txt r+]; puts -nonewline $f LINE; close $f; set f [open a.txt]; set r [gets $f]; close $f; set r

set f [open b.txt w+]; puts $f abc; seek $f 0; set r [gets $f]; close $f; set r

set f [open b.txt {WRONLY CREAT TRUNC}]; puts $f list; close $f; file size b.txt

set f [open b.txt {RDONLY}]; set r [read $f]; close $f; set r

open b.txt {CREAT}

open b.txt {FOO}

open b.txt {WRONLY CREAT EXCL}

open nosuch.txt

open nosuch.txt r

open nosuch/x w

open b.txt q

open b.txt wq

open b.txt rw

open

open . w

puts nosuch x

puts

puts a b c d

gets nosuch

gets

gets stdout

read nosuch

read

close nosuch

close

set f [open b.txt]; puts $f x

set f [open b.txt w]; gets $f

read $f

eof $f

eof

flush $f

flush

flush nosuch

tell $f

tell

tell nosuch

seek $f

seek $f x

seek $f 0 foo

seek $f -1

close $f; puts $f x

set f [open b.txt]; set r [fconfigure $f -translation]; close $f; set r

set f [open b.txt]; fconfigure $f -foo

fconfigure $f -buffering foo

fconfigure $f -buffering line; fconfigure $f -buffering

fconfigure $f -translation foo

fconfigure $f -translation binary; fconfigure $f -encoding

fconfigure $f -encoding nosuchenc

fconfigure $f -encoding utf-8; fconfigure $f -encoding

fconfigure $f -blocking x

fconfigure $f -blocking 0

fconfigure $f -buffersize 100

fconfigure $f a b c

close $f

fconfigure nosuch

fconfigure

set f [open crlf.txt w]; fconfigure $f -translation crlf; puts $f "a\nb"; close $f; file size crlf.txt

set f [open crlf.txt]; set r [read $f]; close $f; string length $r

set f [open crlf.txt]; fconfigure $f -translation binary; set r [read $f]; close $f; string length $r

set f [open crlf.txt]; gets $f a; gets $f b; close $f; list $a $b

set f [open lf.txt w]; fconfigure $f -translation lf; puts -nonewline $f "a\r\nb\rc\n"; close $f; set f [open lf.txt]; set r {}; while {[gets $f l] >= 0} {lappend r $l}; close $f; set r

set f [open u.txt w]; fconfigure $f -encoding utf-8; puts $f "é漢"; close $f; file size u.txt

set f [open u.txt]; fconfigure $f -encoding utf-8; set r [gets $f]; close $f; string length $r

set f [open u.txt]; fconfigure $f -encoding iso8859-1; set r [gets $f]; close $f; string length $r

set f [open u.txt]; fconfigure $f -encoding utf-8; set r [read $f 1]; close $f; set r

set f [open lat.txt w]; fconfigure $f -encoding iso8859-1; puts $f "é漢"; close $f; file size lat.txt

set f [open bin.dat wb]; puts -nonewline $f [binary format c3 {0 255 10}]; close $f; file size bin.dat

set f [open bin.dat rb]; binary scan [read $f] c* r; close $f; set r

set f [open e.txt w]; close $f; file size e.txt

set f [open e.txt]; set r [list [gets $f x] $x [eof $f]]; close $f; set r

set f [open e.txt]; set r [list [read $f] [eof $f]]; close $f; set r

set f [open e.txt]; set r [eof $f]; close $f; set r

set f [open nl.txt w]; puts -nonewline $f "no newline"; close $f; set f [open nl.txt]; set r [list [gets $f x] $x [eof $f] [gets $f x]]; close $f; set r

set f [open b.txt w]; puts $f a; flush $f; set r [file size b.txt]; close $f; set r

set f [open b.txt w]; set g [open c.txt w]; set r [string equal $f $g]; close $f; close $g; set r

set f [open b.txt w]; chan puts $f hello; chan close $f; set f [open b.txt]; set r [chan read $f]; chan close $f; set r

set f [open b.txt]; set r [chan gets $f]; chan seek $f 0; append r [chan tell $f][chan eof $f]; chan close $f; set r

set f [open b.txt r+]; chan truncate $f 2; chan close $f; file size b.txt

chan foo

chan

set f [open a.txt]; set g [open copy.txt w]; set n [fcopy $f $g]; close $f; close $g; list $n [file size copy.txt]

set f [open a.txt]; set g [open copy.txt w]; set n [fcopy $f $g -size 4]; close $f; close $g; list $n [file size copy.txt]

file

file foo

file exists a.txt

file exists nosuch

file exists

file isfile a.txt

file isfile .

file isdirectory .

file isdirectory a.txt

file readable a.txt

file writable a.txt

file readable nosuch

file executable a.txt

file size a.txt

file size nosuch

file type a.txt

file type .

file type nosuch

expr {[clock seconds] - [file mtime a.txt] < 100}

file mtime nosuch

file mtime a.txt 1000000; file mtime a.txt

file stat a.txt st; list $st(size) $st(type) [info exists st(mtime)]

file stat nosuch st

lsort [array names st]

file join a b c

file join a /b c

file join a

file join /a b

file join a// b/

file join "" b

file join a ""

file join a ./b

file join a ../b

file join

file split /a/b/c

file split a/b

file split a

file split /

file split ""

file split a//b/

file split ./a/../b

file dirname /a/b/c

file dirname a/b

file dirname a

file dirname /

file dirname /a

file dirname ""

file dirname a/

file dirname a/b/

file tail /a/b/c

file tail a

file tail /

file tail a/

file tail ""

file extension a.b.c

file extension a

file extension a.b/c

file extension .bashrc

file extension a.

file rootname a.b.c

file rootname a

file rootname a.b/c

file rootname a.b/c.d

file rootname .bashrc

file pathtype /a

file pathtype a

file pathtype ~/a

file nativename a/b

file separator

string equal [file normalize a.txt] [pwd]/a.txt

string equal [file normalize ./x/../a.txt] [pwd]/a.txt

file normalize /a/../b/./c

file normalize /../a

file normalize /

file normalize //a//b

file mkdir d1/d2/d3; file isdirectory d1/d2/d3

file mkdir d1

file mkdir a.txt

file mkdir a.txt/x

file mkdir

file delete nosuch

file delete d1

file delete -force d1; file exists d1

file delete

file delete -foo x

file copy a.txt a2.txt; file exists a2.txt

file copy a.txt a2.txt

file copy -force a.txt a2.txt

file copy nosuch x

file copy a.txt

file copy

file mkdir dd; file copy a.txt dd; file exists dd/a.txt

file copy a.txt dd

file copy a.txt a2.txt dd

file copy a.txt b.txt nosuchdir

file copy dd de; lsort [glob de/*]

file rename a2.txt a3.txt; list [file exists a2.txt] [file exists a3.txt]

file rename nosuch x

file rename a3.txt a.txt

file rename -force a3.txt a3b.txt; file exists a3b.txt

file rename a3b.txt dd; file exists dd/a3b.txt

file attributes nosuch

file atime nosuch

file volumes

file channels nosuch*

lsort [glob *.txt]

lsort [glob -nocomplain *.zzz]

glob *.zzz

glob *.zzz *.yyy

glob

lsort [glob {a,b}.txt]

lsort [glob a.txt b.txt]

glob a.txt

glob -nocomplain nosuch.txt

lsort [glob -directory dd *]

lsort [glob -directory dd -tails *]

lsort [glob -tails -directory dd *.txt]

lsort [glob -types d *]

lsort [glob -types f *.txt]

lsort [glob -type d *]

lsort [glob dd/*]

lsort [glob */a.txt]

lsort [glob -join dd *.txt]

lsort [glob -path dd/a *]

glob -directory

glob -foo x

lsort [glob {[ab].txt}]

lsort [glob ?.txt]

glob {a{.txt}

lsort [glob -nocomplain dd/nosuch/*]

glob -tails *.txt

cd dd; set r [lsort [glob *]]; cd ..; set r

cd nosuch

cd a.txt

cd a b

string equal [pwd] [file normalize .]

pwd x

set f [open s.tcl w]; puts $f "set sv 5"; close $f; source s.tcl; set sv

set f [open s.tcl w]; puts $f "return early\nset sv 6"; close $f; list [source s.tcl] $sv

set f [open s.tcl w]; puts $f "error insource"; close $f; source s.tcl

catch {source s.tcl}; set errorInfo

set f [open s.tcl w]; puts $f "info script"; close $f; source s.tcl

set f [open dd/s.tcl w]; puts $f "file tail \[info script\]"; close $f; source dd/s.tcl

source nosuch.tcl

source

source -encoding utf-8 s.tcl

set f [open s.tcl w]; puts $f "break"; close $f; source s.tcl

foreach i {1 2 3} {source s.tcl}; set i

set f [open s.tcl w]; puts $f "set x \{"; close $f; source s.tcl

set f [open s.tcl w]; puts $f "set ok 1\nset x \"abc"; close $f; list [catch {source s.tcl} m] $m $ok

set f [open s.tcl w]; puts -nonewline $f "set z 1\r\nset z 2\r\n"; close $f; source s.tcl; set z

proc ps {} {source s2.tcl; return $inlocal}; set f [open s2.tcl w]; puts $f "set inlocal 7"; close $f; ps

set f [open s.tcl w]; puts $f "set a 1 ;# \u001a rest"; close $f; source s.tcl

binary format c 65

binary format a5 abc

binary format A5 abc

binary format a* hello

binary format a hello

string length [binary format s 258]

binary scan [binary format s 258] cc a b; list $a $b

binary scan [binary format S 258] cc a b; list $a $b

binary scan [binary format i -1] H* h; set h

binary scan [binary format I 305419896] H* h; set h

binary scan [binary format w 1] H* h; set h

binary scan [binary format d 1.5] H* h; set h

binary scan [binary format f 1.5] H* h; set h

binary scan [binary format Q 1.5] H* h; set h

binary scan [binary format B8 10101010] H* h; set h

binary scan [binary format b8 10101010] H* h; set h

binary scan [binary format H4 1a2b] c* h; set h

binary scan [binary format h4 1a2b] c* h; set h

binary scan abc a2 x; set x

binary scan "ab  " A* x; set x

binary scan abc a5 x

binary scan \xff\xfe cucu a b; list $a $b

binary scan \xff\xfe su a; set a

binary scan abcd x2a* x; set x

binary scan abcd a1X1a2 x y; list $x $y

binary scan abcd @2a* x; set x

binary format c3 {1 2}

binary format c

binary format z 1

binary format x2c 1

binary scan a

binary scan abc z x

binary scan abc aaa x

binary format c a

binary scan [binary format c2s {1 2} 3] c2s a b; list $a $b

binary foo

encoding names x

encoding system

encoding foo

encoding convertto utf-8 é

encoding convertfrom utf-8 \xc3\xa9

encoding convertto nosuch é
