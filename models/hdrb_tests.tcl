# Tests of high damping rubber bearings: specimens, protocols and the programme of D. A. Nguyen, A rheology model of high
# damping rubber bearings for seismic analysis at room and low temperatures, dissertation (Tables 2.1 and 2.2, Figs 2.5
# and 2.6), as procedures to `source`.
#
# Units: N, mm, s, degC; stresses in MPa, energies per volume in MJ/m3 = MPa.
#
#   hdrb::specimen A|B                    dimensions of a specimen, a dictionary
#   hdrb::programme                       the 24 rows of Table 2.2, a list of dictionaries
#   hdrb::path ROW ?preload 0|1? ...      the strain history of a row, as segments
#   hdrb::run SEGMENTS MATERIAL           runs a history: dictionary of columns (time strain stress ...)
#   hdrb::loop STRAINS STRESSES           D, h_eq and G_eq of a loop (Eqs 4.1, 4.2)
#
# A segment is one of
#   ramp TO RATE             to a strain at a constant rate
#   hold SECONDS             in steps that grow with the time
#   sine AMPLITUDE HZ CYCLES
# and may have a name behind it, by which its rows can be found.

namespace eval hdrb {
    # Steps for a unit of strain on a ramp, for a cycle of a sine; growth of the steps of a hold.
    variable perStrain 200
    variable perCycle 400
    variable growth 1.25

    proc specimen {type} {
        switch $type {
            A { return {area 57600.0 height 30.0 layers 6 layer 5.0 steel 2.3} }
            B { return {area 25600.0 height 20.0 layers 5 layer 4.0 steel 2.3} }
            default { error "there is no specimen $type: A or B" }
        }
    }

    # Heat capacity per volume of rubber, MJ/m3K: rubber by itself (Eq 5.2), and with the steel between its layers at the
    # same temperature (Eq 5.3, with the total mass). Specific heats of the thesis (Uruta et al., 2004), J/gK; densities
    # in g/cm3 are assumed.
    proc heatCapacity {type {composite 1} {rubber 1.15} {metal 7.85}} {
        set s [specimen $type]
        set c [expr {$rubber*1.732}]
        if {$composite} {
            dict with s { set c [expr {$c + $metal*0.432*($layers - 1)*$steel/($layers*$layer)}] }
        }
        return $c
    }

    # Table 2.2. Temperatures -30, -10 and 23 degC; the last is that of the room, where specimens are larger.
    proc programme {} {
        set rows {}
        set number 0
        foreach {temperature suffix type hz} {-30 -30 B 0.5 -10 -10 B 0.5 23 -r A 1.0} {
            foreach {name protocol amplitude values} [list \
                SR100 SR 1.0 {rate 5.5 hold 1800} SR150 SR 1.5 {rate 5.5 hold 1800} SR175 SR 1.75 {rate 5.5 hold 1800} \
                MSR250 MSR 2.5 {rate 5.5 hold 1200} Sin175 Sin 1.75 "hz $hz cycles 11" \
                CS175 CS 1.75 {rate 1.5 cycles 11} CS175 CS 1.75 {rate 5.5 cycles 11} CS175 CS 1.75 {rate 8.75 cycles 11}] {
                set row [list number [incr number] name $name$suffix protocol $protocol amplitude $amplitude \
                    temperature $temperature specimen $type {*}$values]
                if {$protocol eq "CS"} { dict append row name -[string range [dict get $row rate] 0 2] }
                lappend rows $row
            }
        }
        return $rows
    }

