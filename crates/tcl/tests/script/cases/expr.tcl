expr

expr 1+1

expr 1 + 1

expr {1} + {2}

expr 08

expr 08+1

expr 0o8

expr 0b2

expr 0x

expr 0xg

expr 1a

expr 1.5.5

expr 1e

expr 1e5x

expr 12eq12

expr 1 eq 1.0

expr {"a" eq "a"}

expr {1 == 1.0}

expr {0x10 == 16}

expr {"0x10" == 16}

expr {0x10 eq 16}

expr {"1" == " 1 "}

expr {1.50 eq 1.5}

expr 1.50

expr {1.50}

expr {"1.50"}

expr " 5 "

expr {" 5 "}

expr {"abc"}

expr {abc}

expr abc

expr {abc + 1}

expr {a(1)}

expr {sin}

expr {sin(}

expr {sin()}

expr {sin(1,2)}

expr {sin(1}

expr {sin 1}

expr {foo(1)}

expr {sqr(2)}

expr {pow(2)}

expr {pow(2,3,4)}

expr {max()}

expr {min()}

expr {max(1)}

expr {rand(1)}

expr {1 +}

expr {+}

expr {* 2}

expr {1 2}

expr {1 $x}

expr {(1}

expr {1)}

expr {()}

expr {(}

expr {)}

expr {}

expr {   }

expr ""

expr {1 + (2}

expr {1 ? 2}

expr {1 ? 2 :}

expr {1 : 2}

expr {? 1 : 2}

expr {1 ? : 2}

expr {1 ? 2 : 3 : 4}

expr {1,2}

expr {,}

expr {max(1,)}

expr {max(,1)}

expr {max(1,,2)}

expr {(1,2)}

expr {1 = 2}

expr {1 & & 2}

expr {1 && }

expr {!}

expr {~}

expr {@}

expr {1 @ 2}

expr {1 # 2}

expr {$}

expr {$ + 1}

expr {"abc}

expr {{abc}

expr "{abc"

expr {[set x}

expr {$x(}

expr {${x}

expr {1 == "a}

expr {é}

expr {1 + é}

expr {a b}

expr {"a" "b"}

expr {"a"b}

expr {a + b + c + d + e + f + g + h + i + j + k + l + m + n}

expr {1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 + 11 + 12 + foo + 13 + 14 + 15 + 16 + 17}

expr {averyveryverylongbarewordthatgoesonandonandon + 1}

expr {1 + 2 + 3 + 4 + 5 + 6 + 7 + 8 + 9 + 10 11 + 12 + 13 + 14 + 15 + 16 + 17 + 18}

expr {truex}

expr {true}

expr {tru}

expr {yes}

expr {o}

expr {on}

expr {of}

expr {off}

expr {n}

expr {y}

expr {TRUE}

expr {!true}

expr {!"yes"}

expr {!abc}

expr {!"abc"}

expr {true && false}

expr {"abc" && 1}

expr {1 && "abc"}

expr {0 && "abc"}

expr {1 || "abc"}

expr {0 || "abc"}

expr {"" && 1}

expr {"abc" ? 1 : 2}

expr {"yes" ? 1 : 2}

expr {1 ? "a" : "b"}

expr {1.5 ? 1 : 0}

expr {0.0 ? 1 : 0}

expr {"0.0" ? 1 : 0}

expr {7/2}

expr {-7/2}

expr {7/-2}

expr {-7/-2}

expr {7%2}

expr {-7%2}

expr {7%-2}

expr {-7%-2}

expr {7.5%2}

expr {7%2.0}

expr {1/0}

expr {1%0}

expr {1/0.0}

expr {-1/0.0}

expr {0/0.0}

expr {0.0/0}

expr {1.0/0}

expr {0**0}

expr {0**-1}

expr {0.0**-1}

expr {2**-1}

expr {1**-5}

expr {-1**-5}

expr {(-1)**3}

expr {2**0.5}

expr {(-8)**(1/3.0)}

expr {2**1000}

expr {2**64}

expr {(-2)**63}

expr {(-2)**64}

expr {10**20}

expr {2.0**3}

expr {2**3.0}

expr {2**3**2}

expr {-2**2}

expr {2**100000000000}

expr {1<<3}

expr {1<<63}

expr {1<<64}

expr {1<<-1}

expr {1>>-1}

expr {-1>>100}

expr {5>>100}

expr {-8>>1}

expr {1<<0}

expr {1.0<<1}

expr {1<<1.0}

expr {0<<10000000000000}

expr {1<<10000000000000}

expr {5&3}

expr {5|3}

expr {5^3}

expr {~5}

expr {~5.0}

expr {~"abc"}

expr {-5&3}

expr {99999999999999999999&1}

expr {5&1.0}

expr {5|"a"}

expr {""+1}

expr {1+""}

expr {"a"+1}

expr {1+"a"}

expr {"a"*"b"}

expr {-"a"}

expr {+"a"}

expr {-""}

expr {- "08"}

expr {"08"+1}

expr {"0o9"+1}

expr {+5}

expr {+"5"}

expr {-"0x10"}

expr {- - 5}

expr {--5}

expr {+-+5}

expr {!!5}

expr {~~5}

expr {-9223372036854775808}

expr {-9223372036854775808 - 1}

expr {9223372036854775807 + 1}

expr {9223372036854775807 * 2}

expr {- -9223372036854775808}

expr {abs(-9223372036854775808)}

expr {99999999999999999999 / 7}

expr {-99999999999999999999 / 7}

expr {99999999999999999999 % 7}

expr {-99999999999999999999 % 7}

expr {99999999999999999999 * 99999999999999999999}

expr {99999999999999999999 - 99999999999999999998}

expr {99999999999999999999 > 1e10}

expr {99999999999999999999 == 1e20}

expr {100000000000000000000 == 1e20}

expr {9007199254740993 == 9007199254740992.0}

expr {9007199254740993 > 9007199254740992.0}

expr {99999999999999999999 + 1.5}

expr {1 < 2}

expr {"a" < "b"}

expr {"a" < 1}

expr {"10" < "9"}

expr {"10" < "9a"}

expr {"abc" == "ABC"}

expr {1 <= 1.0}

expr {"" < 1}

expr {"" == ""}

expr {" " == ""}

expr {1 in {1 2 3}}

expr {"1.0" in {1 2 3}}

expr {5 ni {1 2}}

expr {5 in "a \{"}

expr {"a" in "a"}

expr {1.0 + 2}

expr {0.1 + 0.2}

expr {1e300*1e10}

expr {-1e300*1e10}

expr {1e-300*1e-300}

expr {1e400}

expr {Inf}

expr {-Inf}

expr {NaN}

expr {Inf - Inf}

expr {Inf + 1}

expr {Inf == Inf}

expr {nan == nan}

expr {"NaN" + 1}

expr {"Inf" + 1}

expr {infinity}

expr {inf < 5}

expr {1.0}

expr {1e5}

expr {1e15 + 0}

expr {1e16 + 0}

expr {1e17 + 0}

expr {123456789012345678.0}

expr {.5}

expr {5.}

expr {.}

expr {-0.0}

expr {0.0 * -1}

expr {1e-5 + 0}

expr {0.0001 + 0}

expr {0.00001 + 0}

expr {3.0e8 + 0}

expr {1.0e+20 + 0}

expr {abs(-5)}

expr {abs(5.5)}

expr {abs(-0.0)}

expr {abs("x")}

expr {abs("")}

expr {acos(2)}

expr {acos(0.5)}

expr {asin(1)}

expr {atan(1)}

expr {atan2(1,2)}

expr {atan2(0,0)}

expr {bool(5)}

expr {bool("abc")}

expr {bool("off")}

expr {ceil(1.2)}

expr {ceil(-1.2)}

expr {ceil(5)}

expr {cos(0)}

expr {cosh(1)}

expr {double(5)}

expr {double("a")}

expr {double("5")}

expr {entier(5.7)}

expr {entier(1e30)}

expr {entier("a")}

expr {exp(1)}

expr {exp(1000)}

expr {floor(1.7)}

expr {floor(-1.2)}

expr {fmod(7,3)}

expr {fmod(7.5,2)}

expr {fmod(-7.5,2)}

expr {fmod(1,0)}

expr {hypot(3,4)}

expr {int(5.9)}

expr {int(-5.9)}

expr {int(1e20)}

expr {int(3e9)}

expr {int("abc")}

expr {int("5.5")}

expr {int(99999999999999999999)}

expr {int(Inf)}

expr {int(NaN)}

expr {isqrt(17)}

expr {isqrt(-1)}

expr {isqrt(99999999999999999999)}

expr {isqrt(16.7)}

expr {log(10)}

expr {log(0)}

expr {log(-1)}

expr {log10(100)}

expr {log10(0.001)}

expr {max(1,2.5,2)}

expr {max(1,2)}

expr {max("a",2)}

expr {min(1,2.5,-2)}

expr {min(3)}

expr {max(2,2.0)}

expr {max(2.0,2)}

expr {pow(2,3)}

expr {pow(2,-1)}

expr {pow(0,-1)}

expr {pow(-8,1/3.0)}

expr {round(2.5)}

expr {round(-2.5)}

expr {round(3.5)}

expr {round(5)}

expr {round(1e20)}

expr {round(0.49999999999999994)}

expr {round("abc")}

expr {round(Inf)}

expr {sin(1)}

expr {sinh(1)}

expr {sqrt(2)}

expr {sqrt(-1)}

expr {sqrt("abc")}

expr {sqrt(16)}

expr {tan(1)}

expr {tanh(1)}

expr {wide(5.5)}

expr {wide(1e20)}

expr {wide("a")}

expr {srand(42)}

expr {srand(42); rand()}

expr {srand(42)}; expr {rand()}

expr {srand(0)}

expr {srand(1)}; list [expr {rand()}] [expr {rand()}] [expr {rand()}]

expr {srand(12345)}; set l {}; for {set i 0} {$i<5} {incr i} {lappend l [expr {rand()}]}; set l

expr {srand(2147483647)}

expr {srand(-5)}

expr {srand(99999999999)}

expr {srand("a")}

set x 5; expr $x*2

set x 5; expr {$x*2}

set x "5 + 5"; expr $x*2

set x "5 + 5"; expr {$x*2}

set x -5; expr $x**2

set x -5; expr {$x**2}

set x -5; expr 3-$x

set x -5; expr 3 - $x

set x abc; expr {$x eq "abc"}

set x abc; expr $x eq "abc"

set x abc; expr {"$x" eq "abc"}

set x {a b}; expr {$x eq "a b"}

set x {a b}; expr $x eq "a b"

expr {[llength {a b}] + 1}

expr [llength {a b}]+1

expr {"[llength {a b}]"}

expr {{a b} eq "a b"}

expr {$nosuch + 1}

expr {1 || $nosuch}

expr {0 && $nosuch}

expr {1 ? 5 : $nosuch}

expr {[nosuch]}

set a(1) 5; expr {$a(1)+1}

set a(x) 5; set i x; expr {$a($i)+1}

expr {$a(nosuch)}

expr {$a}

expr {1 ? 2 ? 3 : 4 : 5}

expr {0 ? 2 : 0 ? 3 : 4}

expr {1+2*3-4/2%3}

expr {1<2==1}

expr {1|2^3&4}

expr {5 == 5 && 3 < 4 || 0}

expr {2+3<<1}

expr {!0 && !1}

expr {-3 % 5}

expr {~0}

expr {1<2<3}

expr {3>2>1}

expr {"a" ne "b"}

expr {1 ? [set q 5] : [set q 6]}; set q

expr "1 + \
 2"

expr {1 + \
 2}

expr {
  1
  +
  2
}

expr {(1+2)*(3+4)}

expr {((((5))))}

expr {1e3 == 1000}

expr {1E3}

expr {0X1F}

expr {0B11}

expr {0O17}

expr {010}

expr {0}

expr {00}

expr {007}

expr {09.5}

expr {08.0}

expr {"010" + 0}

expr {0b11 + 0o17 + 0x1f}

expr {1_000}

expr {int(1.0) == 1}

expr {double(1) / 3}

expr {1 / 3 * 3}

expr {1.0 / 3 * 3}

expr {100 * 1.1}

expr {1.1 + 2.2}

expr {1e21 + 1}

expr {123456.789e3}

expr {5 ? "a b" : {c d}}

expr {{}}

expr {"" eq {}}

expr {"a$x"}

expr {"\x41"}

expr {{\x41}}

expr {"[" eq "["}

expr {$x ? 1 : }

tcl::mathop::+ 1 2 3

tcl::mathop::+

tcl::mathop::- 5

tcl::mathop::- 5 2 1

tcl::mathop::-

tcl::mathop::* 2 3

tcl::mathop::/ 2

tcl::mathop::/ 7 2

tcl::mathop::/ 7.0 2

tcl::mathop::** 2 3 2

tcl::mathop::% 7 3

tcl::mathop::% 7

tcl::mathop::== 1 1.0 1

tcl::mathop::< 1 2 3

tcl::mathop::< 1 3 2

tcl::mathop::<

tcl::mathop::eq a a

tcl::mathop::ne a

tcl::mathop::in a {a b}

tcl::mathop::! 1

tcl::mathop::! a

tcl::mathop::~ 5

tcl::mathop::<< 1 4

tcl::mathop::& 7 3

tcl::mathop::| 1 2

tcl::mathop::^ 1 3

tcl::mathop::+ a 1

tcl::mathfunc::sin 1

tcl::mathfunc::max 1 2 3

tcl::mathfunc::max

tcl::mathfunc::sin

tcl::mathfunc::sin 1 2

tcl::mathfunc::int abc

namespace eval tcl::mathfunc {proc twice x {expr {$x*2}}}; expr {twice(4)}

proc tcl::mathfunc::noarg {} {return 5}; expr {noarg() + 1}

set tcl_precision 6; set r <[expr {1.0/7}]>; set tcl_precision 0; set r

set tcl_precision 17; set r [expr {1.0/7}]; set tcl_precision 0; set r

set tcl_precision 3; set r <[list [expr {1e10/3}] [expr {1e-10/3}] [expr {2.0*3}] [expr {1e20*1.23456}]]>; set tcl_precision 0; set r

set tcl_precision 12; set r <[list [expr {0.1+0.2}] [expr {100.0*1.1}] [expr {1e16*10}]]>; set tcl_precision 0; set r

set tcl_precision 99

set tcl_precision abc

set tcl_precision

incr i

unset -nocomplain i; incr i; incr i 5

set i abc; incr i

set i 1.5; incr i

set i 5; incr i 1.5

set i 5; incr i abc

set i 5; incr i -7

set i 9223372036854775807; incr i

set i 99999999999999999999; incr i

set i 0x10; incr i

set i 010; incr i

set i 08; incr i

set i " 5 "; incr i

set i ""; incr i

incr

incr i j k

incr nosuch(1)

set i 5; incr i(3)

set i 5; incr i 0xff
