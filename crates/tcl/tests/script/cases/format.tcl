format

format abc

format %d 5

format %d

format %5d|%-5d|%05d 42 42 42

format %+d 5

format "% d" 5

format %+d -5

format %d abc

format %d 1.5

format %d ""

format %d 0x1f

format %d 010

format %d 08

format %d 99999999999

format %ld 99999999999

format %lld 99999999999999999999

format %d 99999999999999999999

format %hd 70000

format %i 5

format %u -1

format %lu -1

format %llu -1

format %hu -1

format %x 255

format %X 255

format %#x 255

format %#X 255

format %#o 8

format %#b 5

format %o 8

format %b 5

format %08b 5

format %x -1

format %lx -1

format %llx -255

format %llx 99999999999999999999

format %#llx 255

format %5.3d 7

format %-8.3d| 7

format %08.3d 7

format %.0d 0

format %c 65

format %c 233

format %5c| 65

format %-5c| 65

format %c abc

format %s abc

format %5s| abc

format %-5s| abc

format %.2s abc

format %5.1s| abc

format %05s abc

format %s

format "%s %s" a

format "%s" a b c

format %% 

format %5%

format %z

format %y 5

format %

format %5

format "abc%"

format %f 1.5

format %f 1

format %f abc

format %f ""

format %.2f 3.14159

format %8.3f| 3.14159

format %-8.3f| 3.14159

format %08.3f 3.14159

format %+.1f 2.25

format %.0f 2.5

format %.0f 3.5

format %#.0f 3

format %e 12345.678

format %.2e 12345.678

format %E 0.00012

format %e 0

format %.0e 15

format %#.0e 15

format %g 0.0001

format %g 0.00001

format %g 123456

format %g 1234567

format %G 1e-10

format %.3g 3.14159

format %g 100

format %#g 100

format %.10g 0.1

format %g 1e100

format %10.4g| 3.14159

format %-10.4g| 3.14159

format %010.4g| -3.14159

format %g Inf

format %f -Inf

format %5.1f NaN

format %010f Inf

format %+g Inf

format %a 1.5

format %a 0.1

format %A 255.5

format %.2a 0.1

format %a 0

format %f 1e20

format %.20f 0.1

format %.15g 0.1

format %.17g 0.1

format %5.2f%% 12.345

format %*d 6 42

format %-*d| 6 42

format %*d -6 42

format %.*f 2 3.14159

format %*.*f 8 2 3.14159

format %*d x 5

format %*d 5

format {%2$s %1$s} a b

format {%2$s %2$s} a b

format {%3$s} a b

format {%0$s} a b

format {%1$s %s} a b

format {%s %1$s} a b

format {%2$*d} 5 6 7

format %d%s%f 1 a 2.5

format "a\tb%s" x

format %ls abc

format %lf 1.5

format %hf 1.5

format %lld 5

format %ll 5

format %hhd 5

format "%6.2f %6.2f" 1.005 -2.5

format %1.1f 0.25

format %1.1f 0.35

format %.3f 2.0005

format %.1e 0.95

format %.15f 1e-10

format %e 1e-320

format %g 5e-324

format %f 1.7976931348623157e308

format %d 1e3

format %d " 5 "

format %s {a b}

format {%s} "\{"

format %5s é

format %-5s| é

format {%-10s|%10s} ab cd

format %+5d|%+-5d| 3 3

format %+05d 3

format "% 05d" 3

format "%+ d" 3

format %++d 3

format %--5d| 3

format %0-5d| 3

format %-05d| 3

format %#5x| 10

format %#05x| 10

format %#-6x| 10

format %x 3000000000

format %d 3000000000

format %u 3000000000

format %ld 3000000000

format %d -3000000000

format %li 5

format %lo 8

format %Lf 1.5

format %qd 5

format %jd 5

format %td 5

format %zd 5

format %Ld 5

format %n 5

format %p 5

format %s%s a

scan

scan abc

scan 12 %d

scan 12 %d x; set x

scan "12 abc" "%d %s" a b; list $a $b

scan "12 3.5 abc" "%d %f %s"

scan abc %d

scan abc %d x

scan "" %d

scan "" %d x

scan 12abc %d%s a b; list $a $b

scan 0x1f %x

scan 1f %x

scan 0x1f %i

scan 017 %i

scan 0b101 %i

scan 0o17 %i

scan 17 %o

scan 101 %b

scan 0x %x

scan 0x %i

scan 08 %i

scan -12 %d

scan +12 %d

scan - %d

scan -12 %u

scan 4294967295 %u

scan 99999999999 %d

scan 99999999999 %ld

scan 99999999999999999999 %lld

scan 99999999999999999999 %ld

scan 99999999999999999999 %d

scan 3000000000 %d

scan 3.14 %f

scan 3.14 %d%f

scan 1e5 %f

scan 1e5x %f%s

scan 1.5e+ %f%s

scan .5 %f

scan 5. %f

scan . %f

scan abc %f

scan 1e %e%s

scan Inf %f

scan NaN %f

scan -1.5 %g

scan "  12" %d

scan "a b" %c%c%c

scan abc %c

scan abc %3c

scan abc %s

scan "abc def" %2s%s

scan "abc def" %2s%*s%s

scan abc %1d

scan 12345 %2d%3d

scan 12345 %2d%d

scan "12,34" %d,%d

scan "12;34" %d,%d

scan "12" %d,%d

scan "12," %d,%d a b

scan "abc123" {%[a-z]%d}

scan "abc123" {%[^0-9]%d}

scan "abc]d" {%[]abc]%s}

scan "a-b" {%[a-]%s}

scan "123" {%[a-z]}

scan "123" {%[a-z]} x

scan "abc" {%[a-z}

scan "abc" {%2[a-z]%s}

scan "12 34" {%2$d %1$d}

scan "12 34" {%2$d %1$d} a b; list $a $b

scan "12 34" {%1$d %1$d} a

scan "12 34" {%1$d %d} a b

scan "12 34" {%3$d} a b

scan "12 34" {%0$d} a b

scan "12 34" "%d %d" a

scan "12 34" "%d" a b

scan "12" "%d %d" a b

scan "12 34" "%*d %d"

scan "12 34" "%*d %d" a; set a

scan "12ab" %d%n

scan "12ab" %d%n a b; list $a $b

scan "%" %%

scan "%5" %%%d

scan "5%" %d%%

scan 12 %y

scan 12 %

scan 12 %z

scan 12 "abc"

scan abc abc

scan "12 abc 5.5 x" "%d abc %f x"

scan "a b c" "%s %s %s %s"

scan "a b c" "%s %s %s %s" a b c d

scan "10:20:30" %d:%d:%d h m s; list $h $m $s

scan 1.0e-3 %lf

scan "abc" %ls

scan 12 %hd

scan 12 %lld

scan 123456789012345678901234567890 %llx

scan -5 %llu

scan 010 %d

scan 1_000 %d%s

scan "é" %c

scan "x=1.5 y=2" "x=%f y=%d"

scan "12" " %d"

scan " 12 " "%d "

scan "\n\t12" %d

scan 5 %f

scan 0x10 %f

scan 1e400 %f

scan "foo bar" "%s bar"

scan "foo baz" "%s bar%n" a b

scan 12 %d%d

scan 12 %d%d a b

scan 12 {%d %[a-z]}
