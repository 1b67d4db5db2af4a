# Loops as scripts of structural analyses have them, for tclsh as well. Prints the seconds and a result of each.
# Words: a factor of the lengths, and the name of the only loop to run.
set scale [expr {$argc > 0 ? [lindex $argv 0] : 1}]
proc loop {name count body} {
    if {$::argc > 1 && $name ne [lindex $::argv 1]} return
    set n [expr {int($count * $::scale)}]
    set begin [clock microseconds]
    uplevel #0 [list set n $n]
    set check [uplevel #0 $body]
    puts [format "%-12s %10.6f  %s" $name [expr {([clock microseconds] - $begin) * 1e-6}] $check]
}
proc work {n} {
    set sum 0.0
    for {set i 0} {$i < $n} {incr i} { set sum [expr {$sum + sin($i * 0.01) * 2.0}] }
    return $sum
}
proc square {x} { return [expr {$x * $x}] }
proc unbraced {n} {
    set sum 0.0
    set dt 0.005
    for {set i 0} {$i < $n} {incr i} { set t [expr $i*$dt]; set sum [expr $sum + 0.5*$t*exp(-0.1*$t)] }
    return $sum
}
proc calls {n} { set sum 0; for {set i 0} {$i < $n} {incr i} { incr sum [square $i] }; return $sum }
proc lists {n} {
    set values {}
    for {set i 0} {$i < $n} {incr i} { lappend values [expr {$i * 0.25}] }
    set sum 0.0
    foreach v $values { set sum [expr {$sum + $v}] }
    for {set i 0} {$i < $n} {incr i} { set sum [expr {$sum - [lindex $values $i]}] }
    return "$sum [llength $values]"
}
proc texts {n} {
    set text ""
    for {set i 0} {$i < $n} {incr i} { append text "[format %.4f [expr {$i * 0.37}]] $i [expr {$i / 3.0}]\n" }
    return [string length $text]
}
proc files {n} {
    set f [open loops.out w]
    for {set i 0} {$i < $n} {incr i} { puts $f "$i [expr {$i * 0.005}] [expr {sin($i * 0.1)}]" }
    close $f
    set f [open loops.out r]
    set sum 0.0
    while {[gets $f line] >= 0} { set sum [expr {$sum + [lindex $line 2]}] }
    close $f
    file delete loops.out
    return $sum
}
proc arrays {n} {
    for {set i 0} {$i < $n} {incr i} { set node($i) [expr {$i * 2}]; set tag([expr $i % 10],[expr $i / 10]) $i }
    set sum 0
    foreach key [array names node] { incr sum $node($key) }
    return "$sum [array size tag]"
}
proc tags {n} {
    set sum 0
    for {set i 1} {$i <= $n} {incr i} {
        set tag "10$i"
        if {$i % 2 == 0 && $tag > 5} { incr sum $tag } elseif {[string length $tag] > 6} { incr sum } else { incr sum 2 }
    }
    return $sum
}
proc searches {n} {
    set peak 0.0
    set k 0
    while {$k < $n} {
        set u [expr {sin($k * 0.013) * cos($k * 0.11)}]
        if {abs($u) > $peak} { set peak [expr {abs($u)}] }
        set peak [expr max($peak, $u)]
        incr k
    }
    return $peak
}
loop braced 300000 {work $n}
loop unbraced 150000 {unbraced $n}
loop calls 200000 {calls $n}
loop lists 200000 {lists $n}
loop texts 100000 {texts $n}
loop files 60000 {files $n}
loop arrays 60000 {arrays $n}
loop tags 200000 {tags $n}
loop searches 150000 {searches $n}
loop toplevel 150000 {
    set s 0.0
    for {set j 0} {$j < $n} {incr j} { set t [expr $j*0.01]; if {$t > 10.0} { set s [expr $s+$t] } }
    set s
}
