namespace

namespace foo

namespace current

namespace eval a {namespace current}

namespace eval a {namespace eval b {namespace current}}

namespace eval ::a::b::c {namespace current}

namespace eval {} {namespace current}

namespace eval :: {namespace current}

namespace eval a

namespace eval

namespace eval a {set x 5}; set a::x

namespace eval a {variable v 1; proc getv {} {variable v; return $v}}; a::getv

namespace eval a {proc setv x {variable v; set v $x}}; a::setv 9; set ::a::v

set a::nosuch

set nosuchns::x 1

set ::a::newv 3; set a::newv

namespace exists a

namespace exists nosuch

namespace exists ::a::b

namespace exists

namespace qualifiers ::a::b::c

namespace qualifiers a::b

namespace qualifiers a

namespace qualifiers ::a

namespace qualifiers a::

namespace qualifiers a:::b

namespace qualifiers

namespace tail ::a::b::c

namespace tail a

namespace tail a::

namespace tail ::

namespace tail a:b

namespace parent a

namespace parent ::a::b

namespace parent

namespace parent ::

namespace parent nosuch

namespace eval a {namespace parent}

namespace children a

namespace children ::a b*

namespace children ::a ::a::b*

namespace children nosuch

namespace eval a {namespace children}

namespace delete nosuch

namespace eval tmp {proc f {} {}; variable x 1}; namespace delete tmp; namespace exists tmp

namespace eval tmp {proc f {} {}}; namespace delete tmp; tmp::f

namespace eval tmp {variable x 1}; namespace delete tmp; set tmp::x

namespace delete

namespace code {set x}

namespace eval a {namespace code {set x}}

namespace code [namespace code x]

namespace inscope a {set x}

namespace inscope a list x {y z}

namespace inscope a {list x} {y z}

namespace inscope nosuch {set x}

namespace which set

namespace which nosuch

namespace which a::getv

namespace eval a {namespace which getv}

namespace which -command set

namespace which -variable errorInfo

namespace which -variable a::x

namespace which -variable nosuch

namespace which -foo x

namespace which

namespace origin set

namespace origin nosuch

namespace eval exp {proc e1 {} {return e1}; proc e2 {} {return e2}; proc p1 {} {}; namespace export e*}; namespace eval exp {namespace export}

namespace import exp::*; e1

namespace import exp::*

namespace import exp::nosuch

namespace import exp::p1; p1

namespace import nosuch::*

namespace import foo

namespace import ""

namespace origin e1

lsort [namespace import]

namespace forget exp::e1; e1

namespace forget exp::*; info commands e2

namespace forget nosuch::*

proc e1 {} {return mine}; namespace import exp::*

namespace import -force exp::*; e1

namespace eval exp {namespace export -clear p1}; namespace eval exp {namespace export}

namespace export a::b

namespace eval exp {proc e1 {} {return new}}; e1

rename exp::e1 ""; e1

namespace eval q {namespace path ::a; getv}

namespace eval q {namespace path}

namespace eval q {namespace path nosuch}

namespace path {}

namespace unknown

namespace eval q {namespace unknown {list unk}; zork 1 2}

namespace eval q {namespace unknown {}; zork 1 2}

namespace upvar a v myv; set myv

namespace upvar a

namespace upvar nosuch v x

namespace upvar a v

proc nu {} {namespace upvar ::a v lv; incr lv}; set a::v 1; nu; set a::v

namespace eval a {variable arr; set arr(1) x; set arr(2) y}; lsort [array names a::arr]

set a::arr(1)

namespace eval a {variable}

namespace eval a {variable x y z 5}

namespace eval a {variable a(1) 5}

proc vt {} {variable vvv 7; set vvv}; vt

set vvv

namespace eval a {proc vt {} {variable nv; info exists nv}}; a::vt

namespace eval a {variable undefd}; info exists a::undefd

set a::undefd