    # The strain history of a row. Preloading takes the Mullins effect out: six cycles at 0.05 Hz, at 1.75 or, before MSR,
    # at 2.5; then the specimen rests (`-rest`, a day). MSR goes up and down in steps (`-step`, 0.5), which Fig 2.5 shows
    # and the text does not tell.
    proc path {row args} {
        set options [dict merge {-preload 1 -rest 86400.0 -step 0.5} $args]
        set segments {}
        set a [dict get $row amplitude]
        set protocol [dict get $row protocol]
        if {[dict get $options -preload]} {
            lappend segments [list sine [expr {$protocol eq "MSR" ? 2.5 : 1.75}] 0.05 6 preload]
            lappend segments [list hold [dict get $options -rest] rest]
        }
        switch $protocol {
            CS {
                set rate [dict get $row rate]
                lappend segments [list ramp $a $rate cycle1]
                for {set i 1} {$i <= [dict get $row cycles]} {incr i} {
                    lappend segments [list ramp [expr {-$a}] $rate cycle$i]
                    if {$i < [dict get $row cycles]} {
                        lappend segments [list ramp 0.0 $rate cycle$i] [list ramp $a $rate cycle[expr {$i + 1}]]
                    }
                }
                lappend segments [list ramp 0.0 $rate cycle$i]
            }
            Sin {
                for {set i 1} {$i <= [dict get $row cycles]} {incr i} {
                    lappend segments [list sine $a [dict get $row hz] 1 cycle$i]
                }
            }
            SR {
                foreach {to name} [list $a loading 0.0 unloading [expr {-$a}] reverse 0.0 return] {
                    lappend segments [list ramp $to [dict get $row rate] $name]
                    lappend segments [list hold [dict get $row hold] hold-$name]
                }
            }
            MSR {
                set step [dict get $options -step]
                set n [expr {int(round($a/$step))}]
                set k 0
                foreach {to by} [list $n 1 [expr {-$n}] -1 0 1] {
                    while {$k != $to} {
                        incr k $by
                        lappend segments [list ramp [expr {$k*$step}] [dict get $row rate] step]
                        lappend segments [list hold [dict get $row hold] relax]
                    }
                }
            }
        }
        return $segments
    }

    # Times and strains of a history, step by step, with the name of the segment that each belongs to.
    proc sample {segments} {
        variable perStrain
        variable perCycle
        variable growth
        set time 0.0
        set at 0.0
        set times 0.0
        set strains 0.0
        set names start
        foreach segment $segments {
            lassign $segment kind
            switch $kind {
                ramp {
                    lassign $segment kind to rate name
                    set n [expr {max(1, int(ceil(abs($to - $at)*$perStrain - 1e-9)))}]
                    set dt [expr {abs($to - $at)/$n/$rate}]
                    for {set i 1} {$i <= $n} {incr i} {
                        lappend times [expr {$time + $i*$dt}]
                        lappend strains [expr {$at + ($to - $at)*double($i)/$n}]
                        lappend names $name
                    }
                    set at $to
                    set time [expr {$time + $n*$dt}]
                }
                hold {
                    lassign $segment kind seconds name
                    set gone 0.0
                    set dt [expr {$seconds*1e-6}]
                    while {$gone < $seconds*(1.0 - 1e-9)} {
                        set gone [expr {min($seconds, $gone + $dt)}]
                        lappend times [expr {$time + $gone}]
                        lappend strains $at
                        lappend names $name
                        set dt [expr {$dt*$growth}]
                    }
                    set time [expr {$time + $seconds}]
                }
                sine {
                    lassign $segment kind amplitude hz cycles name
                    set n [expr {$cycles*$perCycle}]
                    for {set i 1} {$i <= $n} {incr i} {
                        set phase [expr {double($i)/$perCycle}]
                        lappend times [expr {$time + $phase/$hz}]
                        lappend strains [expr {$at + $amplitude*sin(2.0*acos(-1.0)*$phase)}]
                        lappend names $name
                    }
                    set time [expr {$time + $cycles/$hz}]
                }
                default { error "there is no segment $kind: ramp, hold or sine" }
            }
        }
        return [list $times $strains $names]
    }

