set x -5; expr $x**2

set x -5; expr 2**$x

set x -5; expr 3-$x

set x -5; expr 3--$x

set x -5; expr -$x

set x -5; expr !$x

set x -5; expr ~$x

set x -2.50; expr $x eq -2.5

set x -2.50; expr $x eq "-2.50"

set x 2.50; expr $x eq 2.5

set x 2.50; expr $x eq 2.50

set x 2.50; expr $x

set x 2.50; expr $x+0

set x 010; expr $x+1

set x 08; expr $x+1

set x " 5"; expr $x*2

set x "5 "; expr $x*2

set x "5 "; expr $x eq 5

set x 5; expr $x$x

set x 5; expr 1$x+1

set x 5; expr $x.5

set x 5; expr $x e 1

set x 5; set y 3; expr $x>$y ? $x : $y

set x 5; set y 3; expr $x > $y && $y > $x

set x abc; expr $x == "abc"

set x abc; expr $x == abc

set x 5; expr ($x+1)*2

set x 5; expr sin($x)

set x 5; expr pow($x,2)

set x 5; expr max($x,$x,7)

set x 5; expr $x(1)

set x 1e5; expr $x/3

set x 1.e5; expr $x/3

set x .5; expr $x*2

set x 5.; expr $x*2

set x +5; expr $x*2

set x Inf; expr $x*2

set x 0x10; expr $x*2

set x 99999999999999999999; expr $x*2

set x -9223372036854775808; expr $x-1

set x -9223372036854775808; expr $x

set x {}; expr $x+1

set x "1+1"; expr $x*2

set x "1 2"; expr $x

set x {"a"}; expr $x eq $x

set x {$y}; set y 4; expr $x*2

set x {[set y]}; expr $x*2

expr [llength {a b c}]*2

expr [llength {a b c}] * [llength {a b}]

expr 1 + [expr 2*3]

expr "1 + 2" * 3

expr {1} + {2}

set x 3; expr {$x} + {$x}

set x 3; expr {$x}+1

set x 3; expr "$x"+1

set x 3; expr \$x+1

set a(1) 7; expr $a(1)*2

set a(1) 7; set i 1; expr $a($i)*2+$i

expr $nosuch+1

expr [nosuch]+1

set x 3; expr $x +

set x 3; expr $x $x

set x 3; expr ($x

set x 3; expr $x / 0

set x 3; expr $x / 0.0

set x abc; expr $x + 1

set x true; expr $x && 1

set x 3; expr $x in {1 2 3}

set x 3; expr $x<<2

set x -3; expr $x<<2

set x -3; expr $x<$x

set x -3; expr 1<$x

set x -3; expr 5%$x

set x -3; expr 5 % $x

set x 3; set y 4.0; expr $x*1.0/$y

set x 3; set y 4.0; expr sqrt($x*$x + $y*$y)

set L 144.0; set E 29000.; set A 26.5; expr $E*$A/$L

set pi [expr acos(-1.0)]; expr 2*$pi/1.5

set T 0.5; set w [expr 2.0*acos(-1.0)/$T]; expr $w*$w

set n 5; expr int($n/2)

set n 5; expr round($n/2.)

set x 1; expr $x?2:3

set x 1; expr $x ? "a" : "b"

set x 5; proc expr args {return mine}; set r [expr $x*2]; rename expr {}; set r

set tcl_precision 6; set r <[tcl::mathop::/ 1.0 3]>; set tcl_precision 0; set r