set gx 1; namespace eval a {set gx 2}; list $gx [info exists a::gx]

namespace eval a {set fresh 1}; info exists fresh

namespace eval a {variable gx 5}; list $gx $a::gx

set gy 10; namespace eval a {set gy}

namespace eval a {proc rd {} {global gy; set gy}}; a::rd

namespace eval a {proc rd {} {set ::gy}}; a::rd

namespace eval a {proc helper {} {return ah}; proc call {} {helper}}; a::call

namespace eval a {namespace eval b {proc call2 {} {helper}}}; a::b::call2

proc helper {} {return gh}; a::b::call2

a::nosuch

::a::getv

a::b::nosuch::x

namespace eval a {info level}

proc lv {} {namespace eval a {info level}}; lv

namespace eval a {uplevel 1 {namespace current}}

namespace eval a {error boom}

catch {namespace eval a {error boom}}; set errorInfo

namespace eval a {return 5}

namespace eval a {break}

namespace eval a set x 6

namespace eval a {set x} y

namespace eval ens {proc one x {return 1-$x}; proc two {} {return 2}; namespace export one two; namespace ensemble create}; ens one 5

ens two

ens on 3

ens three

ens

ens one

ens two 5

namespace ensemble exists ens

namespace ensemble exists set

namespace ensemble exists nosuch

namespace eval em {proc impl args {return impl-$args}}; namespace ensemble create -command emc -map {x em::impl y {::em::impl fixed}}

emc x 1 2

emc y 1

emc z

namespace eval em {namespace ensemble create -command ::emd -subcommands {impl}}; emd impl q

emd foo

namespace ensemble

namespace ensemble create -foo x

namespace eval en2 {namespace ensemble create}; en2 x

info commands a::*

lsort [info commands ::a::*]

lsort [info procs a::*]

namespace eval a {lsort [info procs]}

info commands set

info commands se[tx]

info commands nosuch

namespace eval a {info commands set}

namespace eval a {info commands getv}

info vars errorC*

info globals errorC*

info globals ::errorC*

proc iv {a} {set b 1; lsort [info vars]}; iv 1

proc iv {a} {global gx; lsort [info vars]}; iv 1

info exists ::gx

info exists a::x

info exists a::zzz

info tclversion

info tclversion x

info patchlevel

info cmdcount x

info script x y

info hostname x

info level a b

lsort [info functions]

info complete

info sharedlibextension

info frame x

info frame 99

info args

info body

info exists

info commands a b

info procs a b

info foo

info

info exi gx

info e gx

info loaded

proc ::a::pp {x {y 2}} {body}; info args a::pp

info body a::pp

info default a::pp y d; set d

proc inproc {} {file tail [info script]}; inproc

info nameofexecutable x

package

package foo

package require Tcl

package require Tcl 8.5

package require Tcl 8.6

package require Tcl 9

package require Tcl 8.5-

package require Tcl 8.4-8.7

package require -exact Tcl 8.6

package require nosuchpkg

package require nosuchpkg 1.2

package require -exact nosuchpkg 1.2

package require

package provide foo 1.0

package provide foo

package provide bar

package require foo

package require foo 1.0

package require foo 2.0

package require foo 1.5

package require foo 0.5

package present foo

package present nosuchpkg

package present Tcl

package provide foo x

package vcompare 1.2 1.10

package vcompare 1.0 1.0

package vcompare 2 1.9

package vcompare 1.0a1 1.0

package vcompare 1.0b2 1.0b1

package vcompare 1.x 1

package vsatisfies 8.6 8.5

package vsatisfies 8.6 9

package vsatisfies 8.6 8.7

package vsatisfies 8.6 8.5-

package vsatisfies 8.6 8.5-8.6

package vcompare 1

package versions nosuch

package forget foo; package provide foo

package ifneeded zork 1.0 {package provide zork 1.0}; package require zork

package names x

package prefer