    # Run a history with a law of stress and strain: the words after the tag, e.g. {HDRRheology -compound HDR3 -temperature
    # 23}. Columns: time strain stress name, and for HDRRheology equilibrium overstress temperature heat.
    proc run {segments material {area 1.0} {height 1.0}} {
        lassign [sample $segments] times strains names
        wipe
        model basic -ndm 1 -ndf 1
        node 1 0.0
        node 2 0.0
        fix 1 1
        set rheology [expr {[lindex $material 0] eq "HDRRheology"}]
        set size [expr {$rheology ? [list -area $area -height $height] : {}}]
        uniaxialMaterial [lindex $material 0] 1 {*}[lrange $material 1 end] {*}$size
        element zeroLength 1 1 2 -mat 1 -dir 1
        timeSeries Path 1 -time $times -values $strains -useLast
        pattern Plain 1 1 { sp 2 1 $height }
        constraints Transformation
        numberer Plain
        system BandGeneral
        test NormDispIncr 1e-12 20
        algorithm Newton
        set parts [expr {$rheology ? {equilibrium overstress temperature heat} : {}}]
        set out [dict create time 0.0 strain 0.0 stress 0.0 name start]
        foreach part $parts { dict set out $part [part $part $area $height] }
        set last 0.0
        foreach t [lrange $times 1 end] g [lrange $strains 1 end] name [lrange $names 1 end] {
            integrator LoadControl [expr {$t - $last}]
            if {$last == 0.0} { analysis Static }
            if {[analyze 1] != 0} { error "no answer at a strain of $g after $t s" }
            set last $t
            dict lappend out time $t
            dict lappend out strain $g
            dict lappend out stress [expr {[eleResponse 1 material 1 stress]/$area}]
            dict lappend out name $name
            foreach part $parts { dict lappend out $part [part $part $area $height] }
        }
        return $out
    }

    proc part {name area height} {
        set x [eleResponse 1 material 1 $name]
        switch $name {
            temperature { return $x }
            heat { return [expr {$x/($area*$height)}] }
            default { return [expr {$x/$area}] }
        }
    }

    # Run a row of the programme with a compound, and more words for its material.
    proc simulate {row compound args} {
        set s [specimen [dict get $row specimen]]
        set material [list HDRRheology -compound $compound -temperature [dict get $row temperature] {*}$args]
        return [run [path $row] $material [dict get $s area] [dict get $s height]]
    }

    # The rows of a run that belong to segments with a name (a pattern), with the row before them: a run again.
    proc select {run pattern} {
        set first -1
        set last -1
        set i 0
        foreach name [dict get $run name] {
            if {[string match $pattern $name]} {
                if {$first < 0} { set first $i }
                set last $i
            }
            incr i
        }
        if {$first < 0} { error "no segment is called $pattern" }
        set out {}
        dict for {key column} $run { dict set out $key [lrange $column [expr {max(0, $first - 1)}] $last] }
        return $out
    }

    # Dissipated work D, equivalent damping h_eq = D / (2 pi G_eq g^2) and modulus G_eq of a loop (Eqs 4.1, 4.2).
    proc loop {strains stresses} {
        set d 0.0
        lassign {-1e300 1e300 0.0} high low amplitude
        set at [lindex $strains 0]
        set was [lindex $stresses 0]
        foreach g $strains s $stresses {
            set d [expr {$d + 0.5*($s + $was)*($g - $at)}]
            set at $g
            set was $s
            if {$s > $high} { set high $s; set right $g }
            if {$s < $low} { set low $s; set left $g }
            set amplitude [expr {max($amplitude, abs($g))}]
        }
        set modulus [expr {($high - $low)/($right - $left)}]
        return [list $d [expr {$d/(2.0*acos(-1.0)*$modulus*$amplitude**2)}] $modulus]
    }

    # Dissipated work of each cycle and up to each cycle (Eq 5.1).
    proc dissipation {run} {
        set each {}
        set sum {}
        set all 0.0
        for {set i 1} {[lsearch -exact [dict get $run name] cycle$i] >= 0} {incr i} {
            set cycle [select $run cycle$i]
            set d [lindex [loop [dict get $cycle strain] [dict get $cycle stress]] 0]
            set all [expr {$all + $d}]
            lappend each $d
            lappend sum $all
        }
        return [list $each $sum]
    }

    # Coefficient of determination (Eq 3.14).
    proc r2 {measured modelled} {
        set n [llength $measured]
        set mean [expr {[tcl::mathop::+ {*}$measured]/double($n)}]
        set missed 0.0
        set spread 0.0
        foreach x $measured y $modelled {
            set missed [expr {$missed + ($x - $y)**2}]
            set spread [expr {$spread + ($x - $mean)**2}]
        }
        return [expr {1.0 - $missed/$spread}]
    }
}
